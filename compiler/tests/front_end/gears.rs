//! Toothings and pairs that mesh: one message for each mistake, warnings, and the numbers that follow from teeth.

use crate::{good, warnings};
use linkwright_compiler::compile;
use linkwright_compiler::model::Mechanism;
use linkwright_compiler::model::gears::stiffness::{Material, Stiffness, Tooth};
use linkwright_compiler::model::gears::{Gives, Mesh, Told};

/// Two wheels on the ground, with these toothings, `apart` mm from each other.
fn wheels(first: &str, second: &str, apart: &str, rest: &str) -> String {
    format!(
        "planar Pair {{ disk one {{ mass [kg] = 1; radius [mm] = 20; toothing rim: {first}; }}
         disk two {{ mass [kg] = 1; radius [mm] = 20; toothing rim: {second}; }}
         joint a: revolute(ground(0, 0) [mm], one.center); joint b: revolute(ground({apart}, 0) [mm], two.center);
         gear mesh_of: gear(one.rim, two.rim); {rest} }}"
    )
}

/// A sun, a ring and planets at these angles, degrees.
fn planets(sun: u32, planet: u32, ring: u32, at: &[f64]) -> String {
    let axes = f64::from(sun + planet) / 1e3;
    let mut text = format!(
        "planar Set {{ body arm {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; {} }}
         body sun {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: external(teeth = {sun}, module [mm] = 2); }}
         body ring {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: internal(teeth = {ring}, module [mm] = 2); }}
         joint main: revolute(ground(0, 0), arm.origin); joint axle: revolute(ground(0, 0), sun.center);
         joint rim: revolute(ground(0, 0), ring.center);",
        at.iter()
            .enumerate()
            .map(|(index, psi)| format!("point pin[{index}] [m] = ({axes} [m]*cos({psi} [deg]), {axes} [m]*sin({psi} [deg]));"))
            .collect::<String>()
    );
    for index in 0..at.len() {
        text += &format!(
            "body planet[{index}] {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; toothing rim: external(teeth = {planet}, module [mm] = 2); }}
             joint bolt[{index}]: revolute(arm.pin[{index}], planet[{index}].center);
             gear inner[{index}]: gear(sun.rim, planet[{index}].rim); gear outer[{index}]: gear(planet[{index}].rim, ring.rim);"
        );
    }
    text + "}"
}

const PLAIN: &str = "external(teeth = 20, module [mm] = 2)";

