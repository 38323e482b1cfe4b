//! Of surfaces, contacts, limits and their laws.

use super::{number, quoted};
use crate::forms::{Form, Space};

pub(crate) fn surface_of_other_space(word: &str, space: Space, known: &[&str]) -> String {
    let (here, other) = match space {
        Space::Planar => ("the plane", "space"),
        Space::Spatial => ("space", "the plane"),
    };
    format!("a `{word}` is a surface of {other}; in {here} there are {}", known.join(", "))
}

pub(crate) fn unknown_contact(word: &str) -> String {
    format!(
        "a contact is `between(surface, surface)` or, for any other geometry, `gap(expression)` of positions that is negative in \
         contact; found `{word}`"
    )
}

pub(crate) fn too_many_pairs(name: &str, count: usize, most: usize) -> String {
    format!(
        "`{name}` would be {count} contacts, which all stand in the code and are looked at in every step; there may be {most}: write those that can touch, as by \
         `repeat`"
    )
}

pub(crate) fn each_of_itself(name: &str) -> String {
    format!(
        "`{name}` is between surfaces among each other, and there is one of them: it has nothing to touch, so leave the contact out"
    )
}

pub(crate) fn each_of_one() -> String {
    "`each` goes over an index that is not known yet, as `each shoe[i].pad` does over `i`: this is one surface, so leave `each` out".to_string()
}

pub(crate) fn each_of_none(pattern: &str) -> String {
    format!("no surface `{pattern}` is declared in front of this contact, whatever its index is")
}

pub(crate) fn contact_by_penalty(name: &str, laws: &[&Form]) -> String {
    let laws: Vec<String> = laws.iter().map(|law| format!("`{}`", law.word)).collect();
    format!(
        "by a `penalty` a joint without play yields, and `{name}` is a contact: it has a law of its depth, one of {}",
        laws.join(", ")
    )
}

pub(crate) fn material_without(name: &str, property: &str) -> String {
    format!(
        "the material `{name}` has no `{property}`: a material is `{name} {{ modulus [Pa] = 207e9; poisson = 0.3; }}`"
    )
}

pub(crate) fn no_such_material<'a>(known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let there = if known.is_empty() {
        "none is declared; write `material steel { modulus [Pa] = 207e9; poisson = 0.3; }`".to_string()
    } else {
        format!("there are {}", known.join(", "))
    };
    format!("this is not the name of a material; {there}")
}

pub(crate) fn poisson_out_of_range(found: f64) -> String {
    format!("Poisson's number lies between -1 and 0.5, found {}", number(found))
}

pub(crate) fn one_of_words(known: &[&str]) -> String {
    let known: Vec<String> = known.iter().map(|word| format!("`{word}`")).collect();
    format!("this is a word: {}", known.join(", "))
}

pub(crate) fn surface_of_no_extent(name: &str) -> String {
    format!(
        "the ends of the surface `{name}` are one place, so it has no direction: give it two places apart, or make it a `point`"
    )
}

pub(crate) fn surface_of_two_bodies(name: &str, first: &str, second: &str) -> String {
    format!(
        "the places `{first}` and `{second}` of the surface `{name}` are of two bodies: a surface is of one body or of the ground"
    )
}

pub(crate) fn polygon_too_large(found: usize) -> String {
    format!("a polygon has at most 16 corners, found {found}: every step looks at all of its edges")
}

pub(crate) fn polygon_not_convex(at: &str) -> String {
    format!(
        "the polygon turns right or not at all at `{at}`: its corners go counter-clockwise and it is convex; write another shape as \
         several polygons, each with a contact"
    )
}

pub(crate) fn profile_is_a_table(argument: &str) -> String {
    format!(
        "`{argument}` of a profile is the name of a table of the angle: declare `table flank(turn [deg]) [mm] = [(0, 20), …, (360, 20)], periodic;` and \
         write `{argument} = flank`"
    )
}

pub(crate) fn roller_of_no_radius(name: &str, radius: f64) -> String {
    format!(
        "the roller of `{name}` has a radius of {} mm: it is positive, and left out for a knife edge",
        number(1e3 * radius)
    )
}

