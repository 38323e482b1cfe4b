//! Friction in joints by their reactions beside rigid contacts, which press on these joints and are pressed by what rubs there.

use linkwright::{
    Ali3p, AssembleExt, AugmentedLagrangian, Baumgarte, GeneralisedAlpha, ImplicitTrapezoidal,
    LagrangeIndex1, NullSpace, Penalty, Projected, Rk4, Simulation,
};
use linkwright_engine::{Derivatives, Engine};

linkwright::mechanism! {
    /// A wedge on the floor under a rider in a guide.
    planar Wedge {
        gravity [m/s^2] = (0, -9.81);
        body base { mass [kg] = 2; inertia [kg*m^2] = 0.1; point a [m] = (0, 0); point b [m] = (1, 0.5); line slope = (base.a, base.b); surface top: half_plane(base.slope); }
        body rider { mass [kg] = 1; inertia [kg*m^2] = 0.1; surface foot: point(rider.center); }
        joint floor: prismatic(ground(0, 0) [m], base.center, axis = (1, 0));
        joint wall: prismatic(ground(0.5, 0) [m], rider.center, axis = (0, 1));
        contact lies: between(rider.foot, base.top) = rigid(restitution = 0);
        friction f_floor: on(floor) = coulomb(coefficient = 0.1, speed [m/s] = 1e-4);
        friction f_wall: on(wall) = coulomb(coefficient = 0.2, speed [m/s] = 1e-4);
        start { floor.travel [m] = 0; wall.travel [m] = 0.25; floor.speed [m/s] = 0.4; wall.speed [m/s] = -0.2; }
        output x [m] = floor.travel;
        output pressed [N] = lies.force;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine<Derivatives> {
    Engine::<Derivatives>::read_with_derivatives(source).unwrap_or_else(|found| panic!("{found}"))
}

/// A wedge on the floor under a rider in a guide; μ of floor, guide and wedge.
fn wedge([floor, guide, top]: [f64; 3]) -> Engine<Derivatives> {
    let dry =
        if top > 0.0 { format!("friction f_top: on(lies) = dry(static = {top});") } else { String::new() };
    read(&format!(
        "planar Wedge {{ gravity [m/s^2] = (0, -9.81);
            body base {{ mass [kg] = 2; inertia [kg*m^2] = 0.1; point a [m] = (0, 0); point b [m] = (1, 0.5); line slope = (base.a, base.b); surface top: half_plane(base.slope); }}
            body rider {{ mass [kg] = 1; inertia [kg*m^2] = 0.1; surface foot: point(rider.center); }}
            joint floor: prismatic(ground(0, 0) [m], base.center, axis = (1, 0));
            joint wall: prismatic(ground(0.5, 0) [m], rider.center, axis = (0, 1));
            contact lies: between(rider.foot, base.top) = rigid(restitution = 0);
            friction f_floor: on(floor) = coulomb(coefficient = {floor}, speed [m/s] = 1e-6);
            friction f_wall: on(wall) = coulomb(coefficient = {guide}, speed [m/s] = 1e-6);
            {dry}
            start {{ floor.travel [m] = 0; wall.travel [m] = 0.25; floor.speed [m/s] = 0.4; wall.speed [m/s] = -0.2; }}
            options {{ emit = (tangent); }}
            output x [m] = floor.travel; output v [m/s] = floor.speed; output pressed [N] = lies.force; output gap [m] = lies.gap;
            output floor_presses [N] = f_floor.normal; output wall_presses [N] = f_wall.normal; }}"
    ))
}