#[test]
fn one_message_for_each_mistake() {
    let one = |toothing: &str| wheels(toothing, PLAIN, "40", "");
    for (source, expected) in [
        (one("external(teeth = 20.5, module [mm] = 2)"), "the teeth of `one.rim` are counted, found 20.5: write a whole number"),
        (one("external(teeth = 3, module [mm] = 2)"), "`one.rim` has 3 teeth, and a wheel has 4 to 10000"),
        (one("external(teeth = 20, module [mm] = 0)"), "the module of `one.rim` must be positive, found 0"),
        (one("external(teeth = 20)"), "`external` needs `module`"),
        (one("external(module [mm] = 2)"), "`external` needs `teeth`"),
        (one("external(teeth = 20, module [mm] = 2, teeth = 20)"), "is given twice"),
        (one("external(teeth = 20, module [mm] = 2, tooth = 20)"), "tooth"),
        (one("external(teeth = 20, module [kg] = 2)"), "expected m"),
        (one("spur(teeth = 20, module [mm] = 2)"), "no toothing called \"spur\"; did you mean `external`?"),
        (one("external(teeth = 20, module [mm] = 2, pressure_angle [rad] = 20)"), "and teeth have 5 to 45"),
        (one("external(teeth = 20, module [mm] = 2, helix [deg] = 80)"), "the helix angle of `one.rim` is 80 degrees, and beyond 60 there is no wheel: write `worm(starts = 1, …)` for a screw"),
        (one("external(teeth = 20, module [mm] = 2, shift = 5)"), "the shift of `one.rim` is 5 modules, and teeth end within 2: write it in modules, `shift = 0.3`"),
        (one("external(teeth = 20, module [mm] = 2, addendum = 0)"), "the addendum of `one.rim` must be positive"),
        (one("external(teeth = 20, module [mm] = 2, face_width [mm] = -1)"), "the face width of `one.rim` must be positive"),
        (one("external(teeth = 20, module [mm] = 2, bore [mm] = 36)"), "its teeth stand on a circle of 35 mm"),
        (one("external(teeth = 20, module [mm] = 2, at = two.center)"), "the toothing stands on `one`, and `two.center` is a place of something else: write a point of `one`"),
        (one("external(teeth = 20, module [mm] = 3)"), "`one.rim` has a module of 3 mm and `two.rim` one of 2 mm"),
        (one("external(teeth = 20, module [mm] = 2, pressure_angle [deg] = 25)"), "a pressure angle of 25 degrees and `two.rim` one of 20"),
        (one("external(teeth = 20, module [mm] = 2, helix [deg] = 10)"), "of two wheels one is the other with its sign turned"),
        (
            wheels("external(teeth = 20, module [mm] = 2, helix [deg] = 10)", "internal(teeth = 60, module [mm] = 2)", "40", ""),
            "of a wheel in a ring they are the same",
        ),
        (one("internal(teeth = 18, module [mm] = 2)"), "the ring has more teeth than the wheel in it"),
        (wheels("internal(teeth = 60, module [mm] = 2)", "internal(teeth = 20, module [mm] = 2)", "40", ""), "two rings have no teeth to mesh with"),
        (wheels(PLAIN, PLAIN, "40", "mesh m: mesh(two.rim, one.rim, stiffness [N/m] = 1e8);"), "`m` gives between the teeth of `two.rim` and `one.rim`, which `mesh_of` holds rigidly: its deflection never changes. Leave one out: a `gear` for teeth that are rigid, a `mesh` for teeth that give"),
        (wheels(PLAIN, PLAIN, "40", "gear n: gear(one.rim, two.rim, ratio = 2);"), "joints and bodies are named here without a point, and two toothings bring their ratio: for these leave `ratio` out"),
        (wheels(PLAIN, PLAIN, "40", "shaft n: shaft(a, a, ratio = 1, stiffness [N*m/rad] = 9);"), "`n` couples something with itself"),
        (wheels(PLAIN, PLAIN, "60", ""), "are 60 mm apart, and their teeth touch on both sides at 40 mm: put them 40 mm apart"),
        (wheels(PLAIN, PLAIN, "40.5", ""), "are 40.5 mm apart, and their teeth touch on both sides at 40 mm: put them 40 mm apart, or write shifts that add up to 0.26"),
        (wheels(PLAIN, PLAIN, "30", ""), "are 30 mm apart, and their teeth touch on both sides at 40 mm: put them 40 mm apart"),
        (
            wheels("external(teeth = 20, module [mm] = 2, addendum = 0.5)", "external(teeth = 20, module [mm] = 2, addendum = 0.5)", "40", ""),
            "below 1 there are positions where no teeth touch",
        ),
        (
            wheels("external(teeth = 30, module [mm] = 2)", "internal(teeth = 33, module [mm] = 2)", "3", ""),
            "run into each other beside the mesh",
        ),
        (wheels(PLAIN, PLAIN, "40", "").replace("two.rim);", "two.ring);"), "there is no toothing `two.ring`; `two` has `rim`"),
        (wheels(PLAIN, PLAIN, "40", "").replace("two.rim);", "bare.rim);").replace("disk two", "body bare { mass [kg] = 1; inertia [kg*m^2] = 1; } disk two"), "`bare` has no toothing, so there is no `bare.rim`"),
        (wheels(PLAIN, PLAIN, "40", "").replace("two.rim);", "b.rim);"), "`b` is a joint, and toothings stand on bodies"),
        (wheels(PLAIN, PLAIN, "40", "").replace("two.rim);", "tow.rim);"), "did you mean \"two\"?"),
        (wheels(PLAIN, PLAIN, "40", "").replace("two.rim);", "one.rim);"), "stand on one shaft"),
        (wheels(PLAIN, PLAIN, "40", "").replace("joint b: revolute(ground(40, 0) [mm], two.center);", ""), "nothing holds the centres of `one.rim` and `two.rim`"),
        (wheels(PLAIN, PLAIN, "40", "particle p { mass [kg] = 1; toothing rim: external(teeth = 20, module [mm] = 2); }"), "has no orientation, so it carries no teeth"),
        (wheels(PLAIN, PLAIN, "40", "").replace("gear(one.rim, two.rim)", "gear(one.rim, two.rim, ratio = 2)"), "without a point"),
        (wheels(PLAIN, PLAIN, "40", "start { a.angle [rad] = 0; b.angle [rad] = 0; }"), "the teeth of `mesh_of` do not meet at the start: where `start` puts the wheels they are 0.5 of a pitch apart"),
        (
            // Four wheels in a rhombus, whose angle is no whole number of half pitches.
            wheels(PLAIN, PLAIN, "40", "disk three { mass [kg] = 1; radius [mm] = 20; toothing rim: external(teeth = 20, module [mm] = 2); }
                disk four { mass [kg] = 1; radius [mm] = 20; toothing rim: external(teeth = 20, module [mm] = 2); }
                joint c: revolute(ground(16.904730469627978, 36.252311481465995) [mm], three.center); joint d: revolute(ground(56.90473046962798, 36.252311481465995) [mm], four.center);
                gear e: gear(one.rim, three.rim); gear f: gear(three.rim, four.rim); gear g: gear(two.rim, four.rim);"),
            "the teeth of `g` do not meet: around `mesh_of`, `e`, `f`, `g` they stand 0.44444 teeth off",
        ),
        (planets(41, 20, 81, &[0.0, 120.0, 240.0]), "its planet stands 0.33333 teeth off where the others hold it. Sun and ring have 122 teeth together"),
        (planets(41, 24, 90, &[0.0, 50.0]), "no few of them fit equally apart"),
        (planets(40, 20, 80, &[0.0, 121.0, 240.0]), "its planet stands 0.33333 teeth off"),
        (planets(20, 40, 100, &[0.0, 60.0, 120.0, 180.0, 240.0, 300.0]), "`planet[1].rim` and `planet[0].rim` run into each other"),
    ] {
        says(&source, expected);
    }
}

/// One message, with this text in it.
#[track_caller]
fn says(source: &str, expected: &str) {
    let found = compile(source.parse().expect("tokens"), None).map(|_| ()).expect_err(expected);
    let found: Vec<String> = found.iter().map(|error| error.message.clone()).collect();
    assert!(
        matches!(&found[..], [only] if only.contains(expected)),
        "{expected:?} in place of {found:#?}\n{source}"
    );
}

/// Wheels in space turn by joints about parallel axes.
#[test]
fn axles_in_space() {
    let space = |joint: &str| {
        format!(
            "spatial Pair {{ cylinder one {{ mass [kg] = 1; radius [mm] = 20; length [mm] = 9; toothing rim: external(teeth = 20, module [mm] = 2); }}
             cylinder two {{ mass [kg] = 1; radius [mm] = 20; length [mm] = 9; toothing rim: external(teeth = 20, module [mm] = 2); }}
             joint a: revolute(ground(0, 0, 0) [mm], one.center, axis = (0, 0, 1)); joint b: {joint};
             gear mesh_of: gear(one.rim, two.rim); }}"
        )
    };
    let held = space("revolute(two.center, ground(40, 0, 0) [mm], axis = (0, 0, -1))");
    let mechanism = good(&held);
    assert_eq!(mechanism.pairs[0].terms.iter().map(|(factor, _)| *factor).collect::<Vec<_>>(), [20.0, 20.0]);
    says(
        &space("spherical(ground(40, 0, 0) [mm], two.center)"),
        "`one.rim` and `two.rim` do not turn about axles that the compiler sees: in space each wheel turns by one `revolute` joint against what holds both, or against a third thing about which that turns; write these joints between places without markers",
    );
    says(
        &space("revolute(ground(40, 0, 0) [mm], two.center, axis = (0, 1, 1))"),
        "are not parallel, and such wheels are cylinders",
    );
}

