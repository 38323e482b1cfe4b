//! A slender beam along x that bends, in a floating frame of reference: m L²/12 about its middle while it is straight. Its modes stand
//! in `beams`, its equations in `equations/plane/flexible.rs`.

use crate::forms::{BodyForm, Length, Moment, Outline, Solid};

pub static BODY: BodyForm = BodyForm {
    word: "beam",
    is: "a slender beam along x that bends, with points `start`, `center` and `end` on its axis",
    planar: Some(&Solid {
        lengths: &[Length::needed("length")],
        moments: Some([Moment::NONE, Moment::NONE, Moment::new(&[(1.0, "length")], 12.0)]),
        volume: None,
    }),
    spatial: None,
    turns: true,
    states_center: false,
    has_ends: true,
    bends: true,
    outline: Outline::Bar,
};
