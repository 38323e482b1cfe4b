//! Where `linkwright` is reached through the re-export of another crate, by path and by `use`, and named nowhere else.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs, warnings, unused, unreachable_pub)]

renamed::engine::mechanism! {
    /// A pendulum.
    pub planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

/// The same through a name in scope.
pub mod inner {
    use renamed::engine::mechanism;

    mechanism! {
        /// A slider.
        pub planar Slider {
            body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
            joint rail: prismatic(ground(0, 0) [m], block.origin, axis = (1, 0));
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn both_are_there() {
        assert_eq!(super::Pendulum::DEGREES_OF_FREEDOM, 1);
        assert_eq!(super::inner::Slider::DEGREES_OF_FREEDOM, 1);
    }
}