fn pair(source: &str) -> (Mechanism, Mesh) {
    let mechanism = good(source);
    let (_, mesh) = mechanism.mesh_of(&mechanism.pairs[0]);
    (mechanism, mesh)
}

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within * expected.abs(), "{found} in place of {expected}");
}

/// 12/30/72 teeth of 1 mm: the sun's are undercut and its path of contact ends at the base tangent point. Litvin & Fuentes (2004), 10.5, 11.5.
#[test]
fn contact_ratios() {
    let (mechanism, mesh) = pair(&wheels(
        "external(teeth = 12, module [mm] = 1)",
        "external(teeth = 30, module [mm] = 1)",
        "21",
        "",
    ));
    near(mesh.contact_ratio, 1.405_302_72, 1e-8);
    near(mesh.base_pitch, 2.952_131_43e-3, 1e-8);
    near(mesh.path[1], 4.148_638_33e-3, 1e-8);
    assert_eq!(mesh.path[0], 0.0);
    assert_eq!(mesh.clamped, [true, false]);
    assert_eq!(Told::of(&mechanism, &mechanism.pairs[0]).hunting, Some(5.0));
    let (_, mesh) = pair(&wheels(
        "external(teeth = 30, module [mm] = 1)",
        "internal(teeth = 72, module [mm] = 1)",
        "-21",
        "",
    ));
    near(mesh.contact_ratio, 1.956_380_30, 1e-8);
    near(mesh.path[0], 1.795_505_53e-3, 1e-8);
    near(mesh.path[1], 7.570_997_30e-3, 1e-8);
    // The same pair, its ring first.
    let (_, turned) = pair(&wheels(
        "internal(teeth = 72, module [mm] = 1)",
        "external(teeth = 30, module [mm] = 1)",
        "21",
        "",
    ));
    assert_eq!(turned.contact_ratio, mesh.contact_ratio);
}

/// Shifted teeth touch on both sides at the distance where inv α_w = inv α + 2 tan α Σx/Σz.
#[test]
fn shifted_teeth() {
    let shifted = |x: &str| format!("external(teeth = 20, module [mm] = 2, shift = {x})");
    let (_, mesh) = pair(&wheels(&shifted("0.3"), &shifted("-0.3"), "40", ""));
    near(mesh.nominal, 0.04, 1e-15);
    let told = "put them 40.9250571";
    says(&wheels(&shifted("0.25"), &shifted("0.25"), "40", ""), told);
}

/// Planets at other angles are possible where their teeth meet: 120 ψ/360 whole.
#[test]
fn planets_stand_where_their_teeth_meet() {
    for angles in [&[0.0, 120.0, 240.0][..], &[0.0, 90.0, 183.0], &[0.0, 177.0]] {
        let mechanism = good(&planets(40, 20, 80, angles));
        let following = mechanism.pairs.iter().filter(|pair| pair.follows.is_some()).count();
        assert_eq!(following, angles.len() - 1);
    }
}

