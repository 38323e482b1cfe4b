//! Teeth that give on axes that move, and in space: against the same mechanism with axes that are held, the conservation of energy, and the forces of slanted teeth as text
//! books have them.

use super::Worst;
use linkwright::{Mechanism, Simulation};

macro_rules! on_a_lever {
    ($name:ident, $axes:ident) => {
        linkwright::mechanism! {
            planar $name {
                body lever { mass [kg] = 2; inertia [kg*m^2] = 0.02; center [mm] = (10, 5); point hub [mm] = (0, 0); point pin [mm] = (21.65063509461097, 12.5); }
                body ring { mass [kg] = 3; inertia [kg*m^2] = 0.04; toothing inside: internal(teeth = 75, module [mm] = 2, first [deg] = 3, face_width [mm] = 10);
                            #[allow(teeth)] toothing outside: external(teeth = 90, module [mm] = 2, first [deg] = -1, face_width [mm] = 20, bore [mm] = 155); point seat [mm] = (0, 0); }
                disk idler { mass [kg] = 0.6; radius [mm] = 48; toothing rim: external(teeth = 50, module [mm] = 2, first [deg] = 7); }
                body side { mass [kg] = 0.4; inertia [kg*m^2] = 3e-4; center [mm] = (1, -2); point eye [mm] = (0, 3);
                            toothing rim: external(teeth = 21, module [mm] = 2, at = side.eye, bore [mm] = 12); }
                joint main:  revolute(ground(0, 0) [mm], lever.hub);
                joint outer: revolute(lever.hub, ring.seat);
                joint bolt:  revolute(idler.center, lever.pin);
                joint axle:  revolute(ground(111, 0) [mm], side.eye);
                mesh inner: mesh(ring.inside, idler.rim, stiffness = involute(young [GPa] = 210, harmonics = 3, entry = 0.1), axes = $axes);
                mesh again: mesh(idler.rim, ring.inside, stiffness = 1e6 [N/m], backlash [um] = 20, sense = -1, axes = $axes);
                mesh train: mesh(side.rim, ring.outside, stiffness = involute(young [GPa] = 206, harmonics = 5), damping_ratio = 0.05, backlash [um] = 40, axes = $axes);
                torque drive: torque(main) = 3 [N*m];
                start { main.angle [rad] = 0.3; main.rate [rad/s] = 0.7; outer.rate [rad/s] = -0.4; }
                output inner_force [N] = inner.force;
                output train_deflection [um] = train.deflection;
                output again_deflection [um] = again.deflection;
                output inner_phase [1] = inner.phase;
                output train_phase [1] = train.phase;
                output stiff [N/um] = inner.stiffness;
                output bearing_x [N] = axle.reaction.x;
                output bolt_y [N] = bolt.reaction.y;
            }
        }
    };
}
on_a_lever!(OnHeldAxes, held);
on_a_lever!(OnMovingAxes, moving);

/// Axes that joints hold are the same whether or not the teeth know: a carrier, a ring that comes first and one that comes second, gaps, shapes, damping in
/// contact, reactions.
#[test]
fn axes_that_could_move_and_do_not() {
    let (held, moving) = (OnHeldAxes::<f64>::default(), OnMovingAxes::<f64>::default());
    let mut one = Simulation::new(&held, OnHeldAxes::START).step(1e-5);
    let mut other = Simulation::new(&moving, OnMovingAxes::START).step(1e-5);
    let mut worst = Worst::default();
    let mut pressed = 0.0_f64;
    for _ in 0..300 {
        one.advance().expect("teeth turn");
        other.advance().expect("teeth turn");
        let a = held.outputs(one.time(), one.state(), &());
        let b = moving.outputs(other.time(), other.state(), &());
        pressed = pressed.max(a.inner_force.abs());
        for (a, b) in [
            (a.inner_force, b.inner_force),
            (a.train_deflection * 1e6, b.train_deflection * 1e6),
            (a.again_deflection * 1e6, b.again_deflection * 1e6),
            (a.inner_phase, b.inner_phase),
            (a.train_phase, b.train_phase),
            (a.stiff * 1e-6, b.stiff * 1e-6),
            (a.bearing_x, b.bearing_x),
            (a.bolt_y, b.bolt_y),
        ] {
            worst.see(b, a);
        }
    }
    assert!(pressed > 1.0, "{pressed} N");
    worst.below(1e-6, "axes that could move, N, µm, pitches, N/µm");
}

linkwright::mechanism! {
    /// Wheels that only bushings hold, one of them shifted, and a ring around one of them.
    planar Floating {
        body pinion { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2, shift = 0.3, first [deg] = 4); }
        body wheel  { mass [kg] = 2; inertia [kg*m^2] = 4e-3; center [mm] = (1, 2); point hub [mm] = (0, 0); toothing rim: external(teeth = 30, module [mm] = 2, at = wheel.hub); }
        body ring   { mass [kg] = 3; inertia [kg*m^2] = 0.02; toothing inside: internal(teeth = 75, module [mm] = 2, first [deg] = 3); }
        body base   { mass [kg] = 3; inertia [kg*m^2] = 0.02; }
        joint held:  fixed(ground(0, 0), base.center);
        joint hinge: revolute(ground(50.6, 0) [mm], wheel.hub);
        bushing bearing: bushing(base.center, pinion.center, stiffness [N/m] = 1e6, torsional_stiffness [N*m] = 0);
        bushing around:  bushing(base.center, ring.center, stiffness [N/m] = 2e6, torsional_stiffness [N*m] = 0);
        mesh outside: mesh(pinion.rim, wheel.rim, stiffness [N/m] = 1e6, axes = moving, backlash [um] = 40);
        mesh inside:  mesh(ring.inside, wheel.rim, stiffness [N/m] = 1e6, axes = moving, backlash [um] = 10);
        start { pinion.center.x [mm] = 0.1; pinion.center.y [mm] = 0.05; hinge.rate [rad/s] = 20; pinion.rate [rad/s] = -27; ring.rate [rad/s] = 8; ring.center.x [mm] = 5.7;
                ring.center.y [mm] = 0.1; }
        output outside_force [N] = outside.force;
        output inside_force [N] = inside.force;
        output total [J] = energy;
    }
}

