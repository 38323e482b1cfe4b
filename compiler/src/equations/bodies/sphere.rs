//! A solid sphere, in space: 2 m r²/5.

use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid, Volume};
use std::f64::consts::PI;

const MOMENT: Moment = Moment::new(&[(2.0, "radius")], 5.0);

pub static BODY: BodyForm = BodyForm {
    word: "sphere",
    is: "a solid sphere",
    planar: None,
    spatial: Some(&Solid {
        lengths: &[Length::needed("radius")],
        moments: Some([MOMENT, MOMENT, MOMENT]),
        volume: Some(Volume { factor: 4.0 / 3.0 * PI, edges: &[("radius", 3)] }),
    }),
    turns: true,
    states_center: false,
    has_ends: false,
    deforms: Deforms::Not,
    outline: Outline::Ball,
};
