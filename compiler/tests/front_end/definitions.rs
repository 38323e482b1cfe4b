//! Whole mechanisms.

use crate::good;
use linkwright_compiler::equations::VOCABULARY;
use linkwright_compiler::forms::{Factor, Law, LoadForm, Means, Value};
use linkwright_compiler::model::{
    Budgeted, ConstraintKind, Coordinate, Coordinates, Coupled, Expr, Frame, Quantity, Rotor, Space, Subject,
};

/// The first example of the language.
pub const QUICK_RETURN: &str = "
/// Quick-return mechanism, rigid parts.
pub planar QuickReturn {
    const GUIDE [m] = 0.4;                      // known at expansion
    param flywheel [kg*m^2] = 1.26069;          // may change at run time
    input drive [N*m];                          // changes at every call
    input cutting [N];

    body crank   { mass [kg] = 0.368; inertia [kg*m^2] = flywheel;
                   point pivot [m] = (-0.075, 0); point tip [m] = (0.075, 0); }
    body guide   { mass [kg] = 0.551; inertia [kg*m^2] = 0.00735;
                   point pivot [m] = (-GUIDE/2, 0); point tip [m] = (GUIDE/2, 0);
                   line slot = (guide.pivot, guide.tip); }
    rod  coupler { mass [kg] = 0.105; length [m] = 0.35; }         // points start, center, end
    body slider  { mass [kg] = 2.206; inertia [kg*m^2] = 0.00184; }

    joint crank_pin: revolute(ground(0, 0) [m], crank.pivot);
    joint guide_pin: revolute(ground(0, -0.2) [m], guide.pivot);
    joint block:     point_on_line(guide.slot, crank.tip);
    joint knee:      revolute(guide.tip, coupler.end);
    joint wrist:     revolute(coupler.start, slider.center);
    joint rail:      prismatic(ground(0, 0.2) [m], slider.center, axis = (1, 0));

    force motor: torque(crank_pin) = drive;
    force cut:   force(slider.center, direction = (1, 0)) = cutting;

    start   { crank_pin.angle [rad] = 5.435123228198105; crank_pin.rate [rad/s] = 15;
              guide_pin.angle [rad] ~ 0.7; rail.travel [m] ~ -0.02; }
    options { coordinates = auto; redundant = refuse; }
    expect  { degrees_of_freedom = 1; operations <= 400; }
    output stroke [m] = slider.center.x;
}";

pub const FOUR_BAR: &str = "
planar FourBar {
    gravity [m/s^2] = (0, -9.81);
    rod crank   { mass [kg] = 1; length [m] = 1; }
    rod coupler { mass [kg] = 3; length [m] = 3; }
    rod rocker  { mass [kg] = 2; length [m] = 2; }
    joint a: revolute(ground(0, 0), crank.start);
    joint b: revolute(crank.end, coupler.start);
    joint c: revolute(coupler.end, rocker.end);
    joint d: revolute(ground(3, 0) [m], rocker.start);
    start { a.angle [deg] = 90; a.rate [rpm] = 30; b.angle ~ -1 [rad]; }
}";

fn number(expr: &Expr) -> f64 {
    match expr {
        Expr::Number(value) => *value,
        other => panic!("expected a number, found {other:?}"),
    }
}

#[test]
fn quick_return() {
    let m = good(QUICK_RETURN);
    assert_eq!(m.name.text, "QuickReturn");
    assert_eq!(m.visibility.to_string(), "pub");
    assert!(m.attributes.to_string().contains("Quick-return"));
    assert_eq!((m.parameters.len(), m.inputs.len(), m.bodies.len(), m.joints.len()), (1, 2, 4, 6));
    assert_eq!(m.parameters[0].default, 1.26069);
    assert_eq!(m.parameters[0].unit.text, "kg*m^2");

    assert!(matches!(m.bodies[0].inertia.moments[2], Expr::Parameter(_)));
    let guide = &m.bodies[1];
    assert_eq!(number(&guide.points[0].at[0]), -0.2);
    assert_eq!(number(&guide.lines[0].to[0]), 0.2);
    let coupler = &m.bodies[2];
    assert_eq!(number(&coupler.inertia.moments[2]), 0.105 * (0.35 * 0.35) / 12.0);
    assert_eq!(coupler.points[0].name.text, "start");
    assert_eq!(number(&coupler.points[1].at[0]), 0.175);

    assert_eq!(m.joints[2].word(), "point_on_line");
    let direction = m.joints[2].direction(0);
    assert_eq!((number(&direction[0]), number(&direction[1])), (0.4, 0.0));
    assert_eq!(m.joints[2].first.text, "guide.slot");
    assert_eq!(m.joints[0].first.frame, Frame::Ground);
    assert_eq!(m.joints[1].first.text, "ground(0, -0.2)");
    assert!(m.joints.iter().any(|joint| joint.word() == "prismatic"));

    let [torque, force] = [&m.loads[0], &m.loads[1]];
    assert_eq!((torque.form.title, force.form.title), ("torque", "force"));
    assert!(matches!(
        (&torque.on[..], &torque.law[..]),
        ([Subject::Rotor(Rotor::Joint(..))], [Expr::Input(_)])
    ));
    assert!(matches!(force.law[0], Expr::Input(_)));
    assert_eq!(number(&force.law[1]), 0.0);

    assert_eq!(m.start.iter().map(|start| start.exact).collect::<Vec<_>>(), [true, true, false, false]);
    assert_eq!(m.start[3].text, "rail.travel");
    assert_eq!(m.options.coordinates, Coordinates::Auto);
    assert_eq!(m.expect.degrees_of_freedom.map(|(count, _)| count), Some(1));
    assert_eq!(m.expect.budgets[0].limit, 400);
    assert!(
        matches!(&m.outputs[0].value, Expr::Quantity(Quantity::Coordinate(Coordinate::Position(place, 0))) if place.text == "slider.center")
    );
}

