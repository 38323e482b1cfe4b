//! Teeth of racks, cones and worms that give: the forces that text books have on bearings and rails, a rack as a wheel without end, energies. And teeth about axles that are turned round.

use super::Worst;
use linkwright::{Mechanism, Simulation, Variables, retract};
use std::f64::consts::{PI, TAU};

linkwright::mechanism! {
    /// Above its rack; the start presses the teeth into each other.
    planar PressedRack {
        body pinion { mass [kg] = 0.8; inertia [kg*m^2] = 2e-4; toothing rim: external(teeth = 20, module [mm] = 2); }
        body bar { mass [kg] = 2; inertia [kg*m^2] = 0.01; point near [mm] = (-95, 0); point far [mm] = (95, 0);
                   line pitch = (bar.near, bar.far); toothing teeth: rack(module [mm] = 2, line = bar.pitch); }
        joint axle: revolute(ground(0, 20) [mm], pinion.center);
        joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));
        mesh teeth: mesh(bar.teeth, pinion.rim, stiffness [N/m] = 1e7);
        start { axle.angle [rad] = 0.3; rail.travel [mm] = 7.7; }
        output force [N] = teeth.force;
        output axle_x [N] = axle.reaction.x;
        output axle_y [N] = axle.reaction.y;
        output rail_x [N] = rail.reaction.x;
        output rail_y [N] = rail.reaction.y;
        output rail_torque [N*m] = rail.reaction.torque;
        output all [J] = energy;
    }
}

/// The pinion pushes its rack by F_t and away by F_t tan α, at the pitch point.
#[test]
fn rails_of_a_rack() {
    let model = PressedRack::<f64>::default();
    let outputs = model.outputs(0.0, &PressedRack::START, &());
    let along = outputs.force * (PI / 9.0).cos();
    assert!(along.abs() > 10.0, "{along} N");
    let apart = along.abs() * (PI / 9.0).tan();
    let mut worst = Worst::default();
    for (found, expected) in [
        (outputs.axle_x, along),
        (outputs.axle_y, -apart),
        (outputs.rail_x, 0.0),
        (outputs.rail_y, apart),
        (outputs.rail_torque, -7.7e-3 * apart),
    ] {
        worst.see(found / along, expected / along);
    }
    worst.below(1e-9, "axle and rail of a rack");
}

linkwright::mechanism! {
    spatial PressedCones {
        body small { mass [kg] = 0.4; inertia [kg*m^2] = (1e-4, 2e-4, 1.5e-4); toothing rim: bevel(teeth = 20, module [mm] = 2, cone = atan2(20, 40), face_width [mm] = 12); }
        body large { mass [kg] = 0.7; inertia [kg*m^2] = (4e-4, 3e-4, 5e-4); toothing rim: bevel(teeth = 40, module [mm] = 2, cone = atan2(40, 20), face_width [mm] = 14); }
        joint front: revolute(ground(40, 0, 0) [mm], small.center, axis = (1, 0, 0));
        joint back:  revolute(ground(0, 0, 20) [mm], large.center, axis = (0, 0, 1));
        mesh teeth: mesh(small.rim, large.rim, stiffness [N/m] = 1e7);
        start { front.angle [rad] = 0.3; back.angle [rad] = 0.02; }
        output force [N] = teeth.force;
        output x [N] = front.reaction.x;
        output y [N] = front.reaction.y;
        output z [N] = front.reaction.z;
        output tilt [N*m] = front.reaction.torque.y;
        output swing [N*m] = front.reaction.torque.z;
        output all [J] = energy;
    }
}

/// In the middle of the face act W_t, W_r = W_t tan φ cos γ and W_a = W_t tan φ sin γ on the pinion (Shigley's Mechanical Engineering Design, 13-15).
#[test]
fn bearings_of_cones() {
    let model = PressedCones::<f64>::default();
    let outputs = model.outputs(0.0, &PressedCones::START, &());
    let (angle, cone) = (PI / 9.0, 20f64.atan2(40.0));
    let along = outputs.force * angle.cos();
    assert!(along.abs() > 10.0, "{along} N");
    let (radial, axial) = (along.abs() * angle.tan() * cone.cos(), along.abs() * angle.tan() * cone.sin());
    let middle = 1.0 - 6.0 / 40f64.hypot(20.0);
    let arm = [40e-3 * (middle - 1.0), 20e-3 * middle];
    let mut worst = Worst::default();
    for (found, expected) in [
        (outputs.x, -axial),
        (outputs.y, -along),
        (outputs.z, radial),
        (outputs.tilt, -(arm[1] * axial + arm[0] * radial)),
        (outputs.swing, -arm[0] * along),
    ] {
        worst.see(found / along, expected / along);
    }
    worst.below(1e-9, "bearings of cones");
}

