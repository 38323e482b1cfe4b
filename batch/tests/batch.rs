//! Batches: members move as alone, whatever stands beside them; those that fail are named; results are where they belong.

use linkwright::{AssembleExt, F64x4, F64x8, Mechanism, Rk4, Stepper, mechanism};
use linkwright_batch::{Batch, BatchError, Constant, Each, Failure, InLanesOf, PerMember};
use linkwright_models::general_four_bar::{ParametricFourBar, ParametricFourBarParameters};
use std::sync::Mutex;

mechanism! {
    /// A cart on a spring, pushed.
    planar Cart {
        param stiffness [N/m] = 40 in 1..100;
        input push [N];
        particle cart { mass [kg] = 2; }
        joint rail: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), cart.center);
        force drive: force(cart.center) = (push, 0);
        spring back: spring(ground(-1, 0) [m], cart.center, stiffness = stiffness, length [m] = 1.5);
        start { cart.center.x [m] = 0.7; }
        output x [m] = cart.center.x;
    }
}

const H: f64 = 1e-3;

fn parameters(member: usize) -> CartParameters {
    CartParameters { stiffness: 10.0 + member as f64 }
}

fn alone(member: usize, steps: usize, push: impl Fn(f64, &CartState) -> f64) -> CartState {
    let model = Cart::prepare(parameters(member)).expect("the stiffness is within its bounds");
    let mut stepper = model.stepper(model.assemble(&Cart::START).expect("it can be assembled"), Rk4);
    for _ in 0..steps {
        let inputs = CartInputs { push: push(stepper.time(), stepper.state()) };
        stepper.step(&inputs, H).expect("the step is taken");
    }
    *stepper.state()
}

/// Numbers of members that lanes divide and that they do not; laws in every form.
#[test]
fn members_move_as_alone() {
    for count in [1, 3, 4, 5, 8, 13] {
        let mut batch = Batch::<Cart, _, F64x4>::prepare(count, Rk4, parameters).expect("there are members");
        let law = Each(|member: usize, time: f64, state: &CartState| CartInputs {
            push: member as f64 * time - 0.1 * state.v[0],
        });
        let summary = batch.run(&law, H, 50);
        assert_eq!((summary.steps, summary.failed, batch.len()), (50 * count as u64, 0, count));
        let positions = batch.outputs(&law);
        for member in 0..count {
            let expected = alone(member, 50, |time, state| member as f64 * time - 0.1 * state.v[0]);
            assert_eq!(batch.state(member), Some(expected), "{member} of {count}");
            assert_eq!(positions.column("x").map(|x| x[member]), Some(expected.q[0]));
        }
        assert_eq!(positions.column("x").map(<[f64]>::len), Some(count));
        assert!(positions.column("y").is_none());
    }
}

#[test]
fn laws_in_lanes_and_for_each_member() {
    let in_lanes = InLanesOf::<F64x8, _>::new(|group: &linkwright_batch::Group<'_, Cart, F64x8>| {
        CartInputs { push: group.times * group.times }
    });
    let mut batch = Batch::<Cart, _, F64x8>::prepare(11, Rk4, parameters).expect("there are members");
    batch.run(&in_lanes, H, 20);
    assert_eq!(batch.state(10), Some(alone(10, 20, |time, _| time * time)));

    let pushes: Vec<CartInputs> = (0..11).map(|member| CartInputs { push: member as f64 }).collect();
    let mut batch = Batch::<Cart, _>::prepare(11, Rk4, parameters).expect("there are members");
    batch.run(&PerMember(&pushes), H, 20);
    assert_eq!(batch.state(7), Some(alone(7, 20, |_, _| 7.0)));

    // Where there are none for a member, it fails, and no other.
    batch.step(&PerMember(&pushes[..9]), H);
    assert_eq!(batch.failures().map(|(member, _)| member).collect::<Vec<_>>(), [9, 10]);
    batch.step(&PerMember(&[]), H);
    assert_eq!(batch.failures().count(), 11);
}