#[test]
fn four_bar_in_degrees_and_rpm() {
    let m = good(FOUR_BAR);
    assert_eq!(number(&m.start[0].value), 90.0 * (core::f64::consts::PI / 180.0));
    assert!((number(&m.start[1].value) - core::f64::consts::PI).abs() < 1e-15);
    assert_eq!(number(&m.gravity.expect("gravity was written")[1]), -9.81);
    assert_eq!(number(&m.bodies[1].inertia.moments[2]), 3.0 * 9.0 / 12.0);
}

#[test]
fn every_kind_of_body_joint_constraint_and_load() {
    let m = good(
        "planar All {
            param k [N/m] = 100;
            disk wheel { mass [kg] = 2; radius [m] = 0.5; }
            box table { mass [kg] = 12; width [m] = 2; height [m] = 1; point corner [mm] = (1000, 500); }
            body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; center [m] = (0.2, 0); point tip = (300, 0) [mm]; }
            particle bob { mass [g] = 500; }
            body plate { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
            joint hub: revolute(ground(0, 1) [m], wheel.center);
            joint rail: prismatic(ground(0, 0), table.center, axis = (1, 1), angle [deg] = 45);
            joint weld: fixed(table.corner, arm.origin, angle = 0.5 [rad]);
            joint string: distance(arm.tip, bob.center, length = 30 [cm]);
            joint track: point_on_line(line(ground(0, 0), ground(1 [m], 2 [m])), plate.center);
            constraint rolls: rack(hub, rail, radius = 0.5 [m]);
            constraint turns: gear(hub, track, ratio = -2, phase [deg] = 90);
            gear again: gear(plate, wheel, ratio = 3);
            constraint eq: plate.angle - 2*hub.angle = 0;
            drive turn: hub.angle = 15 [rad/s] * time;
            spring s: spring(arm.tip, ground(1, 1) [m], stiffness = k, length [mm] = 100, damping = 2 [N*s/m]);
            damper d: damper(bob.center, plate.center, damping = 3 [kg/s]);
            torsion_spring t: torsion_spring(hub, stiffness = 5 [N*m/rad], angle = 10 [deg], damping = 1 [N*m*s/rad]);
            force f: force(bob.center, direction = (3, 4)) = 10 [N];
            force g: force(arm.tip) = (1, 2) [N];
            torque m: torque(arm) = -0.1 [N*m*s] * arm.rate;
            options { coordinates = tree; cut = (string, track); independent = (hub.angle, rail.travel); crate = ::other::path; }
            expect { operations(mass_matrix) <= 40; live_values <= 64; }
            output effort [N*m] = turn.effort;
            output power [W] = turn.power + power(s);
            output energy [J] = energy - kinetic_energy - potential_energy;
        }",
    );
    let inertias: Vec<f64> = m.bodies.iter().map(|body| number(&body.inertia.moments[2])).collect();
    assert_eq!(inertias, [0.25, 5.0, 0.1, 0.0, 0.1]);
    assert!(!m.bodies[3].form.turns);
    assert_eq!(number(&m.bodies[3].mass), 0.5);
    assert_eq!(number(&m.bodies[1].points[0].at[1]), 0.5);
    assert_eq!(number(&m.bodies[2].points[0].at[0]), 0.3);
    assert!(m.joints[2].word() == "fixed" && number(m.joints[2].scalar(0)) == 0.5);
    assert!(m.joints[3].word() == "distance" && number(m.joints[3].scalar(0)) == 0.3);
    let coupling = |index: usize| match &m.constraints[index].kind {
        ConstraintKind::Coupling(coupling) => coupling,
        other => panic!("{other:?}"),
    };
    assert_eq!((coupling(1).form.call.word, number(&coupling(1).factor)), ("gear", -2.0));
    assert_eq!(coupling(1).phase.as_ref().map(number), Some(core::f64::consts::FRAC_PI_2));
    assert!(matches!(coupling(2).driven(), Coupled::Angle(Rotor::Body(_))) && coupling(2).phase.is_none());
    let force = &m.loads[3];
    assert_eq!((force.form.title, number(&force.law[0]), number(&force.law[1])), ("force", 6.0, 8.0));
    assert_eq!(m.options.crate_path.expect("a path").to_string().replace(' ', ""), "::other::path");
    assert_eq!(m.options.cut.len(), 2);
    assert_eq!(m.expect.budgets[0].function.as_deref(), Some("mass_matrix"));
    assert_eq!((m.expect.budgets[1].of, m.expect.budgets[1].limit), (Budgeted::LiveValues, 64));
    assert!(matches!(m.outputs[0].value, Expr::Quantity(Quantity::DriverEffort(_))));
}

