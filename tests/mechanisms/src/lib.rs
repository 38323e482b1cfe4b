//! What test programs share: every mechanism as generic checks see it, and the small mechanisms that ship with nobody. They are
//! expanded and type-checked here once; their functions are generated here once (`instances`), the rest of their code in each program that runs them.

pub mod everything;
pub mod files;
pub mod instances;
pub mod mutants;
#[path = "../../runtime_fuzz/random.rs"]
pub mod random;
pub mod registry;
pub mod zoo;
pub mod zoo_beams;
pub mod zoo_beams_in_space;
pub mod zoo_beams_thick;
pub mod zoo_bristles;
pub mod zoo_cables;
pub mod zoo_cams;
pub mod zoo_contacts;
pub mod zoo_curves;
pub mod zoo_dry;
pub mod zoo_friction;
pub mod zoo_gates;
pub mod zoo_gears;
pub mod zoo_hysteresis;
pub mod zoo_laws;
pub mod zoo_loose;
pub mod zoo_memories;
pub mod zoo_meshes;
pub mod zoo_modal;
pub mod zoo_parts;
pub mod zoo_penalties;
pub mod zoo_profiles;
pub mod zoo_rubbing;
pub mod zoo_rubbing_beams;
pub mod zoo_space;
pub mod zoo_tangent;
