//! Of friction.

use super::number;

pub(crate) fn friction_without_joint() -> String {
    "friction acts in a joint or a contact: write `friction name: on(joint) = coulomb(coefficient = 0.2, radius [m] = 0.01, speed [rad/s] = 0.05);`"
        .to_string()
}

pub(crate) fn too_many_stick(most: usize) -> String {
    format!(
        "which of the joints with `dry` friction hold is found among all ways in which they may, of {most} coordinates at most, of which a pin or a \
         rail has one, a sleeve, a universal joint or a point on a plane two, and a ball or a face on a plane three: write `coulomb` or `lugre` where none has to stick"
    )
}

pub(crate) fn dry_beside_held(name: &str) -> String {
    format!(
        "held gates of contacts and the `dry` friction `{name}` of a joint cannot be in one mechanism yet: leave `contact = held` out, or write \
         `lugre` or `asperity` there"
    )
}

pub(crate) fn dry_beside_rigid(name: &str, rigid: &str) -> String {
    format!(
        "the `dry` friction `{name}` of a joint has no share in the impulses of rigid contacts such as `{rigid}` yet: give `{rigid}` a law of its \
         depth, such as `hunt_crossley(…)`, or write `lugre` or `asperity` here"
    )
}

pub(crate) fn rigid_here(rigid: &str) -> String {
    format!("`{rigid}` is rigid")
}

pub(crate) fn dry_in_c(name: &str) -> String {
    format!(
        "the functions in C take whole steps and do not find when `{name}` begins to stick or to slide within them: write `coulomb`, `lugre` or \
         `asperity` in place of `dry`"
    )
}

pub(crate) fn breakaway_below(most: f64, least: f64, sliding: &str) -> String {
    format!(
        "what holds is less than what slides: the breakaway {sliding}, {}, is below the {sliding} of sliding, {}; write the larger as `breakaway`",
        number(most),
        number(least)
    )
}

pub(crate) fn dry_on_what_yields(contact: &str) -> String {
    format!(
        "`dry` friction needs a rigid contact, whose touches are found within the step, and `{contact}` yields: write \
         `= rigid(restitution = …)` there, or `lugre` or `asperity` here, which hold what rests"
    )
}

pub(crate) fn dry_twice(contact: &str, other: &str) -> String {
    format!(
        "`{other}` is dry friction at `{contact}` already, and which of two of them holds cannot be known: write one, with the larger `static`"
    )
}

pub(crate) fn law_of_friction_alone(word: &str) -> String {
    format!("`{word}` is a law of friction: write `friction name: on(joint) = {word}(…);`")
}

pub(crate) fn no_bearing(joint: &str, kind: &str) -> String {
    format!(
        "no surfaces slide on each other in `{joint}`, a {kind} joint: friction acts in revolute, prismatic, cylindrical, spherical, universal, \
         constant_velocity, planar and screw joints and where a point slides along a line or curve or on a plane"
    )
}

pub(crate) fn bearing_of_particle(joint: &str) -> String {
    format!(
        "`{joint}` is a joint of a particle, which does not turn: its friction would do nothing; make it a body with inertia"
    )
}

pub(crate) fn knuckle_that_holds(name: &str, joint: &str) -> String {
    format!(
        "`{joint}` swings about two axes that turn with it, along which `{name}` would hold, and friction that sticks is not there yet: write \
         `lugre(…)` or `asperity(…)`, which hold but for a creep, or `coulomb(…)`"
    )
}

pub(crate) fn no_use_in_bearing(argument: &str, joint: &str, kind: &str) -> String {
    let why = match argument {
        "radius" => "slides along, and its friction is a force that no radius turns into a torque",
        "shoulder" => "has no shoulder that an axial force presses on",
        _ => "carries no moment by a length",
    };
    format!("the {argument} has no use: `{joint}`, a {kind} joint, {why}; leave `{argument}` out")
}

pub(crate) fn friction_by_torque(name: &str, joint: &str) -> String {
    format!(
        "`{joint}` turns, so that `{name}` resists with a torque: write `torque [N*m] = …` in place of `force`"
    )
}

