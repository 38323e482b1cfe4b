//! A body that deforms by the modes of a finite element model, which a file brings with mass, inertia and nodes. What it says stands in `modal`,
//! its equations in `equations/space/flexible.rs`.

use crate::forms::{BodyForm, Deforms, Outline, Solid};

pub static BODY: BodyForm = BodyForm {
    word: "flexible",
    is: "a body that deforms by the modes of a finite element model, which a file has: `flexible arm(file = \"arm.flex\") { … }`",
    planar: None,
    spatial: Some(&Solid { lengths: &[], moments: None, volume: None }),
    turns: true,
    states_center: false,
    has_ends: false,
    deforms: Deforms::Modal,
    outline: Outline::None,
};
