//! A body of any shape, whose inertia is stated.

use crate::forms::{BodyForm, Deforms, Outline, Solid};

static STATED: Solid = Solid { lengths: &[], moments: None, volume: None };

pub static BODY: BodyForm = BodyForm {
    word: "body",
    is: "any rigid body; its inertia is stated",
    planar: Some(&STATED),
    spatial: Some(&STATED),
    turns: true,
    states_center: true,
    has_ends: false,
    deforms: Deforms::Not,
    outline: Outline::None,
};
