//! Texts of the messages about the assembled mechanism: what is wrong, why, with numbers, and what to write instead.

mod closing;
mod freedoms;

pub use closing::*;
pub use freedoms::*;

use crate::messages::number;
use crate::numbers::coordinate;

/// Units of the state in SI.
pub fn never_steady(name: &str, z: f64, rate: f64) -> String {
    format!(
        "`{name}` comes to rest nowhere near {}: its rate there is {} per second and does not depend on it, or only as another's does. \
         Give it a start value instead",
        number(z),
        number(rate)
    )
}

/// The same.
pub fn not_settled(name: &str, steps: usize, z: f64, rate: f64) -> String {
    format!(
        "no steady value of `{name}` was found in {steps} steps of Newton's method: the last was {} with a rate of {} per second. Begin \
         nearer to it, `state {name} … = value;`, or leave it out of `steady`",
        number(z),
        number(rate)
    )
}

/// Joints tie modes to one another.
pub fn static_and_held(body: &str, mode: &str) -> String {
    format!(
        "`{body}` cannot start as its loads bend it: its joints do not let `{body}.{mode}` bend by itself, because they hold more than the \
         `free` motion of its frame. Write shapes that keep what is held (`clamped`, `static` or `pinned`), or leave `{body} = static` out"
    )
}

/// `start` ties modes to what it states.
pub fn static_and_stated(body: &str, mode: &str, stated: &[String]) -> String {
    let stated: Vec<String> = stated.iter().map(|stated| format!("`{stated}`")).collect();
    format!(
        "`{body}` cannot start as its loads bend it: with {} as `start` states it and the joints closed, `{body}.{mode}` does not bend by \
         itself. Make that a guess (`~` in place of `=`), or leave `{body} = static` out",
        list(&stated)
    )
}

/// m or rad.
pub fn no_static(body: &str, mode: &str, steps: usize, found: f64) -> String {
    format!(
        "no static deflection of `{body}` was found in {steps} steps of Newton's method: `{body}.{mode}` came to {}. Loads that it cannot bear, \
         such as a thrust beyond Euler's load with `stiffening`, have none: make it stiffer, or leave `{body} = static` out",
        number(found)
    )
}

/// s.
pub fn unstable_state(name: &str, time: f64) -> String {
    format!(
        "`{name}` leaves where it starts by itself, e-fold in {} s: is the sign of its rate right? If so write \
         `#[allow(unstable_state)]` before it",
        number(time)
    )
}

/// Whose argument lies where, at the start or along the motion, and where the knots do, in the units of the table.
pub fn outside_table(
    of: &str,
    table: &str,
    argument: &str,
    [from, to]: [String; 2],
    [first, last]: [String; 2],
) -> String {
    let asked = if from == to {
        format!("for {from} at the start")
    } else {
        format!("for {from} to {to} along the motion")
    };
    format!(
        "`{of}` asks `{table}` {asked}, and its knots of `{argument}` go from {first} to {last}: what lies outside is continued and was not \
         measured. Add knots, or write `#[allow(outside_table)]` before it"
    )
}

/// N.
pub fn cord_that_pushes(name: &str, tension: f64) -> String {
    format!(
        "the cord \"{name}\" would have to push at the start: its tension is {} N. Hang it otherwise, start elsewhere or faster, or \
         write `distance` for a rod that can push",
        number(tension)
    )
}

/// `others`: those that are.
pub fn not_independent(of: &str, others: &[&str]) -> String {
    let instead = match others {
        [] => "leave it out of `independent`".to_string(),
        [only] => format!("write `options {{ independent = {only}; }}`"),
        several => format!("write `options {{ independent = ({}); }}`", several.join(", ")),
    };
    format!(
        "\"{of}\" cannot be independent: the constraints and the coordinates before it already fix it at the start \
         position; {instead}"
    )
}

pub fn no_value_at_start(of: &str) -> String {
    format!(
        "\"{of}\" has no value at the start: a number in what it is made of is too large or too small, a divisor is zero, \
         or a function is not defined there"
    )
}

