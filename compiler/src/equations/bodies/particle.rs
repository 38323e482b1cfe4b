//! A point mass: position only.

use crate::forms::{BodyForm, Deforms, Moment, Outline, Solid};

static POINT: Solid =
    Solid { lengths: &[], moments: Some([Moment::NONE, Moment::NONE, Moment::NONE]), volume: None };

pub static BODY: BodyForm = BodyForm {
    word: "particle",
    is: "a point mass; all that is attached sits at its centre",
    planar: Some(&POINT),
    spatial: Some(&POINT),
    turns: false,
    states_center: false,
    has_ends: false,
    deforms: Deforms::Not,
    outline: Outline::None,
};
