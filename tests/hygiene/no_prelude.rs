//! A crate without a prelude.
#![no_implicit_prelude]

::linkwright::mechanism! {
    spatial Bare {
        param mass [kg] = 1;
        input push [N];
        gravity [m/s^2] = (0, 0, -9.81);
        body ball { mass [kg] = mass; inertia [kg*m^2] = (1, 1, 1); }
        joint pivot: spherical(ground(0, 0, 0) [m], ball.origin);
        force hand: force(ball.center) = (push, 0, 0);
        options { emit = (penalty, projection, null_space, tangent); }
        output height [m] = ball.center.z;
    }
}

fn main() {
    let model: Bare = ::core::default::Default::default();
    let state: BareState = Bare::START;
    let inputs = BareInputs { push: 1.0 };
    let outputs: BareOutputs = ::linkwright::Mechanism::outputs(&model, 0.0, &state, &inputs);
    ::core::assert_eq!(outputs.height, 0.0);
}
