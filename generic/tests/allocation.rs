//! Steps allocate nothing once they have begun: neither assembly nor, after its first factorisations, the linear algebra.

use linkwright::{Assemble, AssembleExt, Fields, Report, Vector};
use linkwright_generic::{Algebra, Formulation, Mechanism};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

mod mapping;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: the system's allocator does it all; the counter does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn steps_without<M>(model: &M, definition: &str, algebra: Algebra, formulation: Formulation)
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let mut mechanism = Mechanism::with_algebra(definition, algebra).expect("it is there");
    let start = model.start();
    let motions = mapping::bodies(model, 0.0, &start, &model.zero_v(), &mut Vec::new());
    let mut state = mapping::state(&mechanism, &motions, start.z.as_slice());
    mechanism.keep_phases(0.0, &state.q).expect("a position");
    let inputs = vec![0.0; M::Inputs::NAMES.len()];
    let mut step = || mechanism.step(0.0, &mut state, &inputs, formulation, 1e-5).expect("a step");
    (0..3).for_each(|_| step());
    let before = COUNT.with(Cell::get);
    (0..5).for_each(|_| step());
    let count = COUNT.with(Cell::get) - before;
    assert_eq!(count, 0, "{} {algebra:?} {formulation:?}", model.name());
}

#[test]
fn a_step_allocates_nothing() {
    use linkwright_models::{
        bricard::Bricard, cam_follower::CamFollower, four_bar::FourBar, knuckle_boom_loader::HydraulicLoader,
    };
    for algebra in [Algebra::Dense, Algebra::Sparse] {
        for formulation in [Formulation::Baumgarte { alpha: 1.0, beta: 1.0 }, Formulation::Projected] {
            steps_without(&FourBar::default(), FourBar::<f64>::DEFINITION, algebra, formulation);
            steps_without(&Bricard::default(), Bricard::<f64>::DEFINITION, algebra, formulation);
            steps_without(&CamFollower::default(), CamFollower::<f64>::DEFINITION, algebra, formulation);
            steps_without(
                &HydraulicLoader::default(),
                HydraulicLoader::<f64>::DEFINITION,
                algebra,
                formulation,
            );
        }
    }
}
