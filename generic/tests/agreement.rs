//! Every shipped model and the zoo's: the accelerations of all bodies, rates of internal states and efforts of drivers by the generic
//! solver, dense and sparse, against those of the emitted code, at states along the motion and with other velocities there; or the
//! definition is refused, for the reason that stands here.

#[path = "mapping/beams.rs"]
mod beams;
mod mapping;

use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Report, Simulation, State, StateOf, Vector, project_velocity,
};
use linkwright_generic::{Algebra, BodyMotion, DefinitionError, Formulation, Mechanism};

/// Largest difference of accelerations, relative to the largest of the mechanism, or to 1 where that is more.
const TOLERANCE: f64 = 1e-8;

/// Models that are refused, and what is not there yet.
const REFUSED: &[(&str, &str)] = &[
    ("ball_between_walls", RIGID),
    ("block", MODAL),
    ("cam_lift_off", RIGID),
    ("cantilever", MODAL),
    ("dropping", RIGID),
    ("floated", "a mesh on axes that move"),
    ("gripping", RIGID),
    ("hammer_at_rigid_wall", RIGID),
    ("rimless_wheel", RIGID),
    ("rubbing_flexible_block", MODAL),
    ("slider_crank_on_stop", RIGID),
    ("striking", RIGID),
    ("woodpecker", RIGID),
    ("yielding", "friction in joints that yield"),
];
const MODAL: &str = "bodies with the modes of a file";
const RIGID: &str = "impulses of rigid contacts";

/// Seconds between the states compared.
const APART: f64 = 0.004;
const STATES: usize = 5;

/// Uniform in [−1, 1), the same in every run (splitmix64).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / 2.0_f64.powi(63) - 1.0
    }
}

fn agrees<M>(name: &str, model: &M, definition: &str, coordinates: &str)
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let reason = REFUSED.iter().find(|(of, _)| *of == name).map(|(_, reason)| *reason);
    let mechanisms =
        [Algebra::Dense, Algebra::Sparse].map(|algebra| Mechanism::with_algebra(definition, algebra));
    let [Ok(dense), Ok(sparse)] = mechanisms else {
        let error = mechanisms.into_iter().find_map(Result::err).expect("one of them");
        assert!(matches!(error, DefinitionError::NotThereYet { .. }), "{name}: {error}");
        assert!(reason.is_some_and(|reason| error.to_string().contains(reason)), "{name}: {error}");
        return;
    };
    assert_eq!(reason, None, "{name} is not refused any more");
    let mut mechanisms = [dense, sparse];

    let mut random = Random(name.len() as u64);
    // Teeth in error by metres would be driven through each other.
    let largest = if name == "meshed" { 1e-5 } else { 1.0 };
    let inputs: Vec<f64> = M::Inputs::NAMES.iter().map(|_| largest * random.unit()).collect();
    let given = |_: f64, _: &StateOf<M>| {
        let mut fields: <M::Inputs as Fields<f64>>::Array = Vector::zeros(inputs.len());
        fields.as_mut_slice().copy_from_slice(&inputs);
        M::Inputs::from_array(fields)
    };
    let names: Vec<String> = mechanisms[0].bodies().map(str::to_string).collect();
    let mut angles = vec![0.0; names.len()];
    let mut worst = 0.0_f64;
    let start = model.start();
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    // Its teeth swing at 55 kHz.
    let step = if name.starts_with("planetary_stage") { 1e-6 } else { 2e-5 };
    let mut simulation =
        Simulation::new(model, start.clone()).formulation(baumgarte).sampled(given).step(step);
    for k in 0..STATES {
        let time = k as f64 * APART;
        let along = simulation.advance_until(time).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut wish = model.zero_v();
        wish.as_mut_slice().iter_mut().for_each(|v| *v = random.unit());
        let other = project_velocity(model, time, &along.q, &wish).map(|v| State { v, ..along.clone() });
        // Gates that are held are there what they are of that state: the law is then the one without gates.
        let other = other.map(|state| State { gates: model.live_gates(time, &state), ..state });
        for state in std::iter::once(along).chain(other) {
            let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
            model.acceleration(time, &state, &given(time, &state), &mut a, &mut lambda);
            let motions = mapping::bodies(model, time, &state, &a, &mut angles);
            let mut rates = model.zero_z();
            model.internal_rates(time, &state, &given(time, &state), &a, &lambda, &mut rates);
            let efforts = model.driver_efforts(time, &state.q, &state.v, &lambda);
            let efforts: Vec<f64> = efforts.as_ref().iter().map(|[effort, _]| *effort).collect();
            let modes = beams::modes(coordinates, state.q.as_slice(), state.v.as_slice(), a.as_slice());
            let expected = At {
                time,
                modes: &modes,
                inputs: &inputs,
                internal: state.z.as_slice(),
                rates: rates.as_slice(),
                efforts: &efforts,
            };
            for mechanism in &mut mechanisms {
                worst = worst.max(apart(name, mechanism, &names, &motions, &expected));
            }
        }
    }
    println!("{name}: {worst:.1e}");
    // What accelerates the light wheels are small differences of stiff forces.
    let tolerance = if name.starts_with("planetary_stage") { 1e-4 } else { TOLERANCE };
    assert!(worst < tolerance, "{name}: {worst:.1e}");
}