/// A member out of bounds and one that diverges: both are named, the others go on; and one is begun once more.
#[test]
fn members_that_fail_are_named() {
    let bad = |member: usize| CartParameters { stiffness: if member == 2 { 1000.0 } else { 40.0 } };
    let mut batch = Batch::<Cart, _>::prepare(7, Rk4, bad).expect("there are members");
    let found: Vec<_> = batch.failures().collect();
    assert!(matches!(found[..], [(2, Failure::Parameters(_))]), "{found:?}");
    assert!(batch.state(2).is_none() && batch.model(2).is_none() && batch.time(2).is_none());

    let law = Each(|member: usize, time: f64, _: &CartState| CartInputs {
        push: if member == 5 && time > 0.0105 { f64::NAN } else { 1.0 },
    });
    let summary = batch.run(&law, H, 40);
    assert_eq!((summary.failed, summary.steps), (1, 5 * 40 + 11));
    assert_eq!(batch.failures().map(|(member, _)| member).collect::<Vec<_>>(), [2, 5]);
    let error = batch.failure(5).expect("it failed").to_string();
    assert!(error.contains("an input is not finite"), "{error}");
    // It stands where it was; what stands beside it does not.
    assert!((batch.time(5).expect("it has a state") - 0.011).abs() < 1e-15);
    assert!((batch.time(4).expect("it has a state") - 0.040).abs() < 1e-15);
    let x = batch.outputs(&Constant(CartInputs { push: 1.0 }));
    let x = x.column("x").expect("an output");
    assert!(x[2].is_nan() && [0, 1, 3, 4, 5, 6].iter().all(|&member| x[member].is_finite()));

    let model = Cart::default();
    for member in [2, 5] {
        batch.set(member, &model, 0.0, &Cart::START).expect("the state is finite");
    }
    assert_eq!(batch.failures().count(), 0);
    assert_eq!(batch.run(&Constant(CartInputs { push: 1.0 }), H, 3).steps, 21);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let none = Batch::<Cart, _>::prepare(0, Rk4, parameters).expect_err("it has no members");
    assert_eq!(none, BatchError::Empty);
    assert_eq!(none.to_string(), "a batch has at least one member; 0 were asked for");
    let bad = Batch::<Cart, _>::prepare(3, Rk4, |_| CartParameters { stiffness: f64::NAN });
    let bad = bad.expect_err("no member can be").to_string();
    assert!(bad.starts_with("no member of the batch can be prepared; the first: "), "{bad}");

    let mut batch = Batch::<Cart, _>::prepare(3, Rk4, parameters).expect("there are members");
    let far = batch.set(3, &Cart::default(), 0.0, &Cart::START).expect_err("there are three");
    assert_eq!(far.to_string(), "there is no member 3: the batch has 3, counted from 0");
    let mut state = Cart::START;
    state.v[0] = f64::INFINITY;
    let error = batch.set(1, &Cart::default(), 0.0, &state).expect_err("a velocity is infinite");
    assert!(matches!(error, BatchError::Member { member: 1, .. }), "{error}");
    // A step of no size stops every member, and says so.
    let summary = batch.step(&Constant(CartInputs { push: 0.0 }), 0.0);
    assert_eq!((summary.failed, batch.failures().count()), (3, 3));
}

#[test]
fn recordings_and_folds() {
    let law = Constant(CartInputs { push: 1.0 });
    let mut recorded = Batch::<Cart, _>::prepare(6, Rk4, parameters).expect("there are members");
    let mut folded = recorded.clone();
    let recording = recorded.record(&law, H, 30, 10);
    assert_eq!(recording.steps, [0, 10, 20, 30]);
    for (sample, &steps) in recording.samples.iter().zip(&recording.steps) {
        for member in 0..6 {
            let expected = alone(member, steps, |_, _| 1.0).q[0];
            assert_eq!(sample.column("x").map(|x| x[member]), Some(expected));
        }
    }
    let least =
        folded.fold(&law, H, 30, f64::INFINITY, |_, least: &mut f64, outputs| *least = least.min(outputs.x));
    for (member, least) in least.into_iter().enumerate() {
        assert_eq!(least, alone(member, 30, |_, _| 1.0).q[0], "it is pulled back all the time");
    }
}

/// The same whatever the number of threads, and progress is told to the end.
#[test]
fn threads_and_progress() {
    let parameters = |member: usize| ParametricFourBarParameters {
        start_angle: 0.6 + 0.01 * member as f64,
        ..Default::default()
    };
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("there are threads");
        pool.install(|| {
            let mut batch =
                Batch::<ParametricFourBar, _>::prepare(10, Rk4, parameters).expect("there are members");
            let told = Mutex::new(Vec::new());
            batch.run_with_progress(&(), 1e-3, 100, |part| told.lock().expect("no panic").push(part));
            let told = told.into_inner().expect("no panic");
            assert!(told.contains(&1.0) && told.iter().all(|part| *part > 0.0 && *part <= 1.0));
            (0..10).map(|member| batch.state(member)).collect::<Vec<_>>()
        })
    };
    let one = of(1);
    assert_eq!(one, of(2));
    let model = ParametricFourBar::prepare(parameters(9)).expect("it is a four-bar");
    let start = model.assemble(&ParametricFourBar::START).expect("it can be assembled");
    let mut stepper = Stepper::<_, _, f64>::new(model, start, Rk4);
    (0..100).for_each(|_| assert!(stepper.step(&(), 1e-3).is_ok()));
    assert_eq!(one[9].as_ref(), Some(stepper.state()));
    assert_eq!(Mechanism::<f64>::name(&model), "ParametricFourBar");
}
