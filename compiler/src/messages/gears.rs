//! Of toothings and the pairs that mesh.

use super::number;
use crate::forms::Rim;

/// With as many digits as it takes to write it into a definition.
fn exact(value: f64) -> String {
    crate::numbers::significant(value, 9)
}

/// Lengths are shown in mm.
fn mm(value: f64) -> String {
    exact(1e3 * value)
}

// ---- One toothing -------------------------------------------------------------------------------------------------

pub(crate) fn toothing_of_particle(body: &str) -> String {
    format!(
        "the particle `{body}` has no orientation, so it carries no teeth: write `body` or `disk` with its inertia"
    )
}

pub(crate) fn missing_of_toothing(kind: &str, argument: &str) -> String {
    let example = match argument {
        "teeth" => "teeth = 20",
        "module" => "module [mm] = 2",
        "cone" => "cone [deg] = 45",
        "starts" => "starts = 1",
        "diameter" => "diameter [mm] = 40",
        _ => "…",
    };
    let whole = match kind {
        "bevel" => "teeth = 20, module [mm] = 2, cone [deg] = 45",
        "worm" => "starts = 1, module [mm] = 2, diameter [mm] = 40",
        "rack" => "module [mm] = 2, line = bar.pitch",
        _ => "teeth = 20, module [mm] = 2",
    };
    format!("`{kind}` needs `{argument}`: write `{kind}({example}, …)`, as in `{kind}({whole})`")
}

pub(crate) fn toothing_elsewhere(body: &str, place: &str) -> String {
    format!(
        "the toothing stands on `{body}`, and `{place}` is a place of something else: write a point of `{body}`"
    )
}

pub(crate) fn no_toothings(name: &str, kind: &str) -> String {
    format!(
        "`{name}` is {kind}, and toothings stand on bodies: write `body.rim`, with `toothing rim: external(…);` in the braces of the body"
    )
}

pub(crate) fn unknown_toothing(path: &str, body: &str, known: &[&str]) -> String {
    match known {
        [] => format!(
            "`{body}` has no toothing, so there is no `{path}`: write `toothing rim: external(teeth = 20, module [mm] = 2);` in its braces"
        ),
        known => format!("there is no toothing `{path}`; `{body}` has `{}`", known.join("`, `")),
    }
}

pub(crate) fn rack_without_line(body: &str) -> String {
    format!(
        "a `rack` needs the line that its teeth stand along: write `line pitch = ({body}.start, {body}.end);` in the braces of `{body}` through two of \
         its points, and `rack(module [mm] = 2, line = {body}.pitch)`"
    )
}

pub(crate) fn rack_elsewhere(body: &str, line: &str) -> String {
    format!(
        "the rack stands on `{body}`, and `{line}` is a line of something else: write a line of `{body}`; a rack that rests stands on a body that is `fixed`"
    )
}

pub(crate) fn teeth_not_whole(toothing: &str, what: &str, teeth: f64) -> String {
    format!("the {what} of `{toothing}` are counted, found {}: write a whole number", number(teeth))
}

pub(crate) fn number_of_teeth(toothing: &str, what: &str, teeth: f64, [least, most]: [f64; 2]) -> String {
    let whose = if what == "starts" { "worm" } else { "wheel" };
    format!("`{toothing}` has {} {what}, and a {whose} has {least} to {most}", number(teeth))
}

pub(crate) fn cone(toothing: &str, degrees: f64) -> String {
    format!(
        "half the angle of the cone of `{toothing}` is {} degrees, and bevel gears have 1 to 89: write `cone [deg] = 45`, of a cone that is flat or hollow \
         the ratio, `bevel(a, b, ratio = …)`",
        number(degrees)
    )
}

pub(crate) fn worm_too_thin(toothing: &str, diameter: f64, least: f64) -> String {
    format!(
        "`{toothing}` is {} mm thick, and its threads alone take {} mm: write the diameter of its pitch cylinder",
        mm(diameter),
        mm(least)
    )
}