/// Both sides of the teeth press with all of their energy, and nothing is lost where axes go nearer and farther.
#[test]
fn teeth_on_moving_axes_keep_their_energy() {
    let model = Floating::<f64>::default();
    let mut simulation = Simulation::new(&model, Floating::START).step(1e-5);
    let start = model.outputs(0.0, &Floating::START, &());
    let (mut worst, mut most, mut least) = (Worst::default(), [0.0_f64; 2], [0.0_f64; 2]);
    for _ in 0..3000 {
        simulation.advance().expect("teeth turn");
        let outputs = model.outputs(simulation.time(), simulation.state(), &());
        worst.see(outputs.total / start.total, 1.0);
        for (at, force) in [outputs.outside_force, outputs.inside_force].into_iter().enumerate() {
            (most[at], least[at]) = (most[at].max(force), least[at].min(force));
        }
    }
    // All four sides have pressed.
    assert!(
        most.iter().all(|force| *force > 10.0) && least.iter().all(|force| *force < -10.0),
        "{most:?} {least:?}"
    );
    worst.below(1e-6, "energy of teeth on axes that move");
}

linkwright::mechanism! {
    /// A right-hand driver and its wheel; the start twists them into each other.
    spatial Slanting {
        body driver { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); toothing rim: external(teeth = 20, module [mm] = 2, helix [deg] = 15, face_width [mm] = 30); }
        body wheel  { mass [kg] = 2; inertia [kg*m^2] = (4e-3, 4e-3, 4e-3); toothing rim: external(teeth = 40, module [mm] = 2, helix [deg] = -15, face_width [mm] = 30); }
        joint front: revolute(ground(0, 0, 0) [mm], driver.center, axis = (0, 0, 1));
        joint back:  revolute(ground(60/cos(15 [deg])*1 [mm], 0 [mm], 0 [mm]), wheel.center, axis = (0, 0, 1));
        mesh teeth: mesh(driver.rim, wheel.rim, stiffness [N/m] = 1e8);
        start { front.angle [rad] = 0.001; back.angle [rad] = 0.0785; }
        output force [N] = teeth.force;
        output front_x [N] = front.reaction.x;
        output front_y [N] = front.reaction.y;
        output front_z [N] = front.reaction.z;
        output front_tilt [N*m] = front.reaction.torque.y;
        output back_x [N] = back.reaction.x;
        output back_y [N] = back.reaction.y;
        output back_z [N] = back.reaction.z;
        output back_tilt [N*m] = back.reaction.torque.y;
        output back_roll [N*m] = back.reaction.torque.x;
    }
}

