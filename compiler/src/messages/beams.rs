//! Texts about beams.

use super::{closest, number};
use crate::beams::{Counts, Shapes, Theory, Way};
use crate::forms::{SECTIONS, Space, second_moments};
use crate::numbers::significant;

/// In backticks.
pub(crate) fn quoted_code(text: &str) -> String {
    format!("`{text}`")
}

fn capital(property: &str) -> String {
    if property == "young" { in_words(property).to_string() } else { format!("the {}", in_words(property)) }
}

fn in_words(property: &str) -> &str {
    match property {
        "young" => "Young's modulus",
        "shear_modulus" => "shear modulus",
        "torsion_constant" => "torsion constant",
        "shear_factor" => "shear factor",
        property => property,
    }
}

fn listed(words: impl Iterator<Item = &'static str> + Clone, asked: &str) -> String {
    match closest(asked, words.clone()) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None => format!("there are {}.", words.map(quoted_code).collect::<Vec<_>>().join(", ")),
    }
}

pub(crate) fn unknown_shapes(asked: &str) -> String {
    format!("no shapes called \"{asked}\"; {}", listed(Shapes::ALL.into_iter().map(Shapes::word), asked))
}

pub(crate) fn unknown_section(asked: &str, space: Space) -> String {
    let words = SECTIONS.iter().map(|(word, _)| *word);
    format!(
        "no section called \"{asked}\"; {} Or leave it out and write {}",
        listed(words, asked),
        stated(space)
    )
}

pub(crate) fn section_without(kind: &str, missing: &str) -> String {
    format!("a {kind} needs its {missing}: write `{missing} [mm] = …` in the parentheses")
}

pub(crate) fn unknown_modes(asked: &str, space: Space) -> String {
    let words = || Way::of(space).iter().map(|way| way.word(space));
    match (asked, space) {
        ("torsion" | "bending_y" | "bending_z", Space::Planar) => {
            format!("`{asked}` needs a beam in space; in the plane there are `axial` and `bending`")
        }
        ("bending", Space::Spatial) => {
            "a beam in space bends two ways: write `bending_y` for what moves along y, and `bending_z`"
                .to_string()
        }
        _ => format!("no modes called \"{asked}\"; {}", listed(words(), asked)),
    }
}

pub(crate) fn example_of_modes(space: Space) -> &'static str {
    match space {
        Space::Planar => "`(bending = 3)`, or `(axial = 1, bending = 3)`",
        Space::Spatial => {
            "`(bending_y = 2, bending_z = 2)`, or `(axial = 1, bending_y = 2, bending_z = 2, torsion = 1)`"
        }
    }
}

pub(crate) fn no_modes(space: Space) -> String {
    let bending = Way::Bending.word(space);
    format!("a beam without modes is a rod: write `({bending} = 3)`, or `rod` in place of `beam`")
}

pub(crate) fn modes_out_of_range(kind: &str, count: i64, most: usize) -> String {
    format!(
        "a beam has 0 to {most} {kind} modes, found {count}: higher ones are shorter than beam theory holds for; write fewer, or \
         divide the beam"
    )
}

pub(crate) fn unknown_theory(asked: &str) -> String {
    format!(
        "no theory of beams called \"{asked}\"; {}",
        listed(Theory::ALL.into_iter().map(Theory::word), asked)
    )
}

pub(crate) fn thick_and_static(beam: &str) -> String {
    format!(
        "`static` shapes are the deflections of beams that do not shear, and the beam `{beam}` has `theory = timoshenko`: write \
         `shapes = clamped;`, which are held at the start too"
    )
}

pub(crate) fn thick_not_known(beam: &str, property: &str) -> String {
    format!(
        "with `theory = timoshenko` the {} of the beam `{beam}` must be a number at expansion, because its shapes depend on it: write a `const`",
        in_words(property)
    )
}

pub(crate) fn nothing_to_shear(beam: &str, property: &str) -> String {
    format!(
        "the beam `{beam}` does not shear, which its {} would be for: write `theory = timoshenko;`, or leave `{property}` out",
        in_words(property)
    )
}

pub(crate) fn shear_factor_missing(beam: &str) -> String {
    format!(
        "the beam `{beam}` shears and has no section with a known shear factor: write `shear_factor = 0.83;`, that of its section (5/6 of a \
         rectangle, 0.9 of a circle, 0.5 of a thin tube)"
    )
}

pub(crate) fn shear_factor_out_of_range(beam: &str, value: f64) -> String {
    format!(
        "the shear factor of the beam `{beam}` must be above 0 and at most 1, found {}: it is the part of the section that carries shear",
        number(value)
    )
}

