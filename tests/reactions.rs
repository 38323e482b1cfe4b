//! Reactions of joints as quantities of a definition, and along a run.

use linkwright::{Assemble, AssembleExt, Fields, Mechanism, Report, Simulation, StateOf, Vector};

macro_rules! crank_drive {
    ($name:ident, $coordinates:ident) => {
        linkwright::mechanism! {
            /// A slider-crank whose slider rubs as hard as it is pressed, by way of a state.
            planar $name {
                input push [N];
                gravity [m/s^2] = (0, -9.81);
                state pressed [N] = 0;
                rate pressed = (abs(rail.reaction.normal) - pressed)/0.01 [s];
                rod crank { mass [kg] = 0.4; length [m] = 0.1; }
                rod link { mass [kg] = 0.6; length [m] = 0.3; }
                body slider { mass [kg] = 0.5; inertia [kg*m^2] = 1e-3; }
                joint pin: revolute(ground(0, 0) [m], crank.start);
                joint knee: revolute(crank.end, link.start);
                joint wrist: revolute(link.end, slider.center);
                joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (3, 4));
                force drive: force(slider.center, direction = (1, 0)) = push;
                force rub: force(rail) = -0.1*pressed*sign(rail.speed);
                start { pin.angle [rad] = 2; pin.rate [rad/s] = 3; rail.travel [m] ~ 0.3; }
                options { coordinates = $coordinates; }
                output pin_x [N] = pin.reaction.x;
                output pin_y [N] = pin.reaction.y;
                output pin_size [N] = pin.reaction.size;
                output normal [N] = rail.reaction.normal;
                output torque [N*m] = rail.reaction.torque;
                output knee_x [N] = knee.reaction.x;
            }
        }
    };
}
crank_drive!(OnTree, tree);
crank_drive!(Absolute, absolute);

linkwright::mechanism! {
    /// A bar on a ball, held by a rope's pull.
    spatial Hung {
        gravity [m/s^2] = (0, 0, -9.81);
        rod bar { mass [kg] = 2; length [m] = 1; radius [mm] = 20; }
        joint socket: fixed(ground(0, 0, 0) [m], bar.start);
        output up [N] = socket.reaction.z;
        output size [N] = socket.reaction.size;
        output bend [N*m] = socket.reaction.torque.y;
        output twist [N*m] = socket.reaction.torque.x;
    }
}

fn outputs_are_what_is_reported<M>(model: &M, u: &M::Inputs)
where
    M: Assemble<f64, Outputs: Fields<f64>> + Report<f64, Reaction = linkwright::Reaction<f64>>,
{
    let mut simulation = Simulation::new(model, model.start()).held(|_, _| u.clone()).step(1e-3);
    simulation
        .run_until(0.3, |sample| {
            let reactions = sample.reactions().expect("a regular position");
            let of = |joint: &str| {
                let at = model.joints().iter().position(|name| *name == joint).expect("a joint");
                (reactions.as_ref()[at].force, reactions.as_ref()[at].torque)
            };
            let ([x, y], _) = of("pin");
            let ([rail_x, rail_y], torque) = of("rail");
            // The axis is (3, 4)/5, its normal (−4, 3)/5.
            let normal = -0.8 * rail_x + 0.6 * rail_y;
            let expected = [x, y, x.hypot(y), normal, torque, of("knee").0[0]];
            let found = sample.outputs.to_array();
            for (found, expected) in found.as_slice().iter().zip(expected) {
                assert!((found - expected).abs() < 1e-10 * (1.0 + expected.abs()), "{found} {expected}");
            }
        })
        .expect("it moves");
}

#[test]
fn reactions_are_outputs() {
    outputs_are_what_is_reported(&OnTree::default(), &OnTreeInputs { push: 4.0 });
    outputs_are_what_is_reported(&Absolute::default(), &AbsoluteInputs { push: 4.0 });
}

/// The state that follows the normal force, in both sets of coordinates.
#[test]
fn a_rate_may_name_a_reaction() {
    fn pressed<M: Assemble<f64>>(model: &M, u: M::Inputs) -> f64 {
        let mut simulation = Simulation::new(model, model.start()).held(move |_, _| u.clone()).step(1e-4);
        let state: StateOf<M> = simulation.advance_until(0.2).expect("it moves");
        state.z.as_slice()[0]
    }
    let tree = pressed(&OnTree::default(), OnTreeInputs { push: 4.0 });
    let absolute = pressed(&Absolute::default(), AbsoluteInputs { push: 4.0 });
    assert!(tree > 0.1, "{tree}");
    assert!((tree - absolute).abs() < 1e-6 * tree, "{tree} {absolute}");
}

#[test]
fn a_reaction_in_space() {
    let model = Hung::<f64>::default();
    let outputs: HungOutputs = model.outputs(0.0, &model.start(), &());
    let weight = 2.0 * 9.81;
    for (found, expected) in [
        (outputs.up, weight),
        (outputs.size, weight),
        (outputs.twist, 0.0),
        (outputs.bend.abs(), 0.5 * weight),
    ] {
        assert!((found - expected).abs() < 1e-12 * weight, "{found} {expected}");
    }
}