pub(crate) fn face_beyond_apex(toothing: &str, width: f64, cone: f64) -> String {
    format!(
        "the face of `{toothing}` is {} mm wide, and its cone is {} mm long: bevel gears have faces of a third of that at most",
        mm(width),
        mm(cone)
    )
}

pub(crate) fn toothing_not_positive(toothing: &str, what: &str, value: f64) -> String {
    format!("the {} of `{toothing}` must be positive, found {}", what.replace('_', " "), number(value))
}

pub(crate) fn pressure_angle(toothing: &str, degrees: f64) -> String {
    format!(
        "the pressure angle of `{toothing}` is {} degrees, and teeth have 5 to 45: write `pressure_angle [deg] = 20`",
        number(degrees)
    )
}

pub(crate) fn helix(toothing: &str, degrees: f64) -> String {
    format!(
        "the helix angle of `{toothing}` is {} degrees, and beyond 60 there is no wheel: write `worm(starts = 1, …)` for a screw",
        number(degrees)
    )
}

pub(crate) fn shift_in_modules(toothing: &str, shift: f64) -> String {
    format!(
        "the shift of `{toothing}` is {} modules, and teeth end within 2: write it in modules, `shift = 0.3`",
        number(shift)
    )
}

pub(crate) fn bore_beyond_teeth(toothing: &str, bore: f64, root: f64) -> String {
    format!(
        "the bore of `{toothing}` is {} mm wide, and its teeth stand on a circle of {} mm: write a smaller diameter",
        mm(bore),
        mm(root)
    )
}

// ---- A pair -------------------------------------------------------------------------------------------------------

pub(crate) fn teeth_on_one_shaft(first: &str, second: &str) -> String {
    format!(
        "`{first}` and `{second}` stand on one shaft, so they cannot turn each other: name toothings of two bodies that turn against each other"
    )
}

pub(crate) fn two_rings(first: &str, second: &str) -> String {
    format!(
        "`{first}` and `{second}` are both internal, and two rings have no teeth to mesh with: make the inner one `external`"
    )
}

/// `gives`: of a load between teeth, whose axes may move.
pub(crate) fn centres_not_held(first: &str, second: &str, gives: bool) -> String {
    let moving = if gives { "; of bearings that give write `axes = moving` in the mesh" } else { "" };
    format!(
        "nothing holds the centres of `{first}` and `{second}` at a distance: both must be pinned (`revolute`, `fixed`) to one body or to the \
         ground, at places that do not move with time{moving}"
    )
}

pub(crate) fn no_axle(first: &str, second: &str) -> String {
    format!(
        "`{first}` and `{second}` do not turn about axles that the compiler sees: in space each wheel turns by one `revolute` joint against what holds \
         both, or against a third thing about which that turns; write these joints between places without markers"
    )
}

pub(crate) fn axes_not_parallel(first: &str, second: &str) -> String {
    format!(
        "the axes of `{first}` and `{second}` are not parallel, and such wheels are cylinders: write `bevel(…)` toothings where they cross, `worm(…)` where they pass each other"
    )
}

pub(crate) fn no_partners(texts: [&str; 2], words: [&str; 2], odd: Rim) -> String {
    let rule = match odd {
        Rim::Rack => "a rack meshes with an `external` wheel",
        Rim::Bevel => "a bevel gear meshes with another",
        // Wheels and rings mesh with each other.
        Rim::Worm | Rim::External | Rim::Internal => {
            "a worm meshes with an `external` wheel whose helix is its lead angle"
        }
    };
    format!(
        "`{}` is `{}` and `{}` is `{}`, and these do not mesh: {rule}",
        texts[0], words[0], texts[1], words[1]
    )
}

pub(crate) fn axes_out_of_the_plane(texts: [&str; 2], words: [&str; 2]) -> String {
    let word = if words.contains(&"worm") { "worm" } else { "bevel" };
    format!(
        "`{}` and `{}` turn about axes that are not parallel, and in the plane all are: declare the mechanism `spatial`, or write the ratio, \
         `{word}(a, b, ratio = …)`",
        texts[0], texts[1]
    )
}