pub(crate) fn not_isotropic(beam: &str, ratio: f64) -> String {
    format!(
        "Young's modulus and the shear modulus of the beam `{beam}` are those of Poisson's ratio E/(2 G) - 1 = {}, and no isotropic \
         material has less than -1 or more than 0.5: correct one of them, or write the `shear_factor` of this section",
        significant(ratio, 3)
    )
}

pub(crate) fn beyond_cut_off(beam: &str, word: &str, asked: usize, below: usize) -> String {
    format!(
        "the beam `{beam}` has {asked} {word} modes, of which only {below} are below the frequency √(κ G A/(ρ I)) at which its sections shear by \
         themselves: write {}, or a thinner beam",
        if below == 0 { "`body`".to_string() } else { format!("`{word} = {below}`") }
    )
}

pub(crate) fn unknown_stiffening(asked: &str) -> String {
    format!(
        "stiffening is `on` or `off`, found \"{asked}\": with `on` bending draws the places of a beam in, so that a pull along it makes it \
         stiffer and a thrust softer"
    )
}

pub(crate) fn quadratic_and_free(beam: &str) -> String {
    format!(
        "quadratic axial shapes are held at the start, and the frame of the `free` shapes of the beam `{beam}` is in the middle: write \
         `shapes = pinned;`, `clamped` or `static`, or a number of axial modes"
    )
}

pub(crate) fn quadratic_across() -> String {
    "quadratic shapes are there along the axis alone, where two of them make up an element: write `axial = quadratic`, or a number of bending modes \
     and `shapes = static;`, which are polynomials"
        .to_string()
}

pub(crate) fn nothing_to_stiffen(beam: &str, space: Space) -> String {
    let bending = Way::Bending.word(space);
    format!(
        "the beam `{beam}` has no modes in bending, which a force along it could stiffen: write `modes = ({bending} = 3)`, or leave \
         `stiffening` out"
    )
}

pub(crate) fn nothing_to_twist(beam: &str, property: &str) -> String {
    format!(
        "the beam `{beam}` has no modes in torsion, which its {} would resist: write `modes = (bending_y = 3, bending_z = 3, torsion = 2)`, \
         or leave `{property}` out",
        in_words(property)
    )
}

pub(crate) fn marker_on_beam(beam: &str) -> String {
    format!(
        "a marker on the beam `{beam}` would have to turn with a section of it: write a `point` on its axis, where joints turn with the \
         section, or fix a body to the beam and give that the marker"
    )
}

pub(crate) fn line_on_beam(beam: &str) -> String {
    format!(
        "a line on the beam `{beam}` would have to bend with it, and a joint along it is not there: put the line on the other body"
    )
}

pub(crate) fn toothing_on_beam(beam: &str) -> String {
    format!(
        "teeth on the beam `{beam}` would have to turn with a section of it: fix a part to the beam and give that the toothing"
    )
}

pub(crate) fn surface_along_beam(surface: &str, place: &str) -> String {
    format!(
        "the surface `{surface}` goes on from `{place}`, which is on what bends, and would have to bend with it: give each place \
         along it a point, circle or sphere of its own, or fix a part to it and give that the surface"
    )
}

pub(crate) fn beam_first(joint: &str, kind: &str, place: &str) -> String {
    format!(
        "the joint `{joint}` takes its axes from its first place, and at `{place}` these would turn with the section of a beam, \
         which a {kind} joint cannot yet: let the beam be its second place"
    )
}

pub(crate) fn bushing_on_beam(place: &str) -> String {
    format!(
        "a bushing turns with its bodies, and at `{place}` a body that deforms has the direction of what is there: write `spring`, `damper` and \
         `torsion_spring` on joints"
    )
}

pub(crate) fn torque_on_beam(beam: &str) -> String {
    format!(
        "a torque on the beam `{beam}` bends it where it acts: let it act on a joint at one of its places, whose angle is that of the \
         section, or write `shapes = clamped;` or `static`, with which the beam has the direction of its start"
    )
}

pub(crate) fn beam_property_missing(beam: &str, property: &str, unit: &str) -> String {
    format!("the beam `{beam}` has no {}: write `{property} [{unit}] = …;`", in_words(property))
}

pub(crate) fn beam_without_section(beam: &str, space: Space) -> String {
    format!(
        "the beam `{beam}` has no section: write `section = circle(diameter [mm] = …);`, or {}",
        stated(space)
    )
}