#[test]
fn repeat_unrolls_with_integer_indices() {
    let m = good(
        "planar Ladder {
            const N = 4;
            repeat i in 0..N {
                rod upright[i] { mass [kg] = 1; length [m] = 1; }
                joint foot[i]: revolute(ground(2*i, 0) [m], upright[i].start);
                start { foot[i].angle [deg] = 90 + i; }
                output height[i] [m] = upright[(i + N) / 2 - N/2].end.y;
            }
            repeat i in 0..N-1 {
                rod rung[i] { mass [kg] = 1; length [m] = 2; }
                joint left[i]: revolute(upright[i].end, rung[i].start);
                joint right[i]: revolute(rung[i].end, upright[i+1].end);
            }
        }",
    );
    assert_eq!((m.bodies.len(), m.joints.len()), (7, 10));
    assert_eq!(m.bodies[3].name.text, "upright[3]");
    assert_eq!(m.bodies[3].name.identifier(), "upright_3");
    assert_eq!(number(&m.joints[3].first.at[0]), 6.0);
    assert_eq!(m.start[2].text, "foot[2].angle");
    assert_eq!(number(&m.start[2].value), 92.0 * (core::f64::consts::PI / 180.0));
    // (3 + 4)/2 − 4/2 = 1 in integers.
    assert!(
        matches!(&m.outputs[3].value, Expr::Quantity(Quantity::Coordinate(Coordinate::Position(p, 1))) if p.text == "upright[1].end")
    );
}

/// A range without numbers has no rounds, as of a chain without links, or of the last of the pairs i < j.
#[test]
fn repeat_without_rounds() {
    let empty = good(
        "planar A { const N = 0; repeat i in 0..N { rod gone[i] { mass [kg] = 1; } } rod r { mass [kg] = 1; length [m] = 1; } }",
    );
    assert_eq!(empty.bodies.len(), 1);
    let pairs = "planar A {
        repeat i in 0..3 { rod r[i] { mass [kg] = 1; length [m] = 1; } }
        repeat i in 0..3 { repeat j in i + 1..2 { joint pin[i][j]: revolute(r[i].end, r[j].end); } }
    }";
    assert_eq!(good(pairs).joints.len(), 1);
}

#[test]
fn nested_repeats_and_indexed_declarations() {
    let m = good(
        "planar Grid {
            repeat i in 0..2 { repeat j in 1..3 {
                param mass[i][j] [kg] = 1 + i + j/2;
                input push[i][j] [N];
                particle node[i][j] { mass [kg] = mass[i][j]; }
                force f[i][j]: force(node[i][j].center, direction = (i, j)) = push[i][j];
            } }
        }",
    );
    let names: Vec<&str> = m.parameters.iter().map(|p| p.name.text.as_str()).collect();
    assert_eq!(names, ["mass[0][1]", "mass[0][2]", "mass[1][1]", "mass[1][2]"]);
    // Outside of index brackets `/` divides real numbers.
    assert_eq!(m.parameters[0].default, 1.5);
}

#[test]
fn moving_ground_places_and_indexed_points() {
    let m = good(
        "planar Shaken {
            param a [m] = 0.1;
            repeat i in 0..2 {
                body arm[i] { mass [kg] = 1; inertia [kg*m^2] = 1; point p[0] [m] = (1, 0); point p[1] [m] = (2, 0); }
                joint pin[i]: revolute(ground(a*sin(3 [rad/s]*time), 0), arm[i].p[0]);
                start { arm[i].p[1].y [mm] ~ 300; arm[i].p[i].velocity.x [m/s] = i; }
            }
            force swing: torque(pin[0]) = -2 [N*m*s/rad]*pin[0].rate + 3 [N] * (arm[1].p[1].x - a);
        }",
    );
    assert!(matches!(m.joints[0].first.at[0], Expr::Binary(..)));
    assert_eq!(m.start[2].text, "arm[1].p[1].y");
    assert_eq!(number(&m.start[2].value), 300.0 * 1e-3);
    assert!(m.start[3].rate);
    assert!(matches!(&m.start[3].coordinate, Coordinate::Position(place, 0) if place.text == "arm[1].p[1]"));
}