pub(crate) fn axes_of_what(found: &str) -> String {
    format!(
        "the axes of a mesh are `held` by joints or `moving` on bearings that give, found `{found}`: write `axes = moving`, or leave it out"
    )
}

pub(crate) fn always_on_moving_axes() -> String {
    "between teeth that do not touch there is no line of action for damping to act along where axes move: write `damping = 60 [N*s/m]`, which acts in \
     contact, and give the bearings damping of their own"
        .to_string()
}

pub(crate) fn moving_axes_in_space(first: &str, second: &str) -> String {
    format!(
        "axes move in the plane, and `{first}` and `{second}` are in space, where they could also tilt: hold both centres by joints, or write `planar` before the \
         name of the mechanism"
    )
}

pub(crate) fn moving_axes_of_cylinders(first: &str, second: &str) -> String {
    format!(
        "axes move between wheels and rings, and of `{first}` and `{second}` one is neither: what holds a rack, a cone or a worm fixes where its teeth press; leave `axes` out"
    )
}

pub(crate) fn involute_of_threads(first: &str, second: &str) -> String {
    format!(
        "`involute(…)` is the stiffness of involute teeth, and of `{first}` and `{second}` one has threads, which touch along curves: write a number, `stiffness [N/um] = 200`"
    )
}

// ---- A rack, cones, a worm ----------------------------------------------------------------------------------------

pub(crate) fn rack_without_rail([pinion, rack]: [&str; 2]) -> String {
    format!(
        "nothing guides `{rack}` along `{pinion}`: a `prismatic` joint without markers moves it, or what it is `fixed` to, against what the centre of `{pinion}` is \
         pinned to"
    )
}

pub(crate) fn rack_across_rail([_, rack]: [&str; 2], rail: &str, degrees: f64) -> String {
    format!(
        "`{rack}` stands at {} degrees to the travel of `{rail}`: its teeth stay in reach of the pinion only where its line is along the rail",
        number(degrees)
    )
}

pub(crate) fn rack_along_axle([pinion, rack]: [&str; 2]) -> String {
    format!(
        "the line of `{rack}` is not across the axis of `{pinion}`: a pinion rolls along a line at right angles to its axle"
    )
}

pub(crate) fn rack_wrong_distance(
    [wheel, other]: [&str; 2],
    is_worm: bool,
    [found, nominal]: [f64; 2],
    shift: f64,
) -> String {
    let (what, instead) = if is_worm { ("axis", "put them there") } else { ("line", "put it there") };
    format!(
        "the axis of `{wheel}` is {} mm from the {what} of `{other}`, and without play it is {} mm: {instead}, or write `shift = {}` for `{wheel}`",
        mm(found),
        mm(nominal),
        exact(shift)
    )
}

pub(crate) fn bevels_in_parallel(texts: [&str; 2]) -> String {
    format!(
        "the axes of `{}` and `{}` are parallel, and cones roll about axes that cross: write `external` toothings",
        texts[0], texts[1]
    )
}

pub(crate) fn bevels_pass(texts: [&str; 2], apart: f64) -> String {
    format!(
        "the axes of `{}` and `{}` pass each other {} mm apart, and cones roll about axes that cross in a point",
        texts[0],
        texts[1],
        mm(apart)
    )
}

pub(crate) fn bevel_at_the_apex(texts: [&str; 2], reach: [f64; 2]) -> String {
    format!(
        "the centres of bevel gears are those of their pitch circles: `{}` stands {} mm and `{}` {} mm from where their axes cross; write such a point, `at = part.point`",
        texts[0],
        mm(reach[0]),
        texts[1],
        mm(reach[1])
    )
}