pub(crate) fn profile_of_two(table: &str) -> String {
    format!("`{table}` is a table of two arguments: the radius of a profile depends on the angle alone")
}

pub(crate) fn profile_not_closed(table: &str, period: Option<f64>) -> String {
    let found = match period {
        None => "does not repeat itself".to_string(),
        Some(period) => format!("repeats itself after {} degrees", number(period.to_degrees())),
    };
    format!(
        "`{table}` {found}: a profile comes round after a whole turn; let its knots go from 0 to 360 deg, and write `periodic` behind them"
    )
}

pub(crate) fn passes_of_profile(found: f64, most: f64) -> String {
    format!(
        "`refine` is how often the foot on the profile is made better, a whole number from 0 to {most}, found {}",
        number(found)
    )
}

pub(crate) fn profile_about_nothing(name: &str, angle: f64, radius: f64) -> String {
    format!(
        "the radius of `{name}` is {} mm at {} deg: a profile goes around its place, so that its radius is positive everywhere; add a `base`, \
         as `base [mm] = 20`",
        number(1e3 * radius),
        number(angle.to_degrees())
    )
}

pub(crate) fn roller_too_large(roller: &str, radius: f64, profile: &str, angle: f64, hollow: f64) -> String {
    format!(
        "`{roller}` has a radius of {} mm and does not reach into the hollow of `{profile}` at {} deg, which has {} mm: it would touch at two \
         places at once; make it smaller",
        number(1e3 * radius),
        number(angle.to_degrees()),
        number(1e3 * hollow)
    )
}

pub(crate) fn undercut_by_roller(name: &str, radius: f64, table: &str, angle: f64, hollow: f64) -> String {
    format!(
        "`{name}` has a roller of radius {} mm, and `{table}` is hollow at {} deg with a radius of curvature of {} mm: the roller would not follow \
         it there but touch at two places at once (undercutting); make the roller smaller than that, or the base larger",
        number(1e3 * radius),
        number(angle.to_degrees()),
        number(1e3 * hollow)
    )
}

pub(crate) fn surfaces_of_one_body(first: &str, second: &str) -> String {
    format!(
        "`{first}` and `{second}` are of one body, so the gap between them never changes: a contact is between two bodies, or a body and the ground"
    )
}

pub(crate) fn hole_too_small(hole: &str, outside: f64, inner: &str, inside: f64) -> String {
    let [hole, inner] = [hole, inner].map(quoted);
    format!(
        "{hole} has a radius of {} m and {inner}, which is in it, {} m: a hole is larger than its pin by the clearance",
        number(outside),
        number(inside)
    )
}

pub(crate) fn no_such_pair(first: &str, second: &str, space: Space) -> String {
    let known = match space {
        Space::Planar => {
            "a point or circle meets a half_plane, circle, hole, segment, polygon or profile; a segment or polygon meets a half_plane"
        }
        Space::Spatial => {
            "a point or sphere meets a plane, sphere, capsule, cylinder, ball_socket or bore; a capsule meets a plane or capsule, a disk_rim a plane"
        }
    };
    format!(
        "there is no closed form for the gap between {first} and {second}: {known}. Any other gap is an expression of positions, \
         `gap(…)`"
    )
}

pub(crate) fn never_touches(first: &str, second: &str) -> String {
    format!(
        "`{first}` and `{second}` have no thickness, so their gap is never below zero and they never touch: give one of them a radius"
    )
}

pub(crate) fn gap_that_stands() -> String {
    "this gap depends on no position, so nothing opens or closes it".to_string()
}

pub(crate) fn gap_at_no_place(name: &str) -> String {
    format!(
        "`{name}` has no `point`: where a gap is an expression or the end of a range, no place follows from it"
    )
}

pub(crate) fn slides_nowhere(name: &str) -> String {
    format!(
        "`{name}` does not say what slides, so it has no `sliding`: write `gap(…, slip = …)`, how far surfaces have slid, an expression of positions"
    )
}

