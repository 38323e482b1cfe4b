//! Every shipped model and the zoo's: the accelerations of all bodies, rates of internal states and efforts of drivers by the generic
//! solver, dense and sparse, against those of the emitted code, at states along the motion and with other velocities there; or the
//! definition is refused, for the reason that stands here.

mod mapping;

use linkwright::{Assemble, Fields, Report, StateOf, Vector};
use linkwright_generic::{Algebra, DefinitionError, Mechanism};
use mapping::beams;
use mapping::states::{Random, inputs, is_within_half_a_turn, scattered, states};
use mapping::truth::{At, Truth};

/// Largest difference of accelerations, relative to the largest of the mechanism, or to 1 where that is more.
const TOLERANCE: f64 = 1e-8;

/// Models that are refused, and what is not there yet.
const REFUSED: &[(&str, &str)] = &[
    ("ball_between_walls", RIGID),
    ("block", MODAL),
    ("braking", DRY),
    ("braking_all_ways", DRY),
    ("braking_in_space", DRY),
    ("cam_lift_off", RIGID),
    ("cammed", "joints on cams"),
    ("cantilever", MODAL),
    ("dropping", RIGID),
    ("floated", "a mesh on axes that move"),
    ("gripping", RIGID),
    ("gripping_in_space", RIGID),
    ("hammer_at_rigid_wall", RIGID),
    ("rasping", RIGID),
    ("remembering", "memories and events"),
    ("remembering_brakes", "memories and events"),
    ("remembering_impacts", "memories and events"),
    ("remembering_touches", "memories and events"),
    ("rimless_wheel", RIGID),
    ("rubbed_wire", "friction along a curve"),
    ("rubbing_flexible_block", MODAL),
    ("slider_crank_on_stop", RIGID),
    ("striking", RIGID),
    ("woodpecker", RIGID),
    ("yielding", "friction in joints that yield"),
];
const MODAL: &str = "bodies with the modes of a file";
const DRY: &str = "dry friction that sticks in joints";
const RIGID: &str = "impulses of rigid contacts";

/// Moments of the motion.
const MOMENTS: usize = 5;

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
    let largest = mapping::largest_input(name);
    let values: Vec<f64> = M::Inputs::NAMES.iter().map(|_| largest * random.unit()).collect();
    let along = states(name, model, &values, MOMENTS, &mut random);
    let worst = apart(name, model, coordinates, &mut mechanisms, &values, along);
    println!("{name}: {worst:.1e}");
    // What accelerates the light wheels are small differences of stiff forces.
    let tolerance = if name.starts_with("planetary_stage") { 1e-4 } else { TOLERANCE };
    assert!(worst < tolerance, "{name}: {worst:.1e}");
}

/// By how much the mechanisms differ from the emitted code, at most.
fn apart<M>(
    name: &str,
    model: &M,
    coordinates: &str,
    mechanisms: &mut [Mechanism],
    values: &[f64],
    states: Vec<(f64, StateOf<M>)>,
) -> f64
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let given = inputs::<M>(values);
    let mut angles = vec![0.0; mechanisms[0].bodies().count()];
    let mut worst = 0.0_f64;
    for (time, state) in states {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(time, &state, &given, &mut a, &mut lambda);
        let motions = mapping::bodies(model, time, &state, &a, &mut angles);
        let mut rates = model.zero_z();
        model.internal_rates(time, &state, &given, &a, &lambda, &mut rates);
        let efforts = model.driver_efforts(time, &state.q, &state.v, &lambda);
        let efforts: Vec<f64> = efforts.as_ref().iter().map(|[effort, _]| *effort).collect();
        let modes = beams::modes(coordinates, state.q.as_slice(), state.v.as_slice(), a.as_slice());
        let internal = state.z.as_slice();
        let at = At { time, inputs: values, internal, motions: &motions, modes: &modes };
        for mechanism in mechanisms.iter_mut() {
            let truth = Truth::of(name, mechanism, &at);
            let apart = truth.difference(&motions, &modes, rates.as_slice(), &efforts);
            assert!(apart.is_finite(), "{name}");
            worst = worst.max(apart);
        }
    }
    worst
}

/// Where bodies lie deep in one another, every part of a gap is the nearest one at some state: ends and corners as well as sides.
fn agrees_deep_inside<M>(name: &str, model: &M, definition: &str, coordinates: &str)
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let mut mechanism = [Mechanism::from_definition(definition).unwrap_or_else(|error| panic!("{error}"))];
    let mut random = Random(1);
    let mut worst = 0.0_f64;
    let mut seen = 0;
    for _ in 0..400 {
        let values: Vec<f64> = M::Inputs::NAMES.iter().map(|_| random.unit()).collect();
        let state = scattered(model, 2.5, &mut random);
        let Some(state) = state.filter(|(_, state)| is_within_half_a_turn(model, state)) else { continue };
        seen += 1;
        let found = apart(name, model, coordinates, &mut mechanism, &values, vec![state]);
        worst = worst.max(found);
    }
    println!("{name}: {worst:.1e} at {seen} states");
    assert!(seen > 200 && worst < TOLERANCE, "{name}: {worst:.1e} at {seen} states");
}

macro_rules! deep {
    ($($name:ident: $model:path),* $(,)?) => {
        mod deep_inside {
            $(#[test] fn $name() {
                use $model as Model;
                let model = Model::<f64>::default();
                super::agrees_deep_inside(stringify!($name), &model, Model::<f64>::DEFINITION, Model::<f64>::COORDINATES);
            })*
        }
    };
}

deep! {
    touching: mechanisms::zoo_contacts::Touching,
    bumping: mechanisms::zoo_contacts::Bumping,
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
