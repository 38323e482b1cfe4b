//! The parts of the library against the runs of the models that are written out, and against their equations by hand.

use super::Worst;
use linkwright::{DormandPrince, Mechanism, Rk4, Simulation, State};

linkwright::mechanism! {
    /// The motor on an arm, by the library.
    planar GearedArm {
        input voltage [V];
        gravity [m/s^2] = (0, -9.81);
        body arm { mass [kg] = 0.1; inertia [kg*m^2] = 0.019; point axle [m] = (0, 0.1); }
        joint axle: revolute(ground(0, 0) [m], arm.axle);
        part motor: DcMotor(shaft = axle, voltage = voltage, resistance [ohm] = 0.5, inductance [mH] = 2, constant [N*m/A] = 0.04, ratio = 2);
        start { axle.angle [rad] = 0; axle.rate [rad/s] = 0; }
        output angle [rad] = axle.angle;
        output rate [rad/s] = axle.rate;
        output current [A] = motor.current;
    }
}

/// The motor's constant stands with its ratio, so that half of it with a ratio of two is the motor of the published run.
#[test]
fn a_motor_with_a_gearbox() {
    let model = GearedArm::default();
    let mut simulation = Simulation::new(&model, GearedArm::START)
        .held(|_, _| GearedArmInputs { voltage: 3.0 })
        .integrator(DormandPrince::tolerance(1e-12))
        .step(1e-2);
    simulation.run_until(1.0, |_| ()).expect("it turns");
    let found = simulation.sample().outputs;
    let mut worst = Worst::default();
    worst.see(found.angle, 9.149_928_836_671_469);
    worst.see(found.rate, 16.814_920_126_022_002);
    worst.see(found.current, 3.317_073_210_020_512);
    worst.below(2e-10, "motor on an arm");
}

linkwright::mechanism! {
    /// The braked wheel on a road that carries it, by the library.
    planar RollingWheel {
        gravity [m/s^2] = (0, -9.81);
        body car { mass [kg] = 230; inertia [kg*m^2] = 0; }
        body wheel { mass [kg] = 20; inertia [kg*m^2] = 1.2; }
        // The load of 250 kg squeezes the tyre by 10 mm.
        joint road: prismatic(ground(0, 0.29) [m], car.center, axis = (1, 0));
        joint axle: revolute(car.center, wheel.center);
        part tyre: Tyre(wheel = wheel, radius [m] = 0.3, stiffness = 250 [kg]*9.81 [m/s^2]/0.01 [m]);
        torque braking: torque(axle) = 600 [N*m]*clamp(time/0.3 [s], 0, 1)*sign(-axle.rate);
        start { road.travel [m] = 0; road.speed [m/s] = 20; axle.angle [rad] = 0; axle.rate [rad/s] = -20/0.3; }
        output place [m] = road.travel;
        output speed [m/s] = road.speed;
        output spin [rad/s] = -axle.rate;
        output slip [1] = tyre.slip;
        output force [N] = tyre.traction;
    }
}

#[test]
fn a_wheel_on_its_tyre() {
    let model = RollingWheel::default();
    let mut simulation =
        Simulation::new(&model, RollingWheel::START).integrator(DormandPrince::tolerance(1e-12)).step(1e-2);
    // The brake has a corner there.
    simulation.run_until(0.3, |_| ()).expect("it rolls");
    simulation.run_until(1.0, |_| ()).expect("it rolls");
    let found = simulation.sample().outputs;
    let mut worst = Worst::default();
    for (found, expected) in [
        (found.place, 17.275_484_471_766_03),
        (found.speed, 13.590_967_309_533_108),
        (found.spin, 42.231_209_820_847_47),
        (found.slip, -0.067_810_064_052_679),
        (found.force, -1_905.275_790_837_8),
    ] {
        worst.see(found, expected);
    }
    worst.below(1e-8, "braked wheel");
}

linkwright::mechanism! {
    /// A mass on a rail that a cylinder and a strut push.
    planar Lift {
        input opening [1];
        table damper(speed [m/s]) [N] = [(-1, -60), (0, 0), (1, 45)], linear;
        table stops(length [m]) [N] = [(0.2, 800), (0.4, 0), (0.8, 0), (0.9, -100)], linear;
        body load { mass [kg] = 100; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], load.center, axis = (0, 1));
        part ram: HydraulicCylinder(base = ground(0, -0.5) [m], eye = load.center, opening = opening, bore [mm] = 50, rod [mm] = 30, closed [m] = 0.4,
                                    stroke [m] = 0.6, supply [bar] = 100, flow [m^3/s] = 5e-4, tank [bar] = 2, start [bar] = 20,
                                    start_ring [bar] = 15, damping [N*s/m] = 2e4);
        part strut: Strut(top = load.center, bottom = ground(0, -0.6) [m], stiffness [N/m] = 2000, free [m] = 0.5, damper = damper, stops = stops);
        start { rail.travel [m] = 0.1; rail.speed [m/s] = 0.3; }
        output thrust [N] = ram.thrust;
        output push [N] = strut.force;
        output speed [m/s] = rail.speed;
        output pressure [Pa] = ram.pressure;
        output ring [Pa] = ram.pressure_ring;
    }
}

