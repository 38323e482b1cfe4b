//! A disk across z: m r²/2 about it, m (3 r² + t²)/12 across.

use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid, Volume};
use std::f64::consts::PI;

const LENGTHS: &[Length] = &[Length::needed("radius"), Length::optional("thickness")];
const ABOUT: Moment = Moment::new(&[(1.0, "radius")], 2.0);
const ACROSS: Moment = Moment::new(&[(3.0, "radius"), (1.0, "thickness")], 12.0);
const VOLUME: Volume = Volume { factor: PI, edges: &[("radius", 2), ("thickness", 1)] };

pub static BODY: BodyForm = BodyForm {
    word: "disk",
    is: "a disk across z",
    planar: Some(&Solid {
        lengths: LENGTHS,
        moments: Some([Moment::NONE, Moment::NONE, ABOUT]),
        volume: Some(VOLUME),
    }),
    spatial: Some(&Solid { lengths: LENGTHS, moments: Some([ACROSS, ACROSS, ABOUT]), volume: Some(VOLUME) }),
    turns: true,
    states_center: false,
    has_ends: false,
    deforms: Deforms::Not,
    outline: Outline::Disk,
};
