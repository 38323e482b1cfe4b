//! Of loads that have internal states.

pub(crate) fn exponent_below_one(what: &str, found: f64) -> String {
    format!("the {what} must be at least 1, found {}: below it the way back has no end", super::number(found))
}

pub(crate) fn size_of_load(what: &str, load: &str, found: f64) -> String {
    format!("the {what} of `{load}` must be positive, found {}", super::number(found))
}

pub(crate) fn backbone_is_a_table() -> String {
    "a backbone is a table by its name: `backbone = bar`, with `table bar(way [mm]) [N] = [(0, 0), …], linear;`".to_string()
}

pub(crate) fn backbone_of_two(table: &str) -> String {
    format!("`{table}` is a grid, and a backbone is a table of one argument, the way")
}

pub(crate) fn backbone_of_curves(table: &str, kind: &str) -> String {
    format!(
        "a backbone goes straight from knot to knot, and `{table}` is `{kind}` between them: write `linear` behind its points"
    )
}

pub(crate) fn backbone_beside_origin(table: &str, knot: &str) -> String {
    format!("the backbone `{table}` does not go through the origin, at {knot}: begin it with (0, 0)")
}

pub(crate) fn backbone_not_odd(table: &str, knot: &str) -> String {
    format!(
        "the backbone `{table}` is not the same both ways, at {knot}: opposite ways have opposite values; or give it from (0, 0) on"
    )
}

pub(crate) fn backbone_convex(table: &str, knot: &str) -> String {
    format!("the backbone `{table}` gets steeper at {knot}: what yields gets less stiff from knot to knot")
}

pub(crate) fn backbone_falls(table: &str, knot: &str) -> String {
    format!(
        "the backbone `{table}` falls before {knot}: it rises from the origin, and from knot to knot less"
    )
}

pub(crate) fn backbone_straight(table: &str, knot: &str) -> String {
    format!(
        "nothing of the backbone `{table}` yields: it is straight up to {knot} and beyond; write `outside = hold` behind its points"
    )
}

pub(crate) fn state_of_load_taken(load: &str, name: &str) -> String {
    format!(
        "the load `{load}` has a state `{name}`, which is the name of another: call one of them otherwise"
    )
}