/// Pressures, their rates and forces, by the equations of the parts written down once more.
#[test]
fn a_cylinder_and_a_strut_push() {
    let model = Lift::default();
    let (area, ring) = (
        core::f64::consts::PI / 4.0 * 0.05 * 0.05,
        core::f64::consts::PI / 4.0 * (0.05 * 0.05 - 0.03 * 0.03),
    );
    for opening in [0.0, 0.4, -0.7] {
        for (pressure, pressure_ring, travel, speed) in
            [(20e5, 15e5, 0.1, 0.3), (60e5, 120e5, 0.25, -0.2), (1e5, 99e5, -0.3, 1.1)]
        {
            let start = Lift::START;
            let (mut q, mut v) = (start.q, start.v);
            q[0] = travel;
            v[0] = speed;
            let state = State { q, v, z: [pressure, pressure_ring], gates: start.gates };
            let inputs = LiftInputs { opening };
            let (mut a, mut lambda, mut rates) = (model.zero_v(), model.zero_lambda(), model.zero_z());
            model.acceleration(0.0, &state, &inputs, &mut a, &mut lambda);
            model.internal_rates(0.0, &state, &inputs, &a, &lambda, &mut rates);
            let outputs = Mechanism::outputs(&model, 0.0, &state, &inputs);
            let out = travel + 0.5 - 0.4;
            let thrust = pressure * area - pressure_ring * ring - 2e4 * speed;
            let length = travel + 0.6;
            let resists = if speed < 0.0 { 60.0 * speed } else { 45.0 * speed };
            let stops = match length {
                length if length < 0.4 => 800.0 * (0.4 - length) / 0.2,
                length if length > 0.8 => -1000.0 * (length - 0.8),
                _ => 0.0,
            };
            let push = 2000.0 * (0.5 - length) - resists + stops;
            let orifice = |drop: f64| 5e-4 * drop / (3.5e6 * drop.hypot(1e4)).sqrt();
            let (extend, retract) = (f64::max(opening, 0.0), f64::max(-opening, 0.0));
            let into = extend * orifice(100e5 - pressure) - retract * orifice(pressure - 2e5);
            let into_ring = retract * orifice(100e5 - pressure_ring) - extend * orifice(pressure_ring - 2e5);
            let rate = 1.4e9 * (into - area * speed) / (1e-4 + area * out);
            let rate_ring = 1.4e9 * (into_ring + ring * speed) / (1e-4 + ring * (0.6 - out));
            let mut worst = Worst::default();
            worst.see(outputs.thrust / thrust, 1.0);
            worst.see(outputs.push / push, 1.0);
            worst.see(rates[0] / rate, 1.0);
            worst.see(rates[1] / rate_ring, 1.0);
            worst.see(a[0] * 100.0 / (thrust + push), 1.0);
            worst.below(1e-12, "cylinder and strut");
        }
    }
}

/// With the valve open the load settles at the speed of the flow; with the valve closed it hangs on the oil.
#[test]
fn a_cylinder_lifts() {
    let model = Lift::default();
    let mut simulation = Simulation::new(&model, Lift::START)
        .held(|time, _| LiftInputs { opening: if time < 0.25 { 0.3 } else { 0.0 } })
        .integrator(Rk4)
        .step(1e-5);
    simulation.run_until(0.25, |_| ()).expect("it lifts");
    let rising = simulation.sample().outputs;
    let area = core::f64::consts::PI / 4.0 * 0.05 * 0.05;
    let speed = 0.3 * 5e-4 * ((100e5 - rising.pressure) / 3.5e6).sqrt() / area;
    assert!((rising.speed - speed).abs() < 0.05 * speed, "{} and {speed}", rising.speed);
    simulation.run_until(1.0, |_| ()).expect("it stops");
    let held = simulation.sample().outputs;
    assert!(held.speed.abs() < 1e-3, "{}", held.speed);
    assert!((held.thrust + held.push).abs() < 5.0, "{} and {}", held.thrust, held.push);
}
