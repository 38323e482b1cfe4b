//! A cylinder along x, in space: m r²/2 along it, m (3 r² + L²)/12 across.

use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid, Volume};
use std::f64::consts::PI;

pub(super) const ALONG: Moment = Moment::new(&[(1.0, "radius")], 2.0);
pub(super) const ACROSS: Moment = Moment::new(&[(3.0, "radius"), (1.0, "length")], 12.0);
pub(super) const VOLUME: Volume = Volume { factor: PI, edges: &[("radius", 2), ("length", 1)] };

pub static BODY: BodyForm = BodyForm {
    word: "cylinder",
    is: "a cylinder along x, with points `start` and `end`",
    planar: None,
    spatial: Some(&Solid {
        lengths: &[Length::needed("length"), Length::needed("radius")],
        moments: Some([ALONG, ACROSS, ACROSS]),
        volume: Some(VOLUME),
    }),
    turns: true,
    states_center: false,
    has_ends: true,
    deforms: Deforms::Not,
    outline: Outline::Bar,
};