#[test]
fn what_is_possible_and_probably_not_meant() {
    let two = |first: &str, second: &str, apart: &str| {
        let found = warnings(&wheels(first, second, apart, ""));
        found.iter().map(|warning| warning.message.clone()).collect::<Vec<_>>()
    };
    let small = "external(teeth = 12, module [mm] = 1)";
    let found = two(small, "external(teeth = 30, module [mm] = 1)", "21");
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(
        found[0].contains("`one.rim` is undercut: with 12 teeth")
            && found[0].contains("`shift = 0.298` avoids it"),
        "{found:?}"
    );
    assert!(found[1].contains("the tips of `two.rim` reach below the base circle of `one.rim`"), "{found:?}");
    let known = format!("#[allow(teeth)] toothing rim: {small}; }}");
    let source = wheels(small, "external(teeth = 30, module [mm] = 1)", "21", "");
    let source = source
        .replacen(&format!("toothing rim: {small}; }}"), &known, 1)
        .replace("gear mesh_of", "#[allow(teeth)] gear mesh_of");
    assert!(warnings(&source).is_empty());
    let wide = two("external(teeth = 20, module [mm] = 2, face_width [m] = 20)", PLAIN, "40");
    assert!(
        wide[0]
            .contains("the face of `one.rim` is 10000 modules wide; gears have 3 to 40: is its unit right?"),
        "{wide:?}"
    );
    let low = two(
        "external(teeth = 20, module [mm] = 2, addendum = 0.7)",
        "external(teeth = 20, module [mm] = 2, addendum = 0.62)",
        "40",
    );
    assert!(low[0].contains("below 1.1 the smallest error of manufacture parts the teeth"), "{low:?}");
    let inside = two("external(teeth = 20, module [mm] = 2)", "internal(teeth = 30, module [mm] = 2)", "-10");
    assert!(inside.iter().any(|message| message.contains("inside its base circle")), "{inside:?}");
    let idle = warnings(
        &wheels(PLAIN, PLAIN, "40", "")
            .replace("toothing rim", "toothing spare: external(teeth = 20, module [mm] = 2); toothing rim"),
    );
    assert!(idle.iter().all(|warning| warning.message.contains("toothing `spare`")), "{idle}");
}

/// The body below the teeth is a formula fitted to some sizes: 12 teeth are too few, and so is a body that is nearly all bore.
#[test]
fn bodies_beyond_their_formula() {
    let told = |first: &str, tooth: &str| {
        let source = wheels(first, "external(teeth = 30, module [mm] = 1)", "21", "");
        let source = source.replace(
            "gear mesh_of: gear(one.rim, two.rim);",
            &format!(
                "mesh m: mesh(one.rim, two.rim, stiffness = involute(young [GPa] = 210, tooth = {tooth}));"
            ),
        );
        let found: Vec<String> = warnings(&source).iter().map(|warning| warning.message.clone()).collect();
        found.into_iter().filter(|message| message.contains("extrapolated")).collect::<Vec<_>>()
    };
    let small = "external(teeth = 12, module [mm] = 1, face_width [mm] = 5)";
    let found = told(small, "profile");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].contains("half a tooth takes 0.146 rad at its foot, and the formula was made for 0.01 to 0.12 rad and 1.4 to 7 times; ")
            && found[0].contains("`tooth = section` leaves the body out"),
        "{found:?}"
    );
    assert!(told(small, "section").is_empty());
    let thin = "external(teeth = 12, module [mm] = 1, face_width [mm] = 5, bore [mm] = 9)";
    let found = told(thin, "profile");
    assert!(
        found.len() == 1
            && found[0].contains(" times as far out as its bore reaches")
            && found[0].contains("write its `bore`"),
        "{found:?}"
    );
}

/// The stiffness of the pairs 12/30 and 30/72 of 1 mm, 5 mm wide, of 210 GPa.
fn stiffness(sun: &str, tooth: Tooth, then: impl Fn(&Stiffness)) {
    let mechanism = good(sun);
    let pair = &mechanism.pairs[0];
    let (toothings, mesh) = mechanism.mesh_of(pair);
    let material = Material { young: 2.1e11, poisson: 0.3, tooth, harmonics: 3, entry: 0.0 };
    then(&Stiffness::new(toothings.map(Clone::clone), mesh, pair.distance(), 5e-3, material));
}

const SUN: &str = "external(teeth = 12, module [mm] = 1, bore [mm] = 4)";
const PLANET: &str = "external(teeth = 30, module [mm] = 1, bore [mm] = 10)";

/// Teeth of constant section, from an evaluation apart: at tenths of a pitch, mean and the sizes of three waves.
#[test]
fn teeth_of_constant_section() {
    let check = |source: &str, values: [f64; 10], mean: f64, waves: [f64; 3], one: Option<[f64; 2]>| {
        stiffness(source, Tooth::Section, |stiffness| {
            for (index, expected) in values.into_iter().enumerate() {
                near(stiffness.at(index as f64 / 10.0), expected * 1e8, 1e-5);
            }
            let series = stiffness.series(3);
            // At 256 places of a curve that jumps twice.
            near(series.mean, mean * 1e8, 3e-4);
            for ([a, b], expected) in series.waves.iter().zip(waves) {
                assert!((a.hypot(*b) - expected * 1e8).abs() < 5e-4 * mean * 1e8, "{a} {b}");
            }
            if let Some([at, expected]) = one {
                near(stiffness.of_one(at), expected, 1e-6);
            }
        });
    };
    check(
        &wheels(SUN, PLANET, "21", ""),
        [1.65187, 1.24954, 1.10183, 1.22179, 1.57703, 2.07691, 2.58632, 2.83018, 2.64277, 2.09189],
        1.89079,
        [0.85478, 0.08854, 0.02173],
        // 1/(1/1.06234734e9 + 1/2.58162757e8).
        Some([0.5 * 2.952_131_43e-3, 1.0 / (1.0 / 1.062_347_34e9 + 1.0 / 2.581_627_57e8)]),
    );
    check(
        &wheels(PLANET, "internal(teeth = 72, module [mm] = 1)", "-21", ""),
        [2.48288, 2.82234, 2.86464, 2.58994, 2.16998, 1.80204, 1.59156, 1.56706, 1.72141, 2.02089],
        2.15548,
        [0.66030, 0.07327, 0.02029],
        None,
    );
}

