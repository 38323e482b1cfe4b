//! Shafts that twist, and a rotor that whirls, against closed forms.

use super::Worst;
use super::beams::determinant;
use linkwright::{AssembleExt, Linearisation, Rk4, Simulation};
use linkwright_models::laval_rotor::{LavalRotor, LavalRotorParameters};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Of all shafts here: m, m, Pa, kg/m³.
const LENGTH: f64 = 0.8;
const DIAMETER: f64 = 0.02;
const SHEAR: f64 = 80e9;
const DENSITY: f64 = 7850.0;

/// ρ I_p L, kg m².
fn inertia() -> f64 {
    DENSITY * LENGTH * PI * DIAMETER.powi(4) / 32.0
}

/// λ √(G/ρ)/(2π L).
fn hertz(lambda: f64) -> f64 {
    lambda * (SHEAR / DENSITY).sqrt() / LENGTH / TAU
}

/// The root between two places by halving.
fn root(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let half = 0.5 * (low + high);
        if value(low) * value(half) > 0.0 { low = half } else { high = half }
    }
    0.5 * (low + high)
}

linkwright::mechanism! {
    /// Held at one end.
    spatial Held {
        beam shaft { length [m] = 0.8; section = circle(diameter [mm] = 20); young [GPa] = 210; shear_modulus [GPa] = 80; density [kg/m^3] = 7850;
                     modes = (torsion = 8); shapes = static; }
        joint foot: fixed(ground(0, 0, 0) [m], shaft.start);
        options { emit = (tangent); }
    }
}

linkwright::mechanism! {
    /// The same with a disc at the other end.
    spatial WithDisc {
        param heavy [kg*m^2] = 1e-4 in 1e-7..1;
        beam shaft { length [m] = 0.8; section = circle(diameter [mm] = 20); young [GPa] = 210; shear_modulus [GPa] = 80; density [kg/m^3] = 7850;
                     modes = (torsion = 8); shapes = static; }
        body disc  { mass [kg] = 2; inertia = (heavy, 0.01 [kg*m^2], 0.01 [kg*m^2]); }
        joint foot: fixed(ground(0, 0, 0) [m], shaft.start);
        joint seat: fixed(shaft.end, disc.origin);
        options { emit = (tangent); }
    }
}

linkwright::mechanism! {
    /// A motor and a load at the ends of a shaft that turns.
    spatial Drive {
        param heavy [kg*m^2] = 1e-4 in 1e-7..1;
        body motor { mass [kg] = 2; inertia [kg*m^2] = (2e-4, 0.01, 0.01); }
        beam shaft { length [m] = 0.8; section = circle(diameter [mm] = 20); young [GPa] = 210; shear_modulus [GPa] = 80; density [kg/m^3] = 7850;
                     modes = (torsion = 8); shapes = static; }
        body load  { mass [kg] = 2; inertia = (heavy, 0.01 [kg*m^2], 0.01 [kg*m^2]); }
        joint bearing: revolute(ground(0, 0, 0) [m], motor.origin, axis = (1, 0, 0));
        joint key:  fixed(motor.origin, shaft.start);
        joint seat: fixed(shaft.end, load.origin);
        start { bearing.angle [rad] = 0; bearing.rate [rad/s] = 100; }
        options { emit = (tangent); }
    }
}

/// λ = (2k − 1) π/2; with a disc λ tan λ = J_shaft/J_disc; with two of which a motor's turns freely
/// (λ² J₁ J₂/J² − 1) tan λ = λ (J₁ + J₂)/J: Blevins, *Formulas for Natural Frequency and Mode Shape*, table 8-19. Polynomials see each from above.
#[test]
fn natural_frequencies_of_shafts() {
    macro_rules! near {
        ($model:expr, $start:expr, $expected:expr, $above:expr) => {{
            let model = $model;
            let linear = Linearisation::at(&model, 0.0, &$start, &()).expect("regular");
            let a = linear.state_space().expect("coordinates").a;
            let [low, high] = [1.0 - 1e-9, 1.0 + $above].map(|part| determinant(&a, $expected * part));
            assert!(low * high < 0.0, "{}: {low} {high}", $expected);
        }};
    }
    for (k, above) in [(1.0, 1e-9), (2.0, 1e-7), (3.0, 1e-4)] {
        near!(Held::<f64>::default(), Held::START, hertz((k - 0.5) * PI), above);
    }
    for heavy in [1e-6, 1e-4, 1e-2] {
        let own = inertia() / heavy;
        for k in 0..2 {
            let model = WithDisc::<f64>::prepare(WithDiscParameters { heavy }).expect("within its bounds");
            let from = k as f64 * PI;
            let lambda = root(from + 1e-9, from + FRAC_PI_2 - 1e-12, |x| x * x.sin() - own * x.cos());
            near!(model, WithDisc::START, hertz(lambda), 1e-7);
        }
        let (one, two) = (2e-4 / inertia(), heavy / inertia());
        let model = Drive::<f64>::prepare(DriveParameters { heavy }).expect("within its bounds");
        let value = |x: f64| (x * x * one * two - 1.0) * x.sin() - x * (one + two) * x.cos();
        let lambda = root(1e-3, PI - 1e-9, value);
        near!(model, Drive::START, hertz(lambda), 1e-8);
    }
}