/// Three forces that press, each by the others. The rider goes down with half the speed of the wedge, s = ½, and slides on it against its slope:
///   m₁ ẍ = N n − μ_t N t − μ_f (m₁ g + N t + μ_t N n),  −m₂ s ẍ = N t + μ_t N n − m₂ g + μ_w (N n − μ_t N t)
/// with n and t the parts of the contact's normal along and across the floor.
#[test]
fn a_wedge_slides_by_its_closed_form() {
    let (m1, m2, g, s) = (2.0, 1.0, 9.81, 0.5_f64);
    let (n, t) = (s / 1.25_f64.sqrt(), 1.0 / 1.25_f64.sqrt());
    for mu @ [floor, guide, top] in [[0.1, 0.2, 0.0], [0.2, 0.3, 0.05], [0.05, 0.4, 0.1]] {
        let (push, carry) = (n - top * t, t + top * n);
        let along = push - floor * carry;
        let pressed = (m2 * g + s * m2 * floor * g) / (carry + guide * push + s * m2 / m1 * along);
        let a = (pressed * along - floor * m1 * g) / m1;
        let engine = wedge(mu);
        macro_rules! slides {
            ($($name:literal: $formulation:expr, $method:expr;)*) => { $(
                let mut simulation = Simulation::new(&engine, engine.start())
                    .formulation($formulation)
                    .constant(engine.no_inputs())
                    .integrator($method)
                    .step(1e-3);
                let mut left = 0.0_f64;
                while simulation.time() < 0.2 - 1e-9 {
                    let step = simulation.advance().unwrap_or_else(|error| panic!("{}: {error}", $name));
                    left = left.max(step.friction_residual);
                }
                let sample = simulation.sample();
                let outputs = sample.outputs.as_slice();
                close(outputs[0], 0.4 * 0.2 + 0.02 * a, 1e-10, $name);
                close(outputs[1], 0.4 + 0.2 * a, 1e-9, "speed");
                close(outputs[2], pressed, 1e-8, "what presses between both");
                close(outputs[3], 0.0, 1e-12, "gap");
                close(outputs[4], m1 * g + pressed * carry, 1e-7, "on the floor");
                close(outputs[5], (pressed * push).abs(), 1e-7, "in the guide");
                assert!(left < 1e-9, "{}: friction leaves {left:.1e}", $name);
            )* };
        }
        slides! {
            "index 1": LagrangeIndex1, Rk4;
            "Baumgarte": Baumgarte::time_constant(0.05), Rk4;
            "augmented": AugmentedLagrangian::new(Penalty::new(1e7)), Rk4;
            "null space, projected": Projected::after(NullSpace), Rk4;
            "implicit trapezoidal": LagrangeIndex1, ImplicitTrapezoidal::<f64>::default();
            "generalised-alpha": LagrangeIndex1, GeneralisedAlpha::new(0.8);
            "ALI3-P": LagrangeIndex1, Ali3p::new(1e9);
        }
    }
}

/// Passes end where single precision does.
#[test]
fn a_wedge_slides_in_single_precision() {
    let model = Wedge::<f32>::default();
    let mut simulation = Simulation::new(&model, model.start()).integrator(Rk4).step(1e-3_f32);
    simulation.advance_until(0.2).expect("it slides");
    let outputs = simulation.sample().outputs;
    close(f64::from(outputs.x), 0.094_715, 1e-6, "way");
    close(f64::from(outputs.pressed), 9.596_924_250_931_9, 1e-4, "what presses");
}

/// A slider-crank that rubs in its pins and on its rail pushes a wedge under a rider that bounces on it: whatever the formulation, and what is lost is what friction and
/// impulses took.
fn mill() -> Engine<Derivatives> {
    read(
        "planar Mill { gravity [m/s^2] = (0, -9.81);
            rod crank { mass [kg] = 1; length [m] = 0.2; } rod coupler { mass [kg] = 2; length [m] = 0.5; }
            body base { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; point a [m] = (0, 0); point b [m] = (0.6, 0.25); line slope = (base.a, base.b); surface top: half_plane(base.slope); }
            body rider { mass [kg] = 0.8; inertia [kg*m^2] = 0.01; surface foot: point(rider.center); }
            joint pivot: revolute(ground(0, 0) [m], crank.start); joint elbow: revolute(crank.end, coupler.start); joint wrist: revolute(coupler.end, base.center);
            joint rail: prismatic(ground(0, 0) [m], base.center, axis = (1, 0)); joint wall: prismatic(ground(0.8, 0) [m], rider.center, axis = (0.1, 1));
            contact lies: between(rider.foot, base.top) = rigid(restitution = 0.4);
            friction f_pivot: on(pivot) = coulomb(coefficient = 0.1, radius [mm] = 15, speed [rad/s] = 0.1);
            friction f_elbow: on(elbow) = stribeck(static = 0.12, kinetic = 0.08, transition [rad/s] = 1, radius [mm] = 12, speed [rad/s] = 0.1);
            friction f_rail: on(rail) = coulomb(coefficient = 0.06, length [m] = 0.5, speed [m/s] = 0.02);
            friction f_wall: on(wall) = coulomb(coefficient = 0.1, speed [m/s] = 0.02);
            friction scrape: on(lies) = dry(static = 0.2, kinetic = 0.15);
            state spent [J] = 0; rate spent = -power(f_pivot) - power(f_elbow) - power(f_rail) - power(f_wall) - power(scrape);
            start { pivot.angle [deg] = 60; pivot.rate [rad/s] = -2; wall.travel [m] = 0.25; elbow.angle [deg] ~ -80; }
            options { friction_passes = 6; emit = (tangent); }
            output angle [rad] = pivot.angle; output travel [m] = wall.travel; output spent [J] = spent; }",
    )
}

