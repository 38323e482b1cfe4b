//! In a generic function, in a module, several in one module, in a method, with restricted visibility.

mod several {
    linkwright::mechanism! {
        pub(crate) planar First {
            rod arm { mass [kg] = 1; length [m] = 1; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            output height [m] = arm.end.y;
        }
    }
    linkwright::mechanism! {
        pub(super) planar Second {
            param length [m] = 2;
            rod arm { mass [kg] = 1; length [m] = length; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            output height [m] = arm.end.y;
        }
    }
    pub mod inner {
        linkwright::mechanism! {
            pub(in crate::several) planar Third {
                rod arm { mass [kg] = 1; length [m] = 3; }
                joint pivot: revolute(ground(0, 0) [m], arm.start);
            }
        }
    }
    pub fn third() -> [f64; 2] {
        inner::Third::START.q
    }
}

/// Whatever the function is generic over, and whatever its type parameters are called.
fn generic<R, T: Into<f64>, const N: usize>(angle: T, _: R) -> f64 {
    linkwright::mechanism! {
        planar Local {
            param length [m] = 2;
            rod arm { mass [kg] = 1; length [m] = length; }
            joint pivot: revolute(ground(0, 0) [m], arm.start);
            output height [m] = arm.end.y;
        }
    }
    let model = Local::<f64>::default();
    let angle: f64 = angle.into();
    let state = linkwright::State::new([angle.cos(), angle.sin()], [0.0]);
    let outputs: LocalOutputs = linkwright::Mechanism::outputs(&model, 0.0, &state, &());
    outputs.height * N as f64
}

/// A user's code that is generic over mechanisms and their scalars.
fn energy<R: linkwright::Real, M: linkwright::Mechanism<R>>(model: &M, q: &M::Q, v: &M::V) -> R {
    model.kinetic_energy(R::from_f64(0.0), q, v)
}

struct Owner;

impl Owner {
    fn start() -> [f64; 2] {
        linkwright::mechanism! {
            planar OfAMethod {
                rod arm { mass [kg] = 1; length [m] = 1; }
                joint pivot: revolute(ground(0, 0) [m], arm.start);
            }
        }
        OfAMethod::START.q
    }
}

fn main() {
    assert_eq!(several::First::START.q, several::third());
    assert_eq!(Owner::start(), [1.0, 0.0]);
    assert!((generic::<_, f64, 3>(0.5, ()) - 6.0 * 0.5_f64.sin()).abs() < 1e-12);
    let second = several::Second::<f32>::default();
    assert!((energy(&second, &[1.0, 0.0], &[1.0]) - 4.0 / 6.0).abs() < 1e-6);
}