/// What else belongs to a state of the emitted model.
struct At<'a> {
    time: f64,
    inputs: &'a [f64],
    internal: &'a [f64],
    /// ż.
    rates: &'a [f64],
    /// What the drivers exert.
    efforts: &'a [f64],
    /// Modes of beams: coordinate, rate and acceleration.
    modes: &'a [(String, [f64; 3])],
}

/// The largest difference of accelerations at one state, relative to the largest acceleration; or of a rate of an internal state,
/// relative to the rate; or of an effort of a driver, relative to the largest.
fn apart(name: &str, mechanism: &mut Mechanism, names: &[String], motions: &[BodyMotion], at: &At) -> f64 {
    let mut state = mapping::state(mechanism, motions, at.internal);
    beams::set_modes(mechanism, &mut state, at.modes);
    let [mut a, mut lambda] = [mechanism.velocity_count(), mechanism.row_count()].map(|n| vec![0.0; n]);
    mechanism
        .acceleration(at.time, &state.q, &state.v, at.inputs, Formulation::Lagrange, &mut a, &mut lambda)
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut rates = vec![0.0; at.rates.len()];
    mechanism.internal_rates(at.time, &state, at.inputs, &lambda, &mut rates).expect("rates");
    let of_rates = rates.iter().zip(at.rates).map(|(found, rate)| (found - rate).abs() / rate.abs().max(1.0));
    let worst_rate = of_rates.fold(0.0, f64::max);
    let (mut difference, mut size) = (0.0_f64, 1.0_f64);
    for (body, motion) in names.iter().zip(motions) {
        let found = mechanism.body(body, &state, &a).expect("a body");
        let pairs = [
            (found.acceleration, motion.acceleration),
            (found.angular_acceleration, motion.angular_acceleration),
        ];
        for (found, expected) in
            pairs.into_iter().flat_map(|(found, expected)| found.into_iter().zip(expected))
        {
            difference = difference.max((found - expected).abs());
            size = size.max(expected.abs());
        }
    }
    for (mode, [_, _, expected]) in at.modes {
        let found = mechanism.mode_acceleration(mode, &a).expect("a mode");
        difference = difference.max((found - expected).abs());
        size = size.max(expected.abs());
    }
    // The force of a driver along its quantity is −λ.
    let drivers: Vec<usize> =
        mechanism.rows().enumerate().filter(|(_, row)| row.ends_with(".driver")).map(|(k, _)| k).collect();
    assert_eq!(drivers.len(), at.efforts.len(), "{name}");
    let largest = at.efforts.iter().fold(1.0_f64, |most, effort| most.max(effort.abs()));
    let efforts = drivers.iter().zip(at.efforts).map(|(row, effort)| (lambda[*row] + effort).abs() / largest);
    efforts.fold(worst_rate.max(difference / size), f64::max)
}

macro_rules! all {
    ($($name:ident: $model:path),* $(,)?) => {
        $(#[test] fn $name() {
            use $model as Model;
            agrees(stringify!($name), &Model::<f64>::default(), Model::<f64>::DEFINITION, Model::<f64>::COORDINATES);
        })*
    };
}

linkwright_models::for_each_model!(all);
mechanisms::zoo::for_each_in_zoo!(all);