linkwright::mechanism! {
    spatial PressedWorm {
        const LEAD [rad] = atan2(2, 20);
        body screw { mass [kg] = 0.3; inertia [kg*m^2] = (5e-5, 5e-5, 2e-5); toothing thread: worm(starts = 1, module [mm] = 2, diameter [mm] = 20, first [rad] = 0.4); }
        body wheel { mass [kg] = 0.6; inertia [kg*m^2] = (3e-4, 5e-4, 3e-4); toothing rim: external(teeth = 40, module = 2 [mm]*cos(LEAD), helix = LEAD, first [deg] = 3); }
        joint front: revolute(ground(-30, 0, 0) [mm], screw.center, axis = (1, 0, 0));
        joint back: revolute(ground(0, 50, 0) [mm], wheel.center, axis = (0, 0, 1));
        mesh teeth: mesh(screw.thread, wheel.rim, stiffness [N/m] = 1e7);
        start { front.angle [rad] = 0.3; back.angle [rad] = 0.05; }
        output force [N] = teeth.force;
        output x [N] = back.reaction.x;
        output y [N] = back.reaction.y;
        output z [N] = back.reaction.z;
        output roll [N*m] = back.reaction.torque.x;
        output front_pitch [N*m] = front.reaction.torque.z;
        output all [J] = energy;
    }
}

/// W cos φ_n sin λ, W sin φ_n and W cos φ_n cos λ on the wheel of a worm without friction (Shigley, 13-17), at the pitch point, which is 30 mm from the middle of the worm.
#[test]
fn bearings_of_a_worm() {
    let model = PressedWorm::<f64>::default();
    let outputs = model.outputs(0.0, &PressedWorm::START, &());
    let (angle, lead) = (PI / 9.0, 2f64.atan2(20.0));
    let force = outputs.force;
    assert!(force.abs() > 10.0, "{force} N");
    let (x, z) = (force * angle.cos() * lead.cos(), force * angle.cos() * lead.sin());
    let y = force.abs() * angle.sin();
    let mut worst = Worst::default();
    for (found, expected) in [
        (outputs.x, x),
        (outputs.y, -y),
        (outputs.z, -z),
        (outputs.roll, 40e-3 * z),
        (outputs.front_pitch, 30e-3 * y + 10e-3 * x),
    ] {
        worst.see(found / force, expected / force);
    }
    worst.below(1e-9, "bearings of a worm");
}

/// What is pressed together springs back with all of its energy.
#[test]
fn racks_cones_and_worms_keep_their_energy() {
    let mut worst = Worst::default();
    macro_rules! swing {
        ($($name:ident),*) => {$({
            let model = $name::<f64>::default();
            let mut simulation = Simulation::new(&model, $name::START).step(1e-6);
            let start = model.outputs(0.0, &$name::START, &()).all;
            let mut turned_round = 0;
            let mut before = model.outputs(0.0, &$name::START, &()).force;
            for _ in 0..3000 {
                simulation.advance().expect("teeth turn");
                let outputs = model.outputs(simulation.time(), simulation.state(), &());
                worst.see(outputs.all / start, 1.0);
                turned_round += usize::from(before * outputs.force < 0.0);
                before = outputs.force;
            }
            assert!(turned_round > 2, "{}: {turned_round}", stringify!($name));
        })*};
    }
    swing!(PressedRack, PressedCones, PressedWorm);
    worst.below(1e-8, "energy of racks, cones and worms");
}

macro_rules! on_a_wheel {
    ($name:ident, $([$($part:tt)*])*, $partner:ident) => {
        linkwright::mechanism! {
            planar $name {
                #[allow(teeth)]
                body pinion { mass [kg] = 0.8; inertia [kg*m^2] = 2e-4; toothing rim: external(teeth = 20, module [mm] = 2, shift = 0.25, face_width [mm] = 20, first [deg] = 2); }
                joint axle: revolute(ground(0, 20.5) [mm], pinion.center);
                $($($part)*)*
                #[allow(teeth)]
                mesh teeth: mesh(pinion.rim, partner.$partner, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8));
                start { axle.angle [rad] = 0; }
                output phase [1] = teeth.phase;
                output pairs [1] = teeth.pairs;
                output stiffness [N/um] = teeth.stiffness;
            }
        }
    };
}
on_a_wheel!(OnARack,
    [body partner { mass [kg] = 2; inertia [kg*m^2] = 0.01; point near [mm] = (-95, 0); point far [mm] = (95, 0); line pitch = (partner.near, partner.far);
                    toothing teeth: rack(module [mm] = 2, line = partner.pitch, face_width [mm] = 20); }]
    [joint rail: prismatic(ground(0, 0) [mm], partner.center, axis = (1, 0));],
    teeth);