pub(crate) fn cones_do_not_roll(
    texts: [&str; 2],
    written: [f64; 2],
    right: [f64; 2],
    between: f64,
) -> String {
    if right.iter().any(|cone| *cone >= 90.0) {
        return format!(
            "the axes of `{}` and `{}` leave where they cross at {} degrees: one of the cones would be flat or hollow, and these are written by their ratio, \
             `bevel(a, b, ratio = …)`; or put a wheel on the other side",
            texts[0],
            texts[1],
            number(between)
        );
    }
    format!(
        "the cones of `{}` and `{}` are {} and {} degrees, and with these teeth and {} degrees between the axes they roll at {} and {}: write \
         `cone [deg] = {}` and `cone [deg] = {}`, or `cone = atan2(sin(…), …)` of the teeth",
        texts[0],
        texts[1],
        number(written[0]),
        number(written[1]),
        number(between),
        number(right[0]),
        number(right[1]),
        exact(right[0]),
        exact(right[1])
    )
}

pub(crate) fn bevel_misplaced(toothing: &str, found: f64, right: f64) -> String {
    format!(
        "the centre of `{toothing}` stands {} mm from where the axes cross, and that of its pitch circle {} mm: put it there, or write `at = part.point`",
        mm(found),
        mm(right)
    )
}

pub(crate) fn worm_and_helix([worm, wheel]: [&str; 2], helix: f64, lead: f64) -> String {
    format!(
        "the lead angle of `{worm}` is {} degrees, starts times module over diameter being its tangent, and the helix of `{wheel}` {}: write `helix [deg] = {}`, or its opposite for \
         left-hand threads",
        number(lead),
        number(helix),
        exact(lead)
    )
}

pub(crate) fn worm_and_module([worm, wheel]: [&str; 2], [axial, normal]: [f64; 2], right: f64) -> String {
    format!(
        "the module of `{worm}` is {} mm along its axis and that of `{wheel}` {} mm across its teeth: the second is the first times the cosine of the lead angle, {} mm",
        mm(axial),
        mm(normal),
        mm(right)
    )
}

pub(crate) fn worm_axes([worm, wheel]: [&str; 2], degrees: f64) -> String {
    format!(
        "the axes of `{worm}` and `{wheel}` are at {} degrees, and a worm drives at right angles",
        number(degrees)
    )
}

pub(crate) fn worm_beside_wheel([worm, wheel]: [&str; 2], off: f64) -> String {
    format!(
        "the axis of `{worm}` passes {} mm beside the middle plane of `{wheel}`: put the centre of the wheel there, or write `at = part.point`",
        mm(off)
    )
}

pub(crate) fn planets_not_assembled(gear: &str, apart: f64, sun: f64, ring: f64, planets: usize) -> String {
    let sum = sun + ring;
    let fits = |n: &usize| *n > 1 && (sum / *n as f64).fract() == 0.0;
    let nearest = (2..=planets + 4).filter(fits).min_by_key(|n| n.abs_diff(planets));
    let instead = match nearest {
        Some(nearest) => format!("{nearest} of them fit equally apart, as {sum}/{nearest} is whole"),
        None => "no few of them fit equally apart".to_string(),
    };
    format!(
        "the teeth of `{gear}` do not meet: its planet stands {} teeth off where the others hold it. Sun and ring have {sum} teeth together, \
         and planets stand at angles ψ with {sum} ψ/360 whole; {instead}",
        number(apart.abs())
    )
}

pub(crate) fn loop_not_assembled(gear: &str, of: &[&str], apart: f64) -> String {
    format!(
        "the teeth of `{gear}` do not meet: around `{}` they stand {} teeth off. Move an axle, or, \
         where two toothings stand on one body, turn one of them, `first [deg] = …`",
        of.join("`, `"),
        number(apart.abs())
    )
}

pub(crate) fn modules_differ(first: &str, second: &str, modules: [f64; 2]) -> String {
    format!(
        "`{first}` has a module of {} mm and `{second}` one of {} mm: teeth that mesh have the same",
        mm(modules[0]),
        mm(modules[1])
    )
}

pub(crate) fn pressure_angles_differ(first: &str, second: &str, degrees: [f64; 2]) -> String {
    format!(
        "`{first}` has a pressure angle of {} degrees and `{second}` one of {}: teeth that mesh have the same",
        number(degrees[0]),
        number(degrees[1])
    )
}