/// What is written in place of a section.
fn stated(space: Space) -> String {
    let moments: Vec<String> =
        second_moments(space).iter().map(|word| format!("`{word} [mm^4] = …;`")).collect();
    format!("`area [mm^2] = …;` and {}", moments.join(" and "))
}

pub(crate) fn section_and_property(beam: &str, property: &str) -> String {
    format!("the {property} of `{beam}` follows from its section; leave one of them out")
}

pub(crate) fn length_not_known(beam: &str) -> String {
    format!(
        "the length of the beam `{beam}` must be a number at expansion, because its shapes are: write a `const`"
    )
}

pub(crate) fn point_not_known(beam: &str, point: &str) -> String {
    format!(
        "where `{point}` is on the beam `{beam}` must be a number at expansion, because the shapes there are: write a `const`"
    )
}

pub(crate) fn point_off_axis(beam: &str, point: &str, y: f64) -> String {
    format!(
        "`{point}` is {} m beside the axis of the beam `{beam}`, whose points are on it: write `(…, 0)`, or fix a body to it",
        number(y)
    )
}

pub(crate) fn point_beyond(beam: &str, point: &str, x: f64, from: f64, to: f64) -> String {
    format!(
        "`{point}` is at x = {} m, and the axis of the beam `{beam}` reaches from {} to {} m: its frame is {}",
        number(x),
        number(from),
        number(to),
        if from < 0.0 { "in its middle" } else { "at its start" }
    )
}

pub(crate) fn not_positive_of_beam(property: &str, beam: &str, value: f64) -> String {
    format!("{} of the beam `{beam}` must be positive, found {}", capital(property), number(value))
}

pub(crate) fn damping_ratio_negative(kind: &str, body: &str, value: f64) -> String {
    let kind = if kind == "beam" { kind } else { "flexible body" };
    format!("the damping ratio of the {kind} `{body}` must not be negative, found {}", number(value))
}

pub(crate) fn tube_inside_out(beam: &str, inner: f64, outer: f64) -> String {
    format!(
        "the tube of the beam `{beam}` has nothing between its diameters: inner {} m, outer {} m; write the smaller one as `inner`",
        number(inner),
        number(outer)
    )
}

pub(crate) fn modes_of_beam(body: &str, asked: &str, counts: Counts, space: Space) -> String {
    let kind = |word: &str, count: usize| match count {
        0 => None,
        1 => Some(format!("`{body}.{word}[0]`")),
        _ => Some(format!("`{body}.{word}[0]` to `{body}.{word}[{}]`", count - 1)),
    };
    let known = Way::of(space).iter().filter_map(|way| kind(way.word(space), counts.of(*way)));
    let known: Vec<String> = known.collect();
    format!("`{body}` has no mode `{asked}`; it has {}, each with `.rate`", known.join(" and "))
}

pub(crate) fn pinned_held(joint: &str, kind: &str, beam: &str) -> String {
    format!(
        "the {kind} joint `{joint}` holds the direction of the beam `{beam}`, whose `pinned` shapes carry no moment at their ends: \
         write `shapes = clamped;`, `static` or `free`"
    )
}

pub(crate) fn origin_of_beam(place: &str) -> String {
    format!(
        "`{place}` is the centre of mass of a beam with `free` shapes, which is no point of its axis once it bends: nothing can be attached \
         to it; write `center` for the middle of the axis"
    )
}

pub(crate) fn thick_beam(beam: &str, ratio: f64, least: f64) -> String {
    format!(
        "the beam `{beam}` is {} radii of gyration √(I/A) long; below {} shear and the turning of its sections, which Euler and Bernoulli's beam \
         leaves out, lower its frequencies. Write `theory = timoshenko;`, `body` for what hardly bends, or `#[allow(slender)]` before it",
        significant(ratio, 3),
        number(least)
    )
}

/// About which axis of the beam; whether the joint has one angle, which a motor could turn.
pub(crate) fn clamp_that_turns(
    beam: &str,
    shapes: &str,
    joint: &str,
    [kind, axis]: [&str; 2],
    has_angle: bool,
) -> String {
    let motor = if has_angle {
        format!("the motor of the joint, `torque motor: torque({joint}) = …;`, or ")
    } else {
        String::new()
    };
    let hinges = if axis == "x" { "" } else { "`pinned` where both ends are on hinges, or " };
    format!(
        "the `{shapes}` shapes of the beam `{beam}` are held at its start with their direction, and the {kind} joint `{joint}` lets that turn \
         freely about {axis} of the beam: no moment passes there, for which many of these shapes are needed. Write `shapes = free;`, or {hinges}\
         {motor}`#[allow(slender)]` before it"
    )
}