on_a_wheel!(OnALargeWheel,
    [body partner { mass [kg] = 2; inertia [kg*m^2] = 1e4; toothing rim: external(teeth = 10000, module [mm] = 2, face_width [mm] = 20); }]
    [joint rail: revolute(ground(0, -10) [m], partner.center);],
    rim);

/// A rack is a wheel of ten thousand teeth, but for a thousandth: phase, pairs and stiffness as the pinion turns over a pitch.
#[test]
fn a_rack_is_a_wheel_without_end() {
    let (rack, wheel) = (OnARack::<f64>::default(), OnALargeWheel::<f64>::default());
    let (mut one, mut other) = (OnARack::START, OnALargeWheel::START);
    let (mut worst, mut unlike) = (Worst::default(), 0);
    let pinion = |names: &[&str]| {
        let at = names.iter().position(|name| name.starts_with("axle") || name.starts_with("pinion"));
        at.expect("the pinion's rate")
    };
    for step in 0..40 {
        let angle = TAU / 20.0 * f64::from(step) / 40.0;
        let mut delta = OnARack::START.v;
        delta[pinion(rack.velocity_names())] = angle;
        retract(rack.layout(), &OnARack::START.q, &delta, &mut one.q);
        let mut delta = OnALargeWheel::START.v;
        delta[pinion(wheel.velocity_names())] = angle;
        retract(wheel.layout(), &OnALargeWheel::START.q, &delta, &mut other.q);
        let (a, b) = (rack.outputs(0.0, &one, &()), wheel.outputs(0.0, &other, &()));
        let off = a.phase - b.phase;
        worst.see(off - off.round(), 0.0);
        worst.see(a.stiffness / b.stiffness, 1.0);
        unlike += usize::from(a.pairs != b.pairs);
    }
    assert!(unlike <= 1, "{unlike} of 40 places have other pairs");
    worst.below(4e-3, "a rack beside a wheel of ten thousand teeth");
}

linkwright::mechanism! {
    /// A sun, a planet on an axle that is turned round, a ring on another such.
    spatial TurnedRound {
        body sun { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); toothing rim: external(teeth = 20, module [mm] = 2, first [deg] = 1); }
        body planet { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); toothing rim: external(teeth = 25, module [mm] = 2, first [deg] = 5, face_width [mm] = 15); }
        body ring { mass [kg] = 1; inertia [kg*m^2] = (1e-2, 1e-2, 1e-2); toothing rim: internal(teeth = 70, module [mm] = 2, first [deg] = 2); }
        joint axle: revolute(ground(0, 0, 0) [mm], sun.center, axis = (0, 0, 1));
        joint bolt: revolute(ground(36, 27, 0) [mm], planet.center, axis = (0, 0, -1));
        joint rim:  revolute(ground(0, 0, 0) [mm], ring.center, axis = (0, 0, -2));
        gear inner: gear(sun.rim, planet.rim);
        mesh outer: mesh(planet.rim, ring.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 2), backlash [um] = 10);
        start { axle.angle [rad] = 0.2; }
        output deflection [um] = outer.deflection;
        output spin [rad/s] = rim.rate;
    }
}

/// Teeth stand where `first` says about their own axles: from the orientations of the bodies, a tooth of the one faces a space of the other.
#[test]
fn teeth_about_axles_that_are_turned_round() {
    let model = TurnedRound::<f64>::default();
    let start = TurnedRound::START;
    let motions = model.motions(0.0, &start.q, &start.v, &start.v);
    // Seen along z. J(−z) has x along x and y against y.
    let tooth = |body: usize, first: f64, side: f64| {
        let (x, y) = (first.to_radians().cos(), side * first.to_radians().sin());
        let [along, across, _] = motions[body].orientation.map(|row| row[0] * x + row[1] * y);
        across.atan2(along)
    };
    let (sun, planet, ring) = (tooth(0, 1.0, 1.0), tooth(1, 5.0, -1.0), tooth(2, 2.0, -1.0));
    let psi = 27f64.atan2(36.0);
    let mut worst = Worst::default();
    for sum in [
        20.0 * (sun - psi) + 25.0 * (planet - psi - PI) - PI,
        25.0 * (planet - psi) - 70.0 * (ring - psi) - PI,
    ] {
        worst.see(sum / TAU - (sum / TAU).round(), 0.0);
    }
    worst.below(1e-9, "pitches by which teeth are off");
    assert!(model.outputs(0.0, &start, &()).deflection.abs() < 1e-6);
}