linkwright::mechanism! {
    /// A bar with rectangular sections that a torque at its end twists, about an axis that is held.
    spatial Twisted {
        input torque [N*m];
        beam bar { length [m] = 0.8; section = rectangle(height [mm] = 10, width [mm] = 20); young [GPa] = 210; shear_modulus [GPa] = 80;
                   density [kg/m^3] = 7850; modes = (torsion = 2); shapes = static; damping_ratio = 0.5; }
        body knob { mass [kg] = 1; inertia [kg*m^2] = (1e-6, 1e-3, 1e-3); point far [m] = (0, 1, 0); }
        joint foot: fixed(ground(0, 0, 0) [m], bar.start);
        joint hold: fixed(bar.end, knob.origin);
        torque turn: torque(knob) = (torque, 0 [N*m], 0 [N*m]);
        output low [rad] = bar.torsion[0];
        output along [m] = knob.far.z;
        options { self_check = on; }
    }
}

/// T L/(G J_t) with J_t = β a b³, β = 0.229 of a = 2b: Timoshenko, Goodier, *Theory of Elasticity*, table after (160), whose next digits, 0.22868,
/// follow from the double sine series 256/π⁶ a³ b³ Σ 1/(m² n² (b² m² + a² n²)) over odd m and n.
#[test]
fn a_torque_twists_a_rectangle() {
    let (a, b) = (0.02_f64, 0.01_f64);
    let odd = |k: u32| f64::from(2 * k + 1);
    let term = |m: f64, n: f64| 1.0 / (m * m * n * n * (b * b * m * m + a * a * n * n));
    let sum: f64 = (0..400).map(|m| (0..400).map(|n| term(odd(m), odd(n))).sum::<f64>()).sum();
    let constant = 256.0 / PI.powi(6) * (a * b).powi(3) * sum;
    assert!((constant / (a * b.powi(3)) - 0.229).abs() < 5e-4);
    let torque = 0.1;
    let model = Twisted::<f64>::default();
    let mut simulation = Simulation::new(&model, Twisted::START)
        .sampled(move |_, _: &_| TwistedInputs { torque })
        .integrator(Rk4)
        .step(2e-6);
    simulation.advance_until(0.02).expect("it comes to rest");
    let found = simulation.sample().outputs.along.asin();
    let expected = torque * LENGTH / (SHEAR * constant);
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
}

/// Föppl's and Jeffcott's rotor with the mass of its shaft, at speeds below and above the critical one: the circle of the middle by the closed form of
/// the model's first lines, and by the same with the sum over its shapes in place of the uniform shaft, to the digits of the run. Far above the
/// middle whirls about the centre of mass.
#[test]
fn a_rotor_whirls_and_centres_itself() {
    let (young, length, diameter, mass, eccentricity, drag) = (210e9, 0.5_f64, 0.01_f64, 2.0, 2e-4, 40.0);
    let bending = young * PI * diameter.powi(4) / 64.0;
    let along = 7850.0 * PI * diameter.powi(2) / 4.0;
    let uniform = |speed: f64| {
        let lambda = (along / bending).powf(0.25) * speed.sqrt() * length;
        let shape = (0.5 * lambda).tan() - (0.5 * lambda).tanh();
        length.powi(3) * shape / (4.0 * lambda.powi(3) * bending)
    };
    // Shapes 1 and 3 of sines, the second of which does not move the middle.
    let summed = |speed: f64| {
        let square = |k: f64| (k * PI / length).powi(4) * bending / along;
        [1.0, 3.0].map(|k| 2.0 / (along * length) / (square(k) - speed * speed)).iter().sum::<f64>()
    };
    let circle = |alpha: f64, speed: f64| {
        let pulled = alpha * mass * speed * speed;
        eccentricity * (pulled / (1.0 - pulled).hypot(alpha * drag * speed)).abs()
    };
    let (mut shapes, mut shaft, mut centred) = (Worst::default(), Worst::default(), Worst::default());
    for speed in [50.0, 100.0, 180.0, 400.0] {
        let model = LavalRotor::<f64>::prepare(LavalRotorParameters { speed, ..Default::default() })
            .expect("within its bounds");
        let start = model.assemble(&LavalRotor::START).expect("it turns at any speed");
        let mut simulation = Simulation::new(&model, start).integrator(Rk4).step(2e-4);
        simulation.advance_until(2.5).expect("it turns");
        let outputs = simulation.sample().outputs;
        let found = outputs.y.hypot(outputs.z);
        shapes.see(found / circle(summed(speed), speed), 1.0);
        shaft.see(found / circle(uniform(speed), speed), 1.0);
        if speed == 400.0 {
            centred.see(1e6 * outputs.heavy_y.hypot(outputs.heavy_z), 0.0);
            assert!((found / eccentricity - 1.0).abs() < 0.13, "{found}");
        }
    }
    shapes.below(1e-5, "Laval's rotor, by its shapes");
    shaft.below(5e-3, "Laval's rotor, by the uniform shaft");
    centred.below(30.0, "Laval's rotor, centre of mass, µm");
}