pub(crate) fn slip_that_stands() -> String {
    "this slip depends on no position, so that nothing ever slides".to_string()
}

pub(crate) fn slip_of_no_length() -> String {
    "what slides goes with a gap that is a length: this one is none".to_string()
}

pub(crate) fn contact_of_itself(name: &str) -> String {
    format!(
        "the force of `{name}` depends on itself: its law may name its gap, its depth and how fast it closes"
    )
}

pub(crate) fn quantities_of_contact(name: &str, space: Space) -> String {
    let axes = match space {
        Space::Planar => "`.sliding`, `.point.x` and `.point.y`",
        Space::Spatial => "`.sliding.x`, `.point.x` and so on to `.z`",
    };
    format!("a contact has `{name}.gap`, `.depth`, `.closing`, `.force`, {axes}, and `power({name})`")
}

pub(crate) fn contact_by_quantity(name: &str, contact: &str) -> String {
    format!(
        "`{name}` cannot stand here: what `{contact}` is like follows from where its bodies are, so state or drive their angles, travels and \
         positions"
    )
}

pub(crate) fn play_of_joint(kind: &str, space: Space) -> String {
    let instead = match space {
        Space::Planar => {
            "a `revolute` has, `joint pin: revolute(place, place, play [mm] = 0.5, radius [mm] = 10) = hertz(…);`"
        }
        Space::Spatial => {
            "a `spherical` has, `joint ball: spherical(place, place, play [mm] = 0.5, radius [mm] = 10) = hertz(…);`"
        }
    };
    format!(
        "there is no short form of a `{kind}` with play; {instead}. Elsewhere surfaces with a gap between them and a `contact` say it"
    )
}

pub(crate) fn reaction_of_loose(joint: &str) -> String {
    format!(
        "`{joint}` has play and holds nothing by itself: its surfaces push with `{joint}.force`, at `{joint}.point`"
    )
}

pub(crate) fn play_of_nothing(name: &str) -> String {
    format!(
        "the play of `{name}` is the whole gap in which it moves freely, more than zero: leave it out where there is none"
    )
}

pub(crate) fn limit_without_room(from: f64, to: f64) -> String {
    format!("nothing lies between {} and {}: the lower end comes first", number(from), number(to))
}

pub(crate) fn hertz_without_radii() -> String {
    "Hertz' law needs the radii of curvature, so circles, spheres, holes or sockets, or one of these on a half-plane or plane; elsewhere \
     write `hunt_crossley(force [N] = …, depth [mm] = …, …)`, one point of the measured curve"
        .to_string()
}

pub(crate) fn no_dissipation() -> String {
    "nothing says what a blow loses: write `dissipation [s/m] = …`, where 0 is elastic, or `restitution = 0.8, speed [m/s] = 1`".to_string()
}

pub(crate) fn two_dissipations() -> String {
    "the dissipation follows from the restitution: write one of them".to_string()
}

pub(crate) fn belongs_to_restitution() -> String {
    "`speed` and `damping` say how a dissipation follows from a `restitution`: beside `dissipation` they say nothing".to_string()
}

pub(crate) fn restitution_out_of_range(found: f64) -> String {
    format!(
        "a coefficient of restitution lies between 0 and 1, found {}: what comes back is a share of what arrives",
        number(found)
    )
}

pub(crate) fn restitution_without_speed() -> String {
    "the force of this law is not linear, so its restitution is that of one impact speed: write `speed [m/s] = 1` beside it".to_string()
}

pub(crate) fn restitution_too_small(found: f64) -> String {
    format!(
        "a restitution of {} needs a dissipation times speed above 20: the first touch would be the whole blow; write `kelvin_voigt` with \
         its stiffness and damping",
        number(found)
    )
}