/// Bending, shear, compression, body and contact along the true profile, from an evaluation apart.
#[test]
fn teeth_by_their_profile() {
    stiffness(&wheels(SUN, PLANET, "21", ""), Tooth::Profile, |stiffness| {
        for (at, expected) in [
            (0.02, 3.6545),
            (0.19, 4.1417),
            (0.36, 4.5268),
            (0.53, 4.7636),
            (0.70, 4.8147),
            (0.87, 4.6632),
            (1.04, 4.3202),
            (1.21, 3.8238),
            (1.38, 3.2240),
        ] {
            near(stiffness.of_one(at * 2.952_131_43e-3), expected * 1e7, 3e-5);
        }
    });
}

/// Loads between teeth: one message for each mistake.
#[test]
fn mistakes_between_teeth() {
    let wide = "external(teeth = 20, module [mm] = 2, face_width [mm] = 20)";
    let mesh = |arguments: &str| {
        wheels(wide, wide, "40", "").replace(
            "gear mesh_of: gear(one.rim, two.rim);",
            &format!("mesh m: mesh(one.rim, two.rim{arguments});"),
        )
    };
    for (arguments, expected) in [
        ("", "`mesh` needs its stiffness"),
        (", stiffness [N] = 1", "expected N/m"),
        (
            ", stiffness [N/m] = involute(young [GPa] = 210)",
            "`involute(…)` is in N/m by itself: write no unit beside its name, `stiffness = involute(young [GPa] = 210)`",
        ),
        (
            ", stiffness = involute(poisson = 0.3)",
            "`involute` needs the modulus of the material: write `involute(young [GPa] = 210)`",
        ),
        (
            ", stiffness = involute(young [GPa] = 210, tooth = round)",
            "a tooth is taken for a `section` or a `profile`, found `round`",
        ),
        (
            ", stiffness = involute(young [GPa] = 210, harmonics = 0)",
            "the series has 0 harmonics, and 1 to 40 are possible: the stiffness jumps where a pair enters, and no equation of motion can jump; write `harmonics = 5`, and `entry = 0.05` for the part of a pitch over which a pair enters",
        ),
        (
            ", stiffness = involute(young [GPa] = 210, poisson = 0.6)",
            "the poisson of `involute` is 0.6, and lies from 0 to 0.5",
        ),
        (", stiffness = involute(young [GPa] = 210, edge = 0.6)", "edge"),
        (", stiffness = involute(young [GPa] = 210, young [GPa] = 210)", "twice"),
        (", stiffness [N/m] = 1e8, sense = 2", "the sense is 1 or -1, found 2"),
        (
            ", stiffness [N/m] = 1e8, damping [N*s/m] = 1, damping_ratio = 0.1",
            "`damping_ratio` is written beside `damping`, and each of them is the damping: leave one of them out",
        ),
        (
            ", stiffness [N/m] = 1e8, backlash [mm] = 6",
            "the backlash of `m` is 6 mm, and half a pitch along the line of action is 2.95213143 mm: is its unit right?",
        ),
        (
            ", stiffness [N/m] = 1e8); output o [N] = m.push; force f: torque(a) = 0*(1 [N*m]",
            "`m` acts between teeth and has no `push`; it has `force`, `deflection`, `phase`, `pairs` and `stiffness`",
        ),
    ] {
        says(&mesh(arguments), expected);
    }
    let bare = wheels(PLAIN, PLAIN, "40", "").replace(
        "gear mesh_of: gear(one.rim, two.rim);",
        "mesh m: mesh(one.rim, two.rim, stiffness = involute(young [GPa] = 210));",
    );
    says(&bare, "teeth are as stiff as they are wide, and neither `one.rim` nor `two.rim` says how wide");
    says(&mesh(", stiffness [N/m] = 1e8").replace("two.rim,", "one.rim,"), "stand on one shaft");
}

/// A pinion of 20 teeth of 2 mm above a rack.
fn rack(pinion: &str, rack: &str, above: &str, axis: &str) -> String {
    format!(
        "planar Rack {{ disk pinion {{ mass [kg] = 1; radius [mm] = 20; toothing rim: {pinion}; }}
         body bar {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; point near [mm] = (-90, 0); point far [mm] = (90, 0);
                     line pitch = (bar.near, bar.far); toothing teeth: {rack}; }}
         joint axle: revolute(ground(0, {above}) [mm], pinion.center);
         joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = {axis});
         gear drive: gear(pinion.rim, bar.teeth); }}"
    )
}

/// Wheels in space: the first about x at `first`, the second about an axis at `second`.
fn crossed(one: &str, first: &str, other: &str, second: &str, axis: &str) -> String {
    format!(
        "spatial Crossed {{ body one {{ mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: {one}; }}
         body two {{ mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: {other}; }}
         joint a: revolute(ground({first}) [mm], one.center, axis = (1, 0, 0));
         joint b: revolute(ground({second}) [mm], two.center, axis = {axis});
         gear drive: gear(one.rim, two.rim); }}"
    )
}