/// F_r = F_t tan α_n/cos β and F_a = F_t tan β on a tooth that transmits F_t (Shigley's Mechanical Engineering Design, 13-16): a right-hand driver that turns counter-clockwise is pushed along its axle,
/// the wheel against it, and both are tilted by F_a r.
#[test]
fn bearings_of_slanted_teeth() {
    let model = Slanting::<f64>::default();
    let outputs = model.outputs(0.0, &Slanting::START, &());
    let (normal, helix) = (20f64.to_radians(), 15f64.to_radians());
    let transverse = (normal.tan() / helix.cos()).atan();
    // Whichever side of the teeth the start has brought together.
    let along = outputs.force * transverse.cos();
    assert!(along.abs() > 10.0, "{along} N");
    let (radial, axial) = (along.abs() * normal.tan() / helix.cos(), along * helix.tan());
    let radii = [20e-3 / helix.cos(), 40e-3 / helix.cos()];
    let mut worst = Worst::default();
    for (found, expected) in [
        (outputs.front_x, radial),
        (outputs.front_y, along),
        (outputs.front_z, -axial),
        (outputs.front_tilt, axial * radii[0]),
        (outputs.back_x, -radial),
        (outputs.back_y, -along),
        (outputs.back_z, axial),
        (outputs.back_tilt, axial * radii[1]),
        (outputs.back_roll, 0.0),
    ] {
        worst.see(found / along, expected / along);
    }
    worst.below(1e-9, "bearings of slanted teeth");
}

macro_rules! spur {
    ($space:ident $name:ident, [$($inertia:tt)*], [$($front:tt)*], [$($back:tt)*], [$($axis:tt)*]) => {
        linkwright::mechanism! {
            $space $name {
                body pinion { mass [kg] = 3; inertia [kg*m^2] = $($inertia)*; toothing rim: external(teeth = 50, module [mm] = 3, face_width [mm] = 20, bore [mm] = 40); }
                body wheel  { mass [kg] = 3; inertia [kg*m^2] = $($inertia)*; toothing rim: external(teeth = 30, module [mm] = 3, face_width [mm] = 20, bore [mm] = 20, first [deg] = 3); }
                joint front: revolute(ground$($front)*, pinion.center $($axis)*);
                joint back:  revolute(ground$($back)*, wheel.center $($axis)*);
                #[allow(teeth)]
                mesh teeth: mesh(pinion.rim, wheel.rim, stiffness = involute(young [GPa] = 210, entry = 0.05, harmonics = 3), damping_ratio = 0.05,
                                 backlash [um] = 6, error = 2e-6 [m]*cos(front.angle));
                torque motor: torque(front) = 30 [N*m];
                start { front.rate [rad/s] = 10; }
                output force [N] = teeth.force;
                output deflection [um] = teeth.deflection;
                output phase [1] = teeth.phase;
                output bearing_x [N] = back.reaction.x;
                output bearing_y [N] = back.reaction.y;
            }
        }
    };
}
spur!(planar SpurInThePlane, [0.0075], [(0, 0) [mm]], [(72, 96) [mm]], []);
spur!(spatial SpurInSpace, [(0.0075, 0.0075, 0.0075)], [(0, 0, 0) [mm]], [(72, 96, 0) [mm]], [, axis = (0, 0, 1)]);

/// Straight teeth about parallel axles do in space what they do in the plane.
#[test]
fn straight_teeth_in_space() {
    let (plane, space) = (SpurInThePlane::<f64>::default(), SpurInSpace::<f64>::default());
    let mut one = Simulation::new(&plane, SpurInThePlane::START).step(1e-5);
    let mut other = Simulation::new(&space, SpurInSpace::START).step(1e-5);
    let (mut worst, mut pressed) = (Worst::default(), 0.0_f64);
    for _ in 0..500 {
        one.advance().expect("teeth turn");
        other.advance().expect("teeth turn");
        let a = plane.outputs(one.time(), one.state(), &());
        let b = space.outputs(other.time(), other.state(), &());
        pressed = pressed.max(a.force.abs());
        for (a, b) in [(a.force, b.force), (a.bearing_x, b.bearing_x), (a.bearing_y, b.bearing_y)] {
            worst.see(b * 1e-3, a * 1e-3);
        }
        worst.see(b.deflection * 1e6, a.deflection * 1e6);
        worst.see(b.phase, a.phase);
    }
    assert!(pressed > 100.0, "{pressed} N");
    worst.below(1e-6, "teeth in space beside the plane, kN, µm, pitches");
}