/// `rigid`: a contact beside which gates cannot be held.
pub(crate) fn speed_of_touch(rigid: Option<&str>) -> String {
    match rigid {
        None => "`speed = touch` needs `options { contact = held; }`, where each touch is found and its speed kept; or state the speed that is expected, \
                 `speed [m/s] = 1`"
            .to_string(),
        Some(rigid) => format!(
            "`speed = touch` needs held gates, which beside `{rigid}`, a rigid contact, what yields does not have yet: state the speed that is expected, \
             `speed [m/s] = 1`"
        ),
    }
}

pub(crate) fn touches_at_several(name: &str, gaps: usize) -> String {
    format!(
        "`{name}` may touch at {gaps} places one after the other, each with a speed of its own: write a contact for each place, as of points or \
         circles, or state the speed that is expected, `speed [m/s] = 1`"
    )
}

pub(crate) fn slowest_of_one_speed() -> String {
    "`slowest` is the least that counts where each touch has its own speed, `speed = touch`; where one is stated, leave it out".to_string()
}

pub(crate) fn keeps_no_speed(name: &str) -> String {
    format!(
        "`{name}` keeps no speed: a contact does whose law is told `speed = touch` beside its `restitution`; `{name}.closing` is how fast it closes now"
    )
}

pub(crate) fn hertz_line_without_radii(space: Space) -> String {
    match space {
        Space::Planar => {
            "`hertz_line` is of cylinders that lie along each other, here two circles, or a circle in a hole: on what is flat the approach of a line \
             contact grows with the depth of the body and has no value; write `hunt_crossley(force [N] = …, depth [mm] = …, …)`, one point of the \
             measured curve"
        }
        Space::Spatial => {
            "`hertz_line` is of cylinders that lie along each other, which in space no pair of surfaces holds to: write `hertz(…)` of what touches at a \
             point, or `hunt_crossley(force [N] = …, depth [mm] = …, …)`, one point of the measured curve"
        }
    }
    .to_string()
}

pub(crate) fn holds_nothing() -> String {
    "gates of contacts are held here, but nothing touches: declare a `contact` or a `limit`, or leave this line out".to_string()
}

pub(crate) fn held_in_c() -> String {
    "the functions in C take whole steps and locate no touch within them, so that held gates would open and close late: write \
     `contact = live`"
        .to_string()
}

pub(crate) fn release_out_of_range(found: f64) -> String {
    format!("`release` is the share of the damping that acts on the way out, 0 to 1, found {}", number(found))
}

pub(crate) fn contact_pulls(what: &str, found: f64) -> String {
    if found == 0.0 {
        return format!("a contact that yields needs a `{what}` above zero");
    }
    format!("a contact pushes: its `{what}` cannot be {}", number(found))
}

pub(crate) fn rest_not_positive(found: f64) -> String {
    format!(
        "what would part more slowly than `rest` does not bounce: it is a speed above zero, found {}; leave it out, and what bounces ever less \
         rests where no flight is left",
        number(found)
    )
}

pub(crate) fn rigid_without_restitution() -> String {
    "a rigid contact parts with a share of the speed with which it meets: write `restitution = 0.5`; say `restitution = 0` if it does not \
     bounce"
        .to_string()
}

pub(crate) fn strikes_nothing(word: &str) -> String {
    format!(
        "`impact = {word}` says how rigid contacts part, and no contact is rigid here: write `= rigid(restitution = 0.5)` for one, or leave this \
         line out"
    )
}

pub(crate) fn rigid_and_live(rigid: &str) -> String {
    format!(
        "`{rigid}` is rigid, and a touch of it is found within the step: its gates are held; leave `contact = live` out, or give `{rigid}` a law \
         of its depth, such as `kelvin_voigt`"
    )
}

pub(crate) fn rigid_in_c(rigid: &str) -> String {
    format!(
        "the functions in C take whole steps and locate no touch within them, and `{rigid}` is rigid; give it a law of its depth, such as \
         `kelvin_voigt`"
    )
}

pub(crate) fn rigid_and_held(rigid: &str, other: &str) -> String {
    format!(
        "beside `{rigid}`, which is rigid, the gates of what yields as `{other}` does cannot be held yet: leave `contact = held` out, or make \
         both rigid"
    )
}