pub(crate) fn helices_differ(first: &str, second: &str, degrees: [f64; 2], ring: bool) -> String {
    let rule = if ring {
        "of a wheel in a ring they are the same"
    } else {
        "of two wheels one is the other with its sign turned"
    };
    format!(
        "the helix angles of `{first}` and `{second}` are {} and {} degrees: {rule}",
        number(degrees[0]),
        number(degrees[1])
    )
}

pub(crate) fn ring_too_small([wheel, ring]: [&str; 2], teeth: [f64; 2]) -> String {
    format!(
        "`{wheel}` with {} teeth does not fit into `{ring}` with {}: the ring has more teeth than the wheel in it",
        teeth[0], teeth[1]
    )
}

pub(crate) fn wrong_distance(
    first: &str,
    second: &str,
    found: f64,
    nominal: f64,
    shift: Option<f64>,
) -> String {
    let instead = match shift {
        Some(shift) => {
            format!("put them {} mm apart, or write shifts that add up to {}", mm(nominal), exact(shift))
        }
        None => format!("put them {} mm apart", mm(nominal)),
    };
    format!(
        "the axes of `{first}` and `{second}` are {} mm apart, and their teeth touch on both sides at {} mm: {instead}",
        mm(found),
        mm(nominal)
    )
}

pub(crate) fn mesh_beside_gear(mesh: &str, [first, second]: [&str; 2], gear: &str) -> String {
    format!(
        "`{mesh}` gives between the teeth of `{first}` and `{second}`, which `{gear}` holds rigidly: its deflection never changes. Leave one out: a `gear` for \
         teeth that are rigid, a `mesh` for teeth that give"
    )
}

pub(crate) fn no_distance([first, second]: [&str; 2], least: f64) -> String {
    format!(
        "the shifts make the teeth of `{first}` and `{second}` so thin that they do not touch on both sides at any distance: write shifts that add up to {} or more \
         (of a ring its own less that of its wheel)",
        exact(least)
    )
}

pub(crate) fn teeth_lose_contact(first: &str, second: &str, ratio: f64) -> String {
    format!(
        "the contact ratio of `{first}` and `{second}` is {}: below 1 there are positions where no teeth touch. Write more teeth or a larger addendum",
        number(ratio)
    )
}

pub(crate) fn tips_collide([wheel, ring]: [&str; 2], teeth: [f64; 2], overlap: f64) -> String {
    format!(
        "the tips of `{wheel}` and `{ring}` run into each other beside the mesh, by {} mm: {} and {} teeth are too near for this addendum; write \
         `addendum = 0.8`, or about ten teeth of difference",
        mm(overlap),
        teeth[0],
        teeth[1]
    )
}

pub(crate) fn planets_collide(first: &str, second: &str, distance: f64, tips: f64) -> String {
    format!(
        "`{first}` and `{second}` run into each other: their axes are {} mm apart and their tip circles need {} mm. Write fewer planets, or planets \
         with fewer teeth",
        mm(distance),
        mm(tips)
    )
}

// ---- Warnings -----------------------------------------------------------------------------------------------------

pub(crate) fn low_contact_ratio(first: &str, second: &str, ratio: f64) -> String {
    format!(
        "the contact ratio of `{first}` and `{second}` is {}, and below 1.1 the smallest error of manufacture parts the teeth",
        number(ratio)
    )
}

pub(crate) fn undercut(toothing: &str, teeth: f64, least: f64, shift: f64) -> String {
    format!(
        "`{toothing}` is undercut: with {teeth} teeth its hob cuts into the flanks, which {} teeth would not have; `shift = {}` avoids it, and \
         `#[allow(teeth)]` says that it is known",
        number(least),
        crate::numbers::significant(shift, 3)
    )
}

pub(crate) fn bevel_undercut(toothing: &str, teeth: f64, same: f64, least: f64) -> String {
    format!(
        "`{toothing}` is undercut: with {teeth} teeth on its cone it is like a spur gear of {}, and {} are not cut into; more teeth avoid it, and \
         `#[allow(teeth)]` says that it is known",
        number(same),
        number(least)
    )
}