pub(crate) fn clamped_free_shapes(beam: &str, joint: &str) -> String {
    format!(
        "the `free` shapes of the beam `{beam}` bend as if nothing clamped it, and `{joint}` does: a few of them lack a third of how far a force at \
         the other end deflects it. Write `shapes = clamped;` or `static`, whose start is where it is clamped, or `#[allow(slender)]` before it"
    )
}

pub(crate) fn clamped_at_the_end(beam: &str, shapes: &str, joint: &str) -> String {
    format!(
        "the `{shapes}` shapes of the beam `{beam}` are clamped at its start, where nothing holds it, and `{joint}` clamps its end: let it begin there, \
         with `start` and `end` exchanged, or write `#[allow(slender)]` before it"
    )
}

/// At the start, or as a driver turns it after a time.
pub(crate) fn fast_beam(beam: &str, rate: f64, natural: f64, driven: Option<f64>) -> String {
    let [turns, when] = match driven {
        None => ["turns", "at the start"].map(str::to_string),
        Some(time) => ["is driven".to_string(), format!("after {} s", significant(time, 3))],
    };
    format!(
        "the beam `{beam}` {turns} at {} rad/s {when}, {} of its first clamped frequency, {} rad/s, and nothing stiffens it: it bends far too \
         much, and beyond that frequency without bound. Write `stiffening = on;`, or `#[allow(stiffening)]` before it",
        significant(rate, 4),
        significant(rate / natural, 2),
        significant(natural, 4)
    )
}

pub(crate) fn pressed_beam(beam: &str, thrust: f64, euler: f64) -> String {
    format!(
        "the joints of the beam `{beam}` press it together with {} N at the start, {} of Euler's load, {} N, and nothing makes it softer: it bends \
         too little, and does not buckle. Write `stiffening = on;`, or `#[allow(stiffening)]` before it",
        significant(thrust, 4),
        significant(thrust / euler, 2),
        significant(euler, 4)
    )
}

pub(crate) fn no_mode(asked: &str) -> String {
    format!(
        "`{asked}` is no mode of a body that deforms, which has a frequency by itself: write `frequency(coupler.bending[0]) >= 200 [Hz]`"
    )
}

/// Metres.
pub(crate) fn bent_too_far(mode: &str, found: f64, beam: &str, length: f64) -> String {
    format!(
        "`{mode}` starts at {} m, and `{beam}` is {} m long: what bends is off its axis by small parts of its length",
        number(found),
        number(length)
    )
}

pub(crate) fn frequency_missed(mode: &str, found: f64, above: bool, bound: f64) -> String {
    format!(
        "`{mode}` has {} Hz by itself, {} than the {} Hz expected: change the section, the length or the material, or the finite element model",
        significant(found, 6),
        if above { "less" } else { "more" },
        number(bound)
    )
}

pub(crate) fn no_place_of_beam(asked: &str) -> String {
    format!(
        "`{asked}` is on no beam, whose places are off its axis: write `deflection(arm.end) <= 3 [mm]` of a `beam arm`"
    )
}

pub(crate) fn deflection_missed(
    place: &str,
    beam: &str,
    found: f64,
    above: bool,
    bound: f64,
    bent: bool,
) -> String {
    let (than, bound) = (if above { "less" } else { "more" }, number(bound));
    let instead = if bent {
        "change the section, the length or the material".to_string()
    } else {
        format!(
            "write `start {{ {beam} = static; }}` for what its loads bend it by, or change its modes there"
        )
    };
    format!(
        "`{place}` is {} m off the axis of its frame at the start, {than} than the {bound} m expected: {instead}",
        significant(found, 6)
    )
}

pub(crate) fn static_of_nothing<'a>(asked: &str, bodies: impl Iterator<Item = &'a str>) -> String {
    match closest(asked, bodies) {
        Some(similar) => format!("no beam or flexible body called \"{asked}\"; did you mean \"{similar}\"?"),
        None => format!(
            "no beam or flexible body called \"{asked}\": only what deforms can start as its loads bend it"
        ),
    }
}

pub(crate) fn static_and_rigid(body: &str) -> String {
    format!("`{body}` is rigid, and nothing bends it: leave `{body} = static` out, or declare it as a `beam`")
}

pub(crate) fn stated_and_static(quantity: &str, body: &str) -> String {
    format!("`{quantity}` is stated, and `{body} = static` finds it: leave one of them out")
}