#[test]
fn what_a_mill_loses_is_what_rubbed_and_struck() {
    let engine = mill();
    let mut found: Vec<Vec<f64>> = Vec::new();
    macro_rules! turns {
        ($($name:literal: $formulation:expr, $method:expr, $step:expr;)*) => { $(
            let mut simulation = Simulation::new(&engine, engine.start())
                .formulation($formulation)
                .constant(engine.no_inputs())
                .integrator($method)
                .step($step);
            let begun = simulation.energy();
            let (mut impacts, mut changed, mut lost) = (0, 0, 0.0);
            while simulation.time() < 1.0 - 1e-9 {
                let step = simulation.advance().unwrap_or_else(|error| panic!("{}: {error}", $name));
                (impacts, changed) = (impacts + step.impacts, changed + step.gates_changed);
                lost += step.lost - step.gained;
            }
            let sample = simulation.sample();
            let outputs = sample.outputs.as_slice().to_vec();
            println!("{}: {impacts} impacts, {changed} changes, {outputs:?}, impulses took {lost:.4} J", $name);
            assert!(impacts > 3 && changed > 2, "{}: {impacts} impacts, {changed} changes", $name);
            assert!(lost > 0.01 && outputs[2] > 0.1, "{}: {lost} J, {} J", $name, outputs[2]);
            let left = begun - simulation.energy() - lost - outputs[2];
            let within = if found.is_empty() { 1e-6 } else { 2e-3 };
            close(left, 0.0, within, "energy");
            found.push(outputs);
        )* };
    }
    turns! {
        "null space, projected": Projected::after(NullSpace), Rk4, 5e-4;
        "Baumgarte": Baumgarte::time_constant(0.05), Rk4, 5e-4;
        "augmented": AugmentedLagrangian::new(Penalty::new(1e7)), Rk4, 5e-4;
        "implicit trapezoidal": LagrangeIndex1, ImplicitTrapezoidal::<f64>::default(), 5e-4;
    }
    for (other, within) in found[1..].iter().zip([1e-6, 1e-6, 2e-4]) {
        close(other[0], found[0][0], within, "angle");
        close(other[1], found[0][1], within, "travel");
    }
}

/// A blow changes speeds as if nothing rubbed: two rods of 1 m and 1 kg whose tip hits the wall x = 0.5 m, by impulse and momentum. Friction that had its share
/// would change both rates by a hundredth and more.
#[test]
fn a_blow_is_as_without_friction_of_joints() {
    let [first, second] = [0.091_025_739_315_88, 0.421_467_432_993_758];
    let rates = [3.342_891_601_374_5, 2.216_177_243_240_57];
    // A moment before.
    let early = 1e-6;
    let rods = read(&format!(
        "planar Rods {{ gravity [m/s^2] = (0, -9.81); rod one {{ mass [kg] = 1; length [m] = 1; }} rod two {{ mass [kg] = 1; length [m] = 1; surface tip: point(two.end); }}
            joint top: revolute(ground(0, 0) [m], one.start); joint knee: revolute(one.end, two.start);
            surface wall: half_plane(line(ground(0.5, 0) [m], ground(0.5, 1) [m]));
            contact strike: between(two.tip, wall) = rigid(restitution = 0.5);
            friction f_top: on(top) = coulomb(coefficient = 0.3, radius [m] = 0.03, speed [rad/s] = 0.05);
            friction f_knee: on(knee) = coulomb(coefficient = 0.3, radius [m] = 0.03, speed [rad/s] = 0.05);
            start {{ one.angle [rad] = {}; two.angle [rad] = {}; one.rate [rad/s] = {}; two.rate [rad/s] = {}; }} options {{ emit = (tangent); }}
            output first [rad/s] = one.rate; output second [rad/s] = two.rate; }}",
        first - early * rates[0] - std::f64::consts::FRAC_PI_2,
        second - early * rates[1] - std::f64::consts::FRAC_PI_2,
        rates[0],
        rates[1],
    ));
    let mut simulation =
        Simulation::new(&rods, rods.start()).constant(rods.no_inputs()).integrator(Rk4).step(2.0 * early);
    let step = simulation.advance().expect("it strikes");
    assert_eq!(step.impacts, 1);
    let sample = simulation.sample();
    let [first, second] = sample.outputs.as_slice() else { panic!("two outputs") };
    close(*first, 4.718_548_669_028_4, 2e-4, "rate of the first after it");
    close(*second, -8.081_910_585_501_52, 2e-4, "rate of the second");
    close(step.lost, 4.078_872_915_007_6, 1e-4, "what it took");
}
