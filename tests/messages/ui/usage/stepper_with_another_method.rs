//! Methods that choose their steps, or iterate, belong to a simulation.

use linkwright::{AssembleExt, DormandPrince, GeneralisedAlpha, NullSpace, mechanism};

mechanism! {
    planar Free {
        body bob { mass [kg] = 1; inertia [kg*m^2] = 0.1; center [m] = (1, 0); }
        joint pin: revolute(ground(0, 0) [m], bob.origin);
    }
}

fn main() {
    let model = Free::<f64>::default();
    let _ = model.stepper(model.start(), DormandPrince::tolerance(1e-8));
    let _ = model.stepper(model.start(), (GeneralisedAlpha::new(0.8), NullSpace));
    let _ = model.stepper(model.start(), NullSpace);
}