#[test]
fn tokens_from_macros_keep_their_grouping() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    let source = "planar T { param p [1] = 2 * SUM; body b { mass [kg] = 1; inertia [kg*m^2] = 1; } }";
    let sum: TokenStream = "1 + 2".parse().expect("tokens");
    let replaced =
        replace(source.parse().expect("tokens"), &TokenTree::Group(Group::new(Delimiter::None, sum)));
    let definition = linkwright_compiler::parse(replaced).expect("a definition");
    let mechanism = linkwright_compiler::model::lower(&definition).expect("a mechanism");
    assert_eq!(mechanism.parameters[0].default, 6.0);

    fn replace(stream: TokenStream, by: &TokenTree) -> TokenStream {
        let tree = |tree| match tree {
            TokenTree::Ident(ident) if ident == "SUM" => by.clone(),
            TokenTree::Group(group) => {
                TokenTree::Group(Group::new(group.delimiter(), replace(group.stream(), by)))
            }
            other => other,
        };
        stream.into_iter().map(tree).collect()
    }
}

#[test]
fn the_header_survives_errors_in_the_body() {
    let tokens = "#[doc = \"x\"] pub(crate) planar Broken { body ??? }".parse().expect("tokens");
    let header = linkwright_compiler::header(tokens, &|_| None).expect("a header");
    assert_eq!(header.name.to_string(), "Broken");
    assert_eq!(header.visibility.to_string().replace(' ', ""), "pub(crate)");
}

/// What a joint is given is one number for each argument that is no direction.
#[test]
fn arguments_of_joints_are_single_numbers() {
    for space in [Space::Planar, Space::Spatial] {
        for joint in (VOCABULARY.joints)(space) {
            let mut arguments = joint.call.named.iter();
            assert!(
                arguments.all(|argument| !matches!(argument.value, Value::Diagonal(_))),
                "{}",
                joint.call.word
            );
        }
    }
}

/// Every load says what each of its unnamed arguments names; of those with one word, one is meant where no other is.
#[test]
fn forms_of_loads_agree() {
    for space in [Space::Planar, Space::Spatial] {
        let loads = (VOCABULARY.loads)(space);
        for load in &loads {
            let call = &load.call;
            // What friction acts in stands before its law.
            let before = usize::from(load.rubs);
            assert_eq!(call.positional.len() + before, load.on.len(), "{}", call.word);
            let of_word = loads.iter().filter(|other| other.call.word == call.word);
            assert_eq!(of_word.clone().filter(|other| other.meant.is_none()).count(), 1, "{}", call.word);
            let same = |other: &&LoadForm| format!("{:?}", other.call) == format!("{call:?}");
            assert!(of_word.clone().all(same), "{}", call.word);
            let has_law = |other: &LoadForm| other.law != Law::None;
            assert!(of_word.clone().all(|other| has_law(other) == has_law(load)), "{}", call.word);
            assert!(!load.stores || !has_law(load), "{}", call.word);
        }
    }
}

/// Factors and sums of couplings are of arguments that they have.
#[test]
fn forms_of_couplings_agree() {
    for coupling in VOCABULARY.couplings {
        let call = &coupling.call;
        let is_required = |name: &str| {
            let argument = call.named.iter().find(|argument| argument.name == name);
            assert!(argument.is_some_and(|argument| argument.is_required()), "{}: {name}", call.word);
        };
        match coupling.means {
            Means::Proportion { kind, factor } => {
                assert_eq!(call.positional.len(), kind.on.len(), "{}", call.word);
                let phase = call.named.iter().find(|argument| argument.name == "phase");
                assert_eq!(phase.and_then(|phase| phase.dimension()), Some(kind.phase), "{}", call.word);
                match factor {
                    Factor::Argument(name) | Factor::PerTurn(name) => is_required(name),
                    Factor::Quotient { of, to } => [of, to].into_iter().for_each(is_required),
                }
            }
            Means::Sum { of, by, .. } => {
                assert!([of[0], of[1], by].iter().all(|which| *which < call.positional.len()));
            }
            Means::Teeth { row } => {
                assert!(
                    call.positional.iter().all(|it| format!("{it:?}") == "Toothing") && row.name == "teeth"
                );
            }
        }
    }
}