pub(crate) fn interference(first: &str, second: &str, ratios: [f64; 2]) -> String {
    format!(
        "the tips of `{second}` reach below the base circle of `{first}`, where there is no involute: contact ends at the base tangent point, and the \
         contact ratio is {} in place of {}; a shift of `{first}` avoids it",
        number(ratios[0]),
        number(ratios[1])
    )
}

pub(crate) fn ring_inside_base(ring: &str, tip: f64, base: f64) -> String {
    format!(
        "the tips of `{ring}` lie {} mm inside its base circle, where there is no involute: write a smaller addendum or a shift",
        mm(base - tip)
    )
}

pub(crate) fn odd_face_width(toothing: &str, ratio: f64) -> String {
    format!(
        "the face of `{toothing}` is {} modules wide; gears have 3 to 40: is its unit right?",
        number(ratio)
    )
}

pub(crate) fn body_beyond(toothing: &str, half: f64, ratio: f64) -> String {
    let (what, remedy) = if (1.4..=7.0).contains(&ratio) {
        (
            format!("half a tooth takes {} rad at its foot", crate::numbers::significant(half, 3)),
            "`tooth = section` leaves the body out",
        )
    } else {
        (
            format!("its teeth stand {} times as far out as its bore reaches", number(ratio)),
            "write its `bore`",
        )
    };
    format!(
        "what the body of `{toothing}` gives is extrapolated: {what}, and the formula was made for 0.01 to 0.12 rad and 1.4 to 7 times; {remedy}, \
         and `#[allow(teeth)]` says that it is known"
    )
}

// ---- Loads between teeth ------------------------------------------------------------------------------------------

pub(crate) fn involute_with_unit() -> String {
    "`involute(…)` is in N/m by itself: write no unit beside its name, `stiffness = involute(young [GPa] = 210)`".to_string()
}

pub(crate) fn involute_without_young() -> String {
    "`involute` needs the modulus of the material: write `involute(young [GPa] = 210)`".to_string()
}

pub(crate) fn involute_of_what(tooth: &str) -> String {
    format!("a tooth is taken for a `section` or a `profile`, found `{tooth}`: write `tooth = profile`")
}

pub(crate) fn involute_harmonics(found: f64) -> String {
    format!(
        "the series has {} harmonics, and 1 to 40 are possible: the stiffness jumps where a pair enters, and no equation of motion \
         can jump; write `harmonics = 5`, and `entry = 0.05` for the part of a pitch over which a pair enters",
        number(found)
    )
}

pub(crate) fn involute_number(what: &str, found: f64, range: &str) -> String {
    format!("the {what} of `involute` is {}, and lies {range}", number(found))
}

pub(crate) fn involute_without_width(first: &str, second: &str) -> String {
    format!(
        "teeth are as stiff as they are wide, and neither `{first}` nor `{second}` says how wide: write `face_width [mm] = 20` in one of them"
    )
}

pub(crate) fn sense_of_teeth(found: f64) -> String {
    format!(
        "the sense is 1 or -1, found {}: 1 where the first wheel drives counter-clockwise, so that its deflection is positive",
        number(found)
    )
}

pub(crate) fn damping_and_ratio() -> String {
    "`damping_ratio` is written beside `damping`, and each of them is the damping: leave one of them out"
        .to_string()
}

pub(crate) fn ratio_of_changing_stiffness(load: &str, mass: f64, ratio: f64) -> String {
    format!(
        "the stiffness of `{load}` changes with what moves, and a damping ratio is that of one stiffness k: write `damping`, which is 2·{}·sqrt(k·{} kg)",
        number(ratio),
        number(mass)
    )
}

pub(crate) fn backlash_too_wide(load: &str, backlash: f64, most: f64) -> String {
    format!(
        "the backlash of `{load}` is {} mm, and half a pitch along the line of action is {} mm: is its unit right?",
        mm(backlash),
        mm(most)
    )
}

pub(crate) fn quantity_of_teeth(load: &str, asked: &str) -> String {
    format!(
        "`{load}` acts between teeth and has no `{asked}`; it has `force`, `deflection`, `phase`, `pairs` and `stiffness`"
    )
}