pub(crate) fn friction_by_force(name: &str, joint: &str) -> String {
    format!(
        "`{joint}` slides along, so that `{name}` resists with a force: write `force [N] = …` in place of `torque`"
    )
}

pub(crate) fn friction_without_radius(name: &str, joint: &str, kind: &str) -> String {
    format!(
        "the friction `{name}` needs its radius: a force of μ N at the radius r makes the torque μ r N that `{joint}`, a {kind} joint, feels; \
         write `radius [m] = …`, or `torque [N*m] = …` for what does not depend on load"
    )
}

pub(crate) fn sleeve_without_radius(name: &str, joint: &str) -> String {
    format!(
        "the friction `{name}` needs its radius: the surfaces of `{joint}` slide along its axis with ẋ and about it with r ω, and a force of μ N resists \
         both; write `radius [m] = …`, or `force [N] = …` alone for what does not depend on load and resists ẋ"
    )
}

pub(crate) fn face_without_radius(name: &str, joint: &str) -> String {
    format!(
        "the friction `{name}` needs its radius: the surfaces of `{joint}` slide on each other with v along the plane and r ω about its axis, and a force \
         of μ N resists both; write `radius [m] = …`, two thirds of that of a round face, or `force [N] = …` alone for what does not depend on load and \
         resists v"
    )
}

pub(crate) fn thread_without_radius(name: &str, joint: &str) -> String {
    format!(
        "the friction `{name}` needs its radius: the thread of `{joint}` is as steep as its pitch on a turn at that radius, by which what carries the \
         load presses; write `radius [m] = …`, or `force [N] = …` alone for what does not depend on load"
    )
}

pub(crate) fn friction_of_nothing(name: &str, turns: bool, dry: bool) -> String {
    let own = if turns { "torque [N*m]" } else { "force [N]" };
    let share = if dry { "static" } else { "coefficient" };
    format!(
        "the friction `{name}` resists with nothing: write `{share} = …`, which the reaction of the joint is multiplied by, or `{own} = …`"
    )
}

pub(crate) fn no_use_in_contact(argument: &str, name: &str) -> String {
    let why = match argument {
        "preload" | "force" | "torque" | "breakaway" => {
            "a contact that is open resists with nothing, and one that is closed by its own force"
        }
        _ => "the force of a contact acts where its surfaces touch",
    };
    format!("the {argument} has no use in `{name}`: {why}; leave `{argument}` out")
}

pub(crate) fn contact_rubs_by_nothing(name: &str, share: &str) -> String {
    format!(
        "the friction `{name}` resists with nothing: write `{share} = …`, which the force of the contact is multiplied by"
    )
}

pub(crate) fn friction_without_slip(contact: &str, limits: bool) -> String {
    if limits {
        format!(
            "nothing slides where `{contact}` ends a range: write the friction of its joint, or a contact `gap(…, slip = …)`"
        )
    } else {
        format!(
            "`{contact}` does not say what slides: write `gap(…, slip = …)`, how far surfaces have slid, an expression of positions"
        )
    }
}

pub(crate) fn static_below_kinetic(most: f64, least: f64) -> String {
    format!(
        "what holds is less than what slides: the coefficient at rest, {}, is below that of sliding, {}; write the larger as `static`",
        number(most),
        number(least)
    )
}

pub(crate) fn quantity_of_friction(name: &str, quantities: &[&str]) -> String {
    let quantities: Vec<String> = quantities.iter().map(|quantity| format!("`{name}.{quantity}`")).collect();
    let word = if quantities.len() == 1 { "quantity" } else { "quantities" };
    format!("`{name}` has the {word} {}, and its power is `power({name})`", quantities.join(", "))
}

pub(crate) fn passes_of_friction(found: i64, most: usize) -> String {
    format!(
        "`friction_passes` is how often Newton's method is applied to the forces that press surfaces together, each time doubling the digits that are \
         right: from 1 to {most}, found {found}; 2 is usual"
    )
}

pub(crate) fn too_many_in_a_loop(count: usize, most: usize, names: &str) -> String {
    format!(
        "{count} frictions press on each other through their reactions ({names}), and what is written out grows with the cube of that: {most} are the \
         most; give some of them by `force` or `torque`, which do not depend on load"
    )
}