pub fn driver_against_rest(driver: &str, quantity: &str, value: f64, miss: f64, unit: &str) -> String {
    format!(
        "the driver \"{driver}\" wants {quantity} at {} at time zero, which the joints and the conditions of \
         `start` do not allow: the nearest position found misses by {} {unit}. Let the law begin where `start` is, or make the \
         condition in `start` a guess (`~` instead of `=`)",
        coordinate(value, 5),
        number(miss)
    )
}

pub fn counted_and_cut(joint: &str) -> String {
    format!(
        "the turns of \"{joint}\" are counted, because a law, driver, coupling or screw uses its angle, and in space only the \
         angle of a joint that carries a body can be; name another joint in `options {{ cut = … }}`, or use an angle of \
         a joint outside of this loop"
    )
}

pub fn curve_in_absolute(joint: &str) -> String {
    format!(
        "the curve of \"{joint}\" is no graph, so its parameter is a coordinate, which absolute coordinates do not have; write `coordinates = tree`, or \
         leave `x` out so that the parameter is x itself"
    )
}

pub fn curve_closes_a_loop(joint: &str) -> String {
    format!(
        "\"{joint}\" closes a loop, and its curve is no graph: its parameter is a coordinate only where a body hangs on the curve. Leave `x` out, so that \
         the parameter is x itself, or join the point to a body of its own that is on the curve, a small roller"
    )
}

pub fn curve_stands(joint: &str, parameter: f64) -> String {
    format!(
        "the curve of \"{joint}\" stands still where its parameter is {parameter}: the point could not move there (a cusp, or a parameter that slows down \
         to rest). Start at another parameter, or let the parameter grow with the length of the curve"
    )
}

pub fn curve_without(joint: &str, argument: &str, what: &str, parameter: f64) -> String {
    format!(
        "`{argument}` of \"{joint}\" has no {what} at the start, where `{joint}.parameter` is {}: start at another parameter, or write a function \
         that has one there",
        number(parameter)
    )
}

pub fn counted_and_yielding(joint: &str) -> String {
    format!(
        "the turns of \"{joint}\" are counted, because a law, driver or coupling uses its angle, and in space only the angle of a joint \
         that carries a body can be; \"{joint}\" yields: leave its `penalty` out, or use another angle"
    )
}

pub fn not_counted_in_absolute(joint: &str) -> String {
    format!(
        "the turns of \"{joint}\" are counted, which absolute coordinates in space can do only for one axis that is known at \
         expansion; write `coordinates = tree`"
    )
}

pub fn flipped(of: &str) -> String {
    format!(
        "\"{of}\" can only be assembled the wrong way round (turned by 180 degrees): guess the angles of its bodies in \
         `start`, or state its `angle`"
    )
}

/// `guessed`: there are guesses, and they are about as far from one as from the other.
pub fn second_assembly(joint: &str, angle: &str, nearest: f64, next: f64, guessed: bool) -> String {
    let (nearest, next) = (coordinate(nearest, 5), coordinate(next, 5));
    let (which, write) = match guessed {
        true => (
            "the guesses of `start` are about as far from one as from the other",
            "Guess closer, or write one of these in place of the guesses",
        ),
        false => ("`start` does not say which", "Write one of these in `start`"),
    };
    format!(
        "there are two ways to assemble this mechanism, and {which}: \"{joint}\" can be at \
         {nearest} rad or at {next} rad. {write}: `{angle} [rad] ~ {nearest};` or \
         `{angle} [rad] ~ {next};`"
    )
}

pub fn second_assembly_unnamed() -> String {
    "there are two ways to assemble this mechanism, and `start` does not say which: guess a travel or a place with `~`"
        .to_string()
}

pub fn rates_conflict(asked: Option<String>, miss: f64) -> String {
    let what = asked.map_or("the constraints".to_string(), |asked| format!("the rate asked of \"{asked}\""));
    format!(
        "no velocities meet all rates of `start`: {what} is missed by {} (SI). The constraints already tie \
         these rates together: state fewer",
        number(miss)
    )
}

