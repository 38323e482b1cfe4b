//! Definitions in a Rust file: one good, one with a mistake, one in a file, one that a macro writes.

linkwright::mechanism! {
    planar Good {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [rad] = 0.5; }
    }
}

mod deeper {
    linkwright::mechanism! {
        planar Wrong {
            rod arm { mass [kg] = 1; length [m] = 1; }
            joint pivot: revolute(ground(0, 0) [m], arm.strat);
        }
    }
    linkwright::mechanism!(file = "declared_twice.mech");
    linkwright::mechanism!(file = "misspelled_body.mech");
}

macro_rules! pendulum {
    ($(#[$documentation:meta])* $name:ident, $length:literal $(, $more:tt)*) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            planar $name {
                rod arm { mass [kg] = 1; length [m] = $length; }
                joint pivot: revolute(ground(0, 0) [m], arm.start);
                start { pivot.angle [rad] = 0.5; }
            }
        }
    };
}
pendulum! { /// Well.
    Short, 0.5 }
pendulum!(Turned, -2);
