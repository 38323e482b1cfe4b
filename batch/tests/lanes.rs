//! Every model in lanes moves as steppers move it alone, to the bit: with other parameters, states, inputs and steps in each lane, through
//! turns that are far, positions that are singular, and beside lanes that fail.

use linkwright::lanes::{InScalars, InputsIn, StateIn, gather_fields};
use linkwright::{
    AssembleExt, Baumgarte, Corrected, ExplicitTrapezoidal, F32x8, F32x16, F64x4, F64x8, Fields,
    LagrangeIndex1, LaneMethod, LaneStepper, Lanes, Mechanism, Parametric, Real, Rk4, SemiImplicitEuler,
    StepError, Stepper, Vector, WithMultipliers,
};
use linkwright_models::andrews::Andrews;
use linkwright_models::bricard::Bricard;
use linkwright_models::four_bar::FourBar;
use mechanisms::registry::{Model, Random, for_each};

const STEPS: usize = 24;

for_each!(lanes_move_as_steppers);

fn lanes_move_as_steppers<M: Model + InScalars<In<f64> = M>>() {
    as_steppers::<M, F64x4, _>(Rk4);
}

for_each!(in sample, corrected_lanes_move_as_steppers);

fn corrected_lanes_move_as_steppers<M: Model + InScalars<In<f64> = M>>() {
    as_steppers::<M, F64x4, _>((SemiImplicitEuler, Corrected::after(LagrangeIndex1)));
}

#[test]
fn every_kind_of_lanes_and_every_method() {
    as_steppers::<FourBar, F64x8, _>((Rk4, Baumgarte { alpha: 30.0, beta: 40.0 }));
    as_steppers::<FourBar, F32x8, _>(ExplicitTrapezoidal);
    as_steppers::<FourBar, F32x16, _>((Rk4, Corrected::after(LagrangeIndex1)));
    as_steppers::<Andrews, F64x8, _>((Rk4, WithMultipliers(Baumgarte { alpha: 30.0, beta: 40.0 })));
    as_steppers::<Andrews, F32x8, _>(Rk4);
    as_steppers::<Bricard, F64x8, _>(Rk4);
    as_steppers::<Bricard, F32x16, _>(Rk4);
}

/// A lane's stepper alone, and what is asked of it.
struct Alone<M: InScalars, S: LaneMethod<M, L>, L: Lanes> {
    stepper: Stepper<M::In<L::Scalar>, S, L::Scalar>,
    inputs: InputsIn<M, L::Scalar>,
    h: L::Scalar,
    error: Option<StepError>,
}

fn as_steppers<M: InScalars, L: Lanes, S: LaneMethod<M, L>>(method: S) {
    let model = M::In::<L::Scalar>::default();
    // Steel on steel, whose vibrations are shorter than what suits the others.
    let is_stiff = [
        "PrincetonBeam",
        "FlexibleSliderCrank",
        "Stiffened",
        "LooseWrist",
        "Meshed",
        "PlanetaryStage",
        "PlanetaryStageHeld",
        "YawDrive",
    ]
    .contains(&model.name());
    let size_of_step = if is_stiff { 1e-9 } else { 1e-4 };
    let mut random = Random::new(7);
    let mut number = |size: f64| <L::Scalar as Real>::from_f64(size * random.unit());
    let mut alone: Vec<Alone<M, S, L>> = (0..L::LANES)
        .map(|lane| {
            let (model, mut state) = other::<M, L>(&model, &mut number);
            // Velocities that turn far in a stage in one lane, little ones in the others.
            let size = if lane == 1 { 9000.0 } else { 0.01 };
            state.v.as_mut_slice().iter_mut().for_each(|v| *v = *v + number(size));
            let mut inputs = <InputsIn<M, L::Scalar> as Fields<_>>::Array::zeros(model.input_names().len());
            inputs.as_mut_slice().iter_mut().for_each(|u| *u = number(1.0));
            let h = <L::Scalar as Real>::from_f64(size_of_step * (1.0 + 0.1 * lane as f64));
            let stepper = Stepper::new(model, state, method.clone());
            Alone { stepper, inputs: Fields::from_array(inputs), h, error: None }
        })
        .collect();

    let first = &alone[0].stepper;
    let mut lanes = LaneStepper::<M, S, L>::new(first.model(), first.state(), method.clone());
    for (lane, Alone { stepper, .. }) in alone.iter().enumerate() {
        lanes.set(lane, stepper.model(), L::Scalar::ZERO, stepper.state()).expect("the state is finite");
    }
    for step in 0..STEPS {
        if step == STEPS / 2 {
            // No step at all, in the middle of the run.
            alone[2].h = -alone[2].h;
        }
        let inputs = gather_fields(|lane| alone[lane].inputs.clone());
        let mut h = L::ZERO;
        (0..L::LANES).for_each(|lane| h.set_lane(lane, alone[lane].h));
        let ticks = lanes.step(&inputs, h);
        if !model.gate_names().is_empty() {
            let refused = (0..L::LANES).all(|lane| lanes.error(lane) == Some(StepError::HeldGates));
            assert!(refused, "{}: lanes take whole steps", model.name());
            return;
        }
        let failed: Vec<usize> = ticks.failed().collect();
        for (lane, Alone { stepper, inputs, h, error }) in alone.iter_mut().enumerate() {
            if error.is_none() {
                match stepper.step(inputs, *h) {
                    Ok(tick) => {
                        let found = [ticks.time, ticks.pivot, ticks.moved].map(|all| all.lane(lane));
                        assert_eq!(found, [tick.time, tick.pivot, tick.moved], "lane {lane}, step {step}");
                        assert!(!failed.contains(&lane), "lane {lane}, step {step}");
                    }
                    Err(of_step) => {
                        *error = Some(of_step);
                        assert!(failed.contains(&lane), "lane {lane}, step {step}");
                    }
                }
            }
            assert_eq!(lanes.error(lane), *error, "lane {lane}, step {step}");
            assert_eq!(lanes.is_moving(lane), error.is_none());
            assert_eq!(lanes.time(lane), stepper.time());
            let (found, expected) = (lanes.state(lane), stepper.state());
            assert!(
                found.q == expected.q && found.v == expected.v && found.z == expected.z,
                "lane {lane}, step {step}: {found:?} {expected:?}"
            );
        }
    }
    assert!(lanes.error(2).is_some(), "a step of a negative size");
    assert!(alone.iter().any(|alone| alone.error.is_none()), "{}: no lane moved to the end", model.name());
}

/// The model with parameters a little other, and its start; as it is where that cannot be assembled.
fn other<M: InScalars, L: Lanes>(
    model: &M::In<L::Scalar>,
    number: &mut impl FnMut(f64) -> L::Scalar,
) -> (M::In<L::Scalar>, StateIn<M, L::Scalar>) {
    let mut values = model.parameters().to_array();
    for value in values.as_mut_slice() {
        *value = *value + *value * number(1e-3);
    }
    let prepared = <M::In<L::Scalar> as Parametric<L::Scalar>>::prepare(Fields::from_array(values)).ok();
    let assembled = prepared.and_then(|model| {
        let start = model.assemble(&model.start()).ok()?;
        Some((model, start))
    });
    assembled.unwrap_or_else(|| (model.clone(), model.start()))
}