pub fn massless(body: &str, velocity: &str) -> String {
    format!(
        "\"{body}\" has no mass or inertia where it needs one: {velocity} is neither carried by any mass nor held by \
         the constraints, so its acceleration is undetermined. Give \"{body}\" a positive mass and inertia, or a joint \
         that holds it"
    )
}

/// `a`, `a and b`, `a, b and c`.
pub(in crate::check) fn list(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

fn freedoms(count: usize) -> String {
    format!("{count} {}", if count == 1 { "degree of freedom" } else { "degrees of freedom" })
}

/// An elimination that is too long to be written out.
pub struct Oversize {
    pub velocities: usize,
    pub rows: usize,
    /// Entries of M's lower triangle.
    pub mass: usize,
    pub operations: usize,
    pub most: usize,
    /// Whose rows have how many velocities, the most first.
    pub densest: Vec<(String, usize)>,
    /// Coordinates in which it would do.
    pub other: Option<(&'static str, usize)>,
}

pub fn long_ways(deepest: &str, depth: usize, on_ways: usize, most: usize) -> String {
    format!(
        "too many bodies hang on one another: `{deepest}` is number {depth} on its way from the ground, and the ways of all bodies \
         have {on_ways} together, more than {most}, each an entry of the mass matrix; hold long chains to the ground in \
         between, or split them into mechanisms of fewer bodies"
    )
}

pub fn oversize(name: &str, size: &Oversize) -> String {
    let Oversize { velocities, rows, mass, operations, most, densest, other } = size;
    // Most of the fill comes from where most is full already.
    let widest = densest.first().map_or(0, |(_, count)| *count);
    let of_rows: usize = densest.iter().map(|(_, count)| count).sum();
    let cause = if of_rows >= *mass && widest > 0 {
        let shown: Vec<String> =
            densest.iter().take(3).map(|(of, count)| format!("\"{of}\" ({count})")).collect();
        format!("the rows with most velocities are those of {}", shown.join(", "))
    } else {
        format!("its mass matrix alone has {mass} entries, because many bodies hang on one another")
    };
    let instead = match other {
        Some((coordinates, less)) => {
            format!("write `options {{ coordinates = {coordinates}; }}`, which takes about {less}")
        }
        None => "split it into mechanisms of fewer bodies, cut long ways from the ground with a joint in the middle, or let \
                 each equation name fewer coordinates"
            .to_string(),
    };
    format!(
        "\"{name}\" is too large to be written out: eliminating {velocities} velocities and {rows} rows takes about {operations} \
         operations, more than {most}; {cause}. The build would take minutes and gigabytes: {instead}"
    )
}

pub fn gap_never_changes(name: &str) -> String {
    format!(
        "joints hold both sides of `{name}` against each other, so its gap never changes and it does nothing: leave it out, or touch another body"
    )
}

/// A gap or depth, rad or mm.
fn length(size: f64, angle: bool) -> String {
    if angle { format!("{} rad", number(size)) } else { format!("{} mm", number(1e3 * size)) }
}

pub fn gap_is_held(name: &str, gap: f64, angle: bool) -> String {
    format!(
        "no motion that the joints allow changes the gap of `{name}`, which stays {}: leave it out, touch what moves, or write \
         `#[allow(no_effect)]` before it",
        length(gap, angle)
    )
}

pub fn never_parts(name: &str) -> String {
    format!(
        "`{name}` is closed at the start, and no motion that the joints allow opens it, so that no force of it could be known: leave it out, or \
         touch what moves"
    )
}

pub fn gap_is_driven(name: &str) -> String {
    format!(
        "drivers alone decide the gap of `{name}`, and where it closes no impulse of what is rigid stops them: leave it out, give it a law of its \
         depth, such as `kelvin_voigt`, or write `#[allow(no_effect)]` before it"
    )
}

pub fn friction_locks(name: &str, open: f64, passes: usize) -> String {
    let open = if open.is_finite() {
        format!("{} of what presses is open", number(open))
    } else {
        "there is none".to_string()
    };
    format!(
        "friction at `{name}` makes reactions that make more friction: somewhere along the motion the force that presses has no solution or two, or is not \
         found in {passes} passes, after which {open}. Lower coefficients or radii, take `dry`, which tells when it locks, raise `friction_passes`, or \
         write `#[allow(locks)]` before it"
    )
}

pub fn nothing_presses(name: &str) -> String {
    format!(
        "no reaction presses at `{name}`, wherever it is, so its friction does nothing: give it a `preload [N] = …` or a friction that does not depend on load, or \
         leave it out"
    )
}

pub fn never_closes(name: &str, least: f64, angle: bool) -> String {
    let least = length(least, angle);
    format!(
        "`{name}` never closes: all along the motion its gap stays above {least}. Bring what touches nearer, leave it out, or write \
         `#[allow(no_effect)]` before it"
    )
}

pub fn penetration(name: &str, depth: f64, angle: bool) -> String {
    let depth = length(depth, angle);
    format!(
        "at the start `{name}` is closed, by {depth}: it would push apart at once. Begin where it is open, or write \
         `#[allow(penetration)]` before it if what rests there is meant"
    )
}

pub fn rigid_inside(name: &str, depth: f64, angle: bool) -> String {
    let depth = length(depth, angle);
    format!(
        "at the start `{name}` is closed, by {depth}, and what is rigid is never inside: begin where it is open, or just touches"
    )
}

pub fn rigid_closing(name: &str, speed: f64, angle: bool) -> String {
    let unit = if angle { "rad/s" } else { "m/s" };
    format!(
        "at the start `{name}` touches and closes further, at {} {unit}: nobody can say whether the blow has been; begin with the speeds after \
         it, or where the contact is open",
        number(speed)
    )
}

pub fn starts_in_a_touch(name: &str, speed: f64, angle: bool) -> String {
    let unit = if angle { "rad/s" } else { "m/s" };
    format!(
        "at the start `{name}` touches already and closes further, at {} {unit}, and `speed = touch` is the speed with which a touch began, which nobody \
         can say here: begin where the contact is open, or state the speed, `speed [m/s] = 1`",
        number(speed)
    )
}

pub fn rigid_with_friction(friction: &str, name: &str) -> String {
    format!(
        "what the rigid `{name}` exerts at a touch is an impulse, in which only `dry` friction at the contact itself has a share: write that, \
         leave `{friction}` out, or give `{name}` a law of its depth, such as `hunt_crossley`"
    )
}

pub fn no_friction_time(name: &str) -> String {
    format!(
        "how quickly `{name}` brakes near rest does not follow: nothing presses it at the start, or it sticks, or its law depends on inputs or on what moves"
    )
}

/// `softer`: what makes it slower.
pub fn friction_too_quick(name: &str, time: f64, least: f64, pressed: f64, softer: &str) -> String {
    format!(
        "near rest `{name}`, pressed by {} N at the start, brakes within {} s, less than the {} s that are expected: make {softer}",
        number(pressed),
        number(time),
        number(least)
    )
}

/// `is_known`: whether its law is.
pub fn no_contact_time(name: &str, is_known: bool) -> String {
    if is_known {
        return format!(
            "how long a touch of `{name}` takes does not follow, since nothing moves its gap at the start, as where a pin stands in the middle of its hole: \
             begin a little beside that"
        );
    }
    format!(
        "how long a touch of `{name}` takes does not follow from its law: only of `kelvin_voigt`, `hunt_crossley`, `hertz` and `hertz_line`"
    )
}

pub fn contact_too_short(name: &str, time: f64, least: f64, mass: f64) -> String {
    format!(
        "a touch of `{name}` takes {} s with the {} kg (or kg m²) that it stops, less than the {} s that are expected: make it softer, or the \
         steps shorter, a twentieth of that",
        number(time),
        number(mass),
        number(least)
    )
}
