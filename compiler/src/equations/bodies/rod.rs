//! A round rod along x, in the plane and in space: m r²/2 along it, m (3 r² + L²)/12 across.

use super::cylinder::{ACROSS, ALONG, VOLUME};
use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid};

const LENGTHS: &[Length] = &[Length::needed("length"), Length::optional("radius")];

pub static BODY: BodyForm = BodyForm {
    word: "rod",
    is: "a round rod along x, with points `start` and `end`",
    planar: Some(&Solid {
        lengths: LENGTHS,
        moments: Some([Moment::NONE, Moment::NONE, ACROSS]),
        volume: Some(VOLUME),
    }),
    spatial: Some(&Solid { lengths: LENGTHS, moments: Some([ALONG, ACROSS, ACROSS]), volume: Some(VOLUME) }),
    turns: true,
    states_center: false,
    has_ends: true,
    deforms: Deforms::Not,
    outline: Outline::Bar,
};