const RACK: &str = "rack(module [mm] = 2, line = bar.pitch)";
const SMALL: &str = "bevel(teeth = 20, module [mm] = 2, cone = atan2(20, 40))";
const LARGE: &str = "bevel(teeth = 40, module [mm] = 2, cone = atan2(40, 20))";
const WORM: &str = "worm(starts = 1, module [mm] = 2, diameter [mm] = 20)";
const WHEEL: &str = "external(teeth = 40, module = 2*cos(atan2(2, 20))*1 [mm], helix = atan2(2, 20))";

#[test]
fn mistakes_of_racks_cones_and_worms() {
    let plane = |pinion: &str, other: &str| rack(pinion, other, "20", "(1, 0)");
    let cones = |one: &str, other: &str| crossed(one, "40, 0, 0", other, "0, 0, 20", "(0, 0, 1)");
    let worm = |one: &str, other: &str| crossed(one, "0, 0, 0", other, "0, 50, 0", "(0, 0, 1)");
    for (source, expected) in [
        (
            plane(PLAIN, "rack(module [mm] = 2)"),
            "a `rack` needs the line that its teeth stand along: write `line pitch = (bar.start, bar.end);`",
        ),
        (plane(PLAIN, "rack(line = bar.pitch)"), "`rack` needs `module`: write `rack(module [mm] = 2, …)`"),
        (plane(PLAIN, "rack(module [mm] = 2, line = bar.pitch, teeth = 5)"), "teeth"),
        (plane(PLAIN, "rack(module [mm] = 2, line = bar.pitch, line = bar.pitch)"), "is given twice"),
        (plane(PLAIN, "rack(module [mm] = 2, line = bar.pich)"), "pich"),
        (
            plane(PLAIN, RACK)
                .replace("disk pinion", "line floor = (ground(0, 0) [m], ground(1, 0) [m]); disk pinion")
                .replace("line = bar.pitch)", "line = floor)"),
            "`floor` is a line of something else: write a line of `bar`; a rack that rests stands on a body that is `fixed`",
        ),
        (
            plane(PLAIN, RACK).replace("axis = (1, 0)", "axis = (1, 1)"),
            "`bar.teeth` stands at 45 degrees to the travel of `rail`",
        ),
        (
            plane(PLAIN, RACK)
                .replace("joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));", ""),
            "nothing guides `bar.teeth` along `pinion.rim`",
        ),
        (
            rack(PLAIN, RACK, "21", "(1, 0)"),
            "the axis of `pinion.rim` is 21 mm from the line of `bar.teeth`, and without play it is 20 mm: put it there, or write `shift = 0.5`",
        ),
        (
            plane("external(teeth = 20, module [mm] = 3)", RACK),
            "`pinion.rim` has a module of 3 mm and `bar.teeth` one of 2 mm",
        ),
        (
            plane("external(teeth = 20, module [mm] = 2, helix [deg] = 10)", RACK),
            "the helix angles of `pinion.rim` and `bar.teeth` are 10 and 0 degrees",
        ),
        (
            plane("internal(teeth = 40, module [mm] = 2)", RACK),
            "`pinion.rim` is `internal` and `bar.teeth` is `rack`, and these do not mesh: a rack meshes with an `external` wheel",
        ),
        (
            plane(SMALL, LARGE),
            "in the plane all are: declare the mechanism `spatial`, or write the ratio, `bevel(a, b, ratio = …)`",
        ),
        (
            plane(PLAIN, RACK).replace(
                "gear drive: gear(pinion.rim, bar.teeth)",
                "mesh drive: mesh(pinion.rim, bar.teeth, stiffness [N/m] = 1e8, axes = moving)",
            ),
            "axes move between wheels and rings, and of `pinion.rim` and `bar.teeth` one is neither",
        ),
        (
            plane(PLAIN, RACK).replace(
                "gear drive: gear(pinion.rim, bar.teeth)",
                "mesh drive: mesh(pinion.rim, bar.teeth, stiffness = involute(young [GPa] = 210))",
            ),
            "neither `pinion.rim` nor `bar.teeth` says how wide",
        ),
        (
            worm(WORM, WHEEL).replace(
                "gear drive: gear(one.rim, two.rim)",
                "mesh drive: mesh(one.rim, two.rim, stiffness = involute(young [GPa] = 210))",
            ),
            "`involute(…)` is the stiffness of involute teeth, and of `one.rim` and `two.rim` one has threads",
        ),
        (
            cones(PLAIN, SMALL),
            "`one.rim` is `external` and `two.rim` is `bevel`, and these do not mesh: a bevel gear meshes with another",
        ),
        (
            cones("bevel(teeth = 20, module [mm] = 2, cone [deg] = 90)", LARGE),
            "half the angle of the cone of `one.rim` is 90 degrees, and bevel gears have 1 to 89",
        ),
        (
            cones("bevel(teeth = 20, module [mm] = 2, cone [deg] = 45)", LARGE),
            "they roll at 26.565 and 63.435: write `cone [deg] = 26.5650512` and `cone [deg] = 63.4349488`",
        ),
        (
            cones("bevel(teeth = 20, module [mm] = 2, cone = atan2(20, 40), face_width [mm] = 50)", LARGE),
            "the face of `one.rim` is 50 mm wide, and its cone is 44.7213595 mm long",
        ),
        (
            cones("bevel(teeth = 20, module [mm] = 3, cone = atan2(20, 40))", LARGE),
            "the centre of `one.rim` stands 40 mm from where the axes cross, and that of its pitch circle 60 mm",
        ),
        (
            crossed(SMALL, "40, 0, 0", LARGE, "0, 5, 20", "(0, 0, 1)"),
            "the axes of `one.rim` and `two.rim` pass each other 5 mm apart",
        ),
        (
            crossed(SMALL, "0, 0, 0", LARGE, "0, 0, 20", "(0, 0, 1)"),
            "the centres of bevel gears are those of their pitch circles: `one.rim` stands 40 mm",
        ),
        (
            crossed(SMALL, "0, 0, 0", LARGE, "0, 60, 0", "(1, 0, 0)"),
            "are parallel, and cones roll about axes that cross: write `external` toothings",
        ),
        (
            crossed(SMALL, "40, 0, 0", LARGE, "-17, 0, 10", "(-1.7, 0, 1)"),
            "one of the cones would be flat or hollow",
        ),
        (
            worm(WORM, WHEEL).replace("helix = atan2(2, 20)", "helix [deg] = 5"),
            "the lead angle of `one.rim` is 5.7106 degrees, starts times module over diameter being its tangent, and the helix of `two.rim` 5: write `helix [deg] = 5.71059314`, or its opposite",
        ),
        (
            worm(WORM, "external(teeth = 40, module [mm] = 2, helix = atan2(2, 20))"),
            "the second is the first times the cosine of the lead angle, 1.99007438 mm",
        ),
        (
            worm("worm(starts = 20, module [mm] = 2, diameter [mm] = 20)", WHEEL),
            "`one.rim` has 20 starts, and a worm has 1 to 12",
        ),
        (
            worm("worm(starts = 1.5, module [mm] = 2, diameter [mm] = 20)", WHEEL),
            "the starts of `one.rim` are counted, found 1.5",
        ),
        (
            worm("worm(starts = 1, module [mm] = 2, diameter [mm] = 4)", WHEEL),
            "`one.rim` is 4 mm thick, and its threads alone take 5 mm",
        ),
        (
            worm("worm(starts = 1, module [mm] = 2)", WHEEL),
            "`worm` needs `diameter`: write `worm(diameter [mm] = 40, …)`, as in `worm(starts = 1, module [mm] = 2, diameter [mm] = 40)`",
        ),
        (
            crossed(WORM, "0, 0, 0", WHEEL, "0, 50, 0", "(1, 0, 1)"),
            "are at 45 degrees, and a worm drives at right angles",
        ),
        (
            crossed(WORM, "0, 0, 0", WHEEL, "0, 51, 0", "(0, 0, 1)"),
            "the axis of `two.rim` is 51 mm from the axis of `one.rim`, and without play it is 50 mm: put them there",
        ),
        (
            crossed(WORM, "0, 0, 0", WHEEL, "0, 50, 3", "(0, 0, 1)"),
            "the axis of `one.rim` passes 3 mm beside the middle plane of `two.rim`",
        ),
        (worm(WORM, WORM), "a worm meshes with an `external` wheel whose helix is its lead angle"),
        (
            crossed(PLAIN, "0, 0, 0", PLAIN, "0, 40, 0", "(0, 0, 1)"),
            "write `bevel(…)` toothings where they cross, `worm(…)` where they pass each other",
        ),
    ] {
        says(&source, expected);
    }
}

