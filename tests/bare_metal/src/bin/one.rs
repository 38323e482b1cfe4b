//! One mechanism by itself, as it is put into a controller: its image is what the page on controllers gives as flash. It takes ten
//! thousand steps and tells a digest of the state.
#![cfg_attr(target_os = "none", no_std, no_main)]

use bare_metal::exercise::digest;
use bare_metal::text::hexadecimal;
use core::hint::black_box;
use linkwright::{AssembleExt, Fields, Mechanism, Rk4, Vector};

#[cfg(not(any(feature = "quick_return", feature = "arm")))]
use linkwright_models::four_bar::FourBar as Model;
#[cfg(feature = "arm")]
use linkwright_models::iiwa14::Iiwa14 as Model;
#[cfg(feature = "quick_return")]
use linkwright_models::quick_return::QuickReturn as Model;

#[cfg(feature = "double")]
type Number = f64;
#[cfg(not(feature = "double"))]
type Number = f32;

type Inputs = <Model<Number> as Mechanism<Number>>::Inputs;

/// Whether all went well.
fn run(mut tell: impl FnMut(&str)) -> bool {
    let model = Model::<Number>::default();
    let mut plant = model.stepper(model.start(), Rk4);
    let inputs = <Inputs as Fields<Number>>::from_array(Vector::<Number>::zeros(
        <Inputs as Fields<Number>>::NAMES.len(),
    ));
    for _ in 0..10_000 {
        if plant.step(black_box(&inputs), 1e-3).is_err() {
            return false;
        }
    }
    hexadecimal(digest(0xcbf2_9ce4_8422_2325, plant.state()), &mut tell);
    tell("\n");
    true
}

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    bare_metal::machine::exit(run(bare_metal::machine::tell))
}

#[cfg(not(target_os = "none"))]
fn main() {
    assert!(run(|text| print!("{text}")), "a step failed");
}
