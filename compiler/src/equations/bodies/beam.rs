//! A slender beam along x that bends, in a floating frame of reference: m L²/12 about its middle while it is straight. Its modes stand
//! in `beams`, its equations in `equations/plane/flexible.rs` and `equations/space/flexible.rs`; what it has about its own axis follows
//! from its section.

use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid};

const LENGTHS: &[Length] = &[Length::needed("length")];
const ACROSS: Moment = Moment::new(&[(1.0, "length")], 12.0);

pub static BODY: BodyForm = BodyForm {
    word: "beam",
    is: "a slender beam along x that bends, with points `start`, `center` and `end` on its axis",
    planar: Some(&Solid {
        lengths: LENGTHS,
        moments: Some([Moment::NONE, Moment::NONE, ACROSS]),
        volume: None,
    }),
    spatial: Some(&Solid { lengths: LENGTHS, moments: Some([Moment::NONE, ACROSS, ACROSS]), volume: None }),
    turns: true,
    states_center: false,
    has_ends: true,
    deforms: Deforms::Beam,
    outline: Outline::Bar,
};
