//! The compiler's check of its own work raises no false alarm: nothing is said of any mechanism that ships or of the zoo, in either
//! set of coordinates, at several states and with other parameters.

use crate::registry::{Model, compiled, for_each};
use crate::zoo_tangent::for_each_with_tangent;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::self_check::{Extent, self_check};

for_each!(nothing_is_said_of_what_is_right);
for_each_with_tangent!(nothing_is_said_of_right_derivatives);

fn nothing_is_said_of_what_is_right<M: Model>() {
    let model = M::standard();
    for coordinates in [Coordinates::Absolute, Coordinates::Tree] {
        let compiled = compiled::<M>(Some(coordinates));
        for extent in [Extent::Passing, Extent::Thorough] {
            let found = self_check(&compiled, extent);
            assert!(found.is_empty(), "{} in {coordinates:?} coordinates: {}", model.name(), found[0]);
        }
    }
}

fn nothing_is_said_of_right_derivatives<M: Model>() {
    let model = M::standard();
    assert!(compiled::<M>(None).complete.tangents.is_some(), "{}: nothing would be compared", model.name());
    nothing_is_said_of_what_is_right::<M>();
}