/// A rack may move or rest, be named first, stand on what is fixed to a slide, and pass above its pinion: the ratio is that of its travel.
#[test]
fn racks_wherever_they_stand() {
    let ratio = |source: &str| {
        let mechanism = good(source);
        let pair = &mechanism.pairs[0];
        let (travel, _) = pair.travels[0];
        assert_eq!(pair.terms[0].0, 20.0);
        travel / pair.terms[0].0
    };
    let plain = rack(PLAIN, RACK, "20", "(1, 0)");
    near(ratio(&plain), -50.0, 1e-15);
    near(ratio(&plain.replace("gear(pinion.rim, bar.teeth)", "gear(bar.teeth, pinion.rim)")), -50.0, 1e-15);
    near(ratio(&rack(PLAIN, RACK, "20", "(-1, 0)")), 50.0, 1e-15);
    near(ratio(&rack(PLAIN, RACK, "-20", "(1, 0)")), 50.0, 1e-15);
    let shifted = "external(teeth = 20, module [mm] = 2, shift = 0.5)";
    near(ratio(&rack(shifted, RACK, "21", "(1, 0)")), -50.0, 1e-15);
    // The carriage carries the axle along a rack that rests.
    let carried = plain
        .replace("joint axle: revolute(ground(0, 20) [mm], pinion.center);", "body carriage { mass [kg] = 1; inertia [kg*m^2] = 0.01; point pin [mm] = (0, 20); } joint axle: revolute(carriage.pin, pinion.center);")
        .replace("joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));", "joint held: fixed(ground(0, 0) [mm], bar.center); joint rail: prismatic(ground(0, 0) [mm], carriage.center, axis = (1, 0));");
    near(ratio(&carried), 50.0, 1e-15);
    let on_slide = plain.replace(
        "joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));",
        "body slide { mass [kg] = 1; inertia [kg*m^2] = 0.01; } joint rail: prismatic(slide.center, ground(0, 0) [mm], axis = (0, 1)); joint held: fixed(slide.center, bar.center, angle [deg] = -90);",
    );
    near(ratio(&on_slide.replace("ground(0, 20)", "ground(20, 0)")), -50.0, 1e-14);
}

