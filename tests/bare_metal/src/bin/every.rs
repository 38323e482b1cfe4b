//! Every model that ships, in double precision with the feature `double`, else in single; on the host or on the machine.
#![cfg_attr(target_os = "none", no_std, no_main)]

use bare_metal::Meter;
use bare_metal::exercise::exercise;

#[cfg(feature = "double")]
type Number = f64;
#[cfg(not(feature = "double"))]
type Number = f32;
const SCALAR: &str = if cfg!(feature = "double") { "f64" } else { "f32" };

macro_rules! each {
    ($($name:ident: $model:path),* $(,)?) => {
        /// A function for each model, so that no frame holds them all.
        pub fn every(meter: &mut impl Meter) {
            $(
                #[inline(never)]
                fn $name(meter: &mut impl Meter) {
                    use $model as Model;
                    exercise::<Number, _>(stringify!($name), SCALAR, &Model::<Number>::default(), meter);
                }
                $name(meter);
            )*
        }
    };
}
linkwright_models::for_each_model!(each);

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { bare_metal::machine::exit(false) };
    let mut machine = bare_metal::machine::Machine::new(peripherals.SYST);
    every(&mut machine);
    bare_metal::machine::exit(true)
}

#[cfg(not(target_os = "none"))]
fn main() {
    struct Host;
    impl Meter for Host {
        fn instructions(&mut self, mut work: impl FnMut()) -> u32 {
            work();
            0
        }
        fn stack(&mut self, mut work: impl FnMut()) -> u32 {
            work();
            0
        }
        fn tell(&mut self, text: &str) {
            print!("{text}");
        }
    }
    every(&mut Host);
}
