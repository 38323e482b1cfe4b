//! Of joints on curves.

pub(crate) fn curve_of_others(joint: &str, argument: &str) -> String {
    format!(
        "`{argument}` of `{joint}` is a function of `{joint}.parameter` and of parameters: the curve belongs to its first place and does not change; \
         put that place on what moves instead"
    )
}

pub(crate) fn curve_with_corner(joint: &str, argument: &str, function: &str) -> String {
    format!(
        "`{argument}` of `{joint}` has a corner by `{function}`, where its point would have no velocity: write a smooth function, or a `table` by a \
         spline"
    )
}

pub(crate) fn curve_by_choice(joint: &str, argument: &str, function: &str) -> String {
    format!(
        "`{argument}` of `{joint}` goes over from one function to another by `{function}`, where its point could jump or have no velocity: write one \
         smooth function, such as `smoothstep`, or a `table` by a spline"
    )
}

pub(crate) fn curve_is_a_point(joint: &str) -> String {
    format!(
        "neither `x` nor `y` of `{joint}` changes with `{joint}.parameter`: the curve is a point, which a `revolute` holds"
    )
}