/// Cones by Tredgold's spur gears, 20/cos δ₁ and 40/cos δ₂ teeth; a rack as r → ∞; 17 teeth on a wide cone are not undercut.
#[test]
fn contact_of_racks_and_cones() {
    let (mechanism, mesh) = pair(&crossed(SMALL, "40, 0, 0", LARGE, "0, 0, 20", "(0, 0, 1)"));
    let spur = |teeth: f64| {
        let (pitch, alpha) = (teeth, 20.0_f64.to_radians());
        ((pitch + 2.0).powi(2) - (pitch * alpha.cos()).powi(2)).sqrt() - pitch * alpha.sin()
    };
    let (small, large) = (20.0 * 1.25_f64.sqrt(), 40.0 * 5.0_f64.sqrt());
    near(
        mesh.contact_ratio,
        (spur(small) + spur(large)) / (std::f64::consts::TAU * 20.0_f64.to_radians().cos()),
        1e-12,
    );
    assert_eq!(Told::of(&mechanism, &mechanism.pairs[0]).hunting, Some(2.0));
    let (mechanism, mesh) = pair(&rack(PLAIN, RACK, "20", "(1, 0)"));
    let alpha = 20.0_f64.to_radians();
    near(mesh.contact_ratio, (spur(20.0) + 2.0 / alpha.sin()) / (std::f64::consts::TAU * alpha.cos()), 1e-12);
    assert_eq!(Told::of(&mechanism, &mechanism.pairs[0]).hunting, None);
    let (mechanism, _) = pair(&crossed(WORM, "0, 0, 0", WHEEL, "0, 50, 0", "(0, 0, 1)"));
    // tan γ cos α.
    near(Told::of(&mechanism, &mechanism.pairs[0]).locking.expect("a worm"), 0.1 * alpha.cos(), 1e-12);
    let miter = |teeth: &str, at: &str| {
        let wheel = format!("bevel(teeth = {teeth}, module [mm] = 2, cone [deg] = 45)");
        let source = crossed(&wheel, &format!("{at}, 0, 0"), &wheel, &format!("0, 0, {at}"), "(0, 0, 1)");
        warnings(&source).iter().map(|warning| warning.message.clone()).collect::<Vec<_>>()
    };
    assert!(miter("13", "13").is_empty(), "{:?}", miter("13", "13"));
    let found = miter("11", "11");
    assert!(found[0].contains("with 11 teeth on its cone it is like a spur gear of 15.556"), "{found:?}");
}

/// z 50/50 of 3 mm with 0.0075 kg m² each: r_b = 70.477 mm, m_e = I/(2 r_b²) = 0.7550 kg, 3663 Hz on 4e8 N/m; along the pitch circle a gap is wider by 1/cos α. On a rack 1/(r_b²/I + cos² α/M).
#[test]
fn teeth_by_themselves() {
    let pair = "planar Pair { body one { mass [kg] = 1; inertia [kg*m^2] = 0.0075; toothing rim: external(teeth = 50, module [mm] = 3); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 0.0075; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint a: revolute(ground(0, 0), one.center); joint b: revolute(ground(150, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 4e8, backlash [um] = 40); }";
    let of = |source: &str| Gives::all(&good(source)).remove(0);
    let (cosine, gives) = (20.0_f64.to_radians().cos(), of(pair));
    let base = 75e-3 * cosine;
    near(gives.mass.expect("two wheels"), 0.0075 / (2.0 * base * base), 1e-12);
    near(gives.hertz().expect("a number"), 3663.0, 2e-4);
    near(gives.backlash[1], 40e-6 / cosine, 1e-12);
    let by_time = pair.replace("stiffness [N/m] = 4e8", "stiffness = 4e8 [N/m]*(1 + 0.1*cos(one.angle))");
    assert!(of(&by_time).stiffness.is_none() && of(&by_time).hertz().is_none());
    let rack = rack(PLAIN, RACK, "20", "(1, 0)").replace("gear drive: gear(", "mesh drive: mesh(");
    let gives = of(&rack.replace("bar.teeth);", "bar.teeth, stiffness [N/m] = 1e8);"));
    let pinion = (20e-3 * cosine).powi(2) / (0.5 * 1.0 * 20e-3 * 20e-3);
    near(gives.mass.expect("a pinion and a bar"), 1.0 / (pinion + cosine * cosine / 1.0), 1e-12);
    let worm = crossed(WORM, "0, 0, 0", WHEEL, "0, 50, 0", "(0, 0, 1)").replace(
        "gear drive: gear(one.rim, two.rim)",
        "mesh drive: mesh(one.rim, two.rim, stiffness [N/m] = 1e8, backlash [um] = 10)",
    );
    // The normal of its threads is cos α cos γ along the axis: 20 degrees, tan γ = 0.1.
    near(of(&worm).backlash[1], 10e-6 / (cosine * 0.1_f64.atan().cos()), 1e-12);
}
