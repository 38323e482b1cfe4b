//! Spatial mechanisms: a tree of links, each moved against its parent by one elementary motion.

pub mod articulated;
mod axes;
mod bodies;
mod coordinates;
mod dynamics;
mod flexible;
mod inertial;
pub mod joints;
mod kinematics;
mod links;
pub mod loads;
mod shapes;
mod tensor;
mod trees;
mod vector;
mod vector_jet;

pub use axes::matrix as place_axes;
pub use bodies::consequences;
pub use coordinates::{constant_axis, coordinates};
pub use dynamics::{dynamics, kinetic_energy_of_slices};
pub use inertial::{Cosines, Inertial};
pub use kinematics::Kinematics;
pub use tensor::Distribution;
pub use trees::{absolute_operations, fewest_freedoms};
