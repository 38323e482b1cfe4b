//! A box of three edges along x, y, z: m (b² + c²)/12 about the first, and so on.

use crate::forms::{BodyForm, Deforms, Length, Moment, Outline, Solid, Volume};

const EDGES: [&str; 3] = ["size along x", "size along y", "size along z"];

pub static BODY: BodyForm = BodyForm {
    word: "box",
    is: "a box along x, y, z",
    planar: Some(&Solid {
        lengths: &[Length::needed("width"), Length::needed("height"), Length::optional("thickness")],
        moments: Some([Moment::NONE, Moment::NONE, Moment::new(&[(1.0, "width"), (1.0, "height")], 12.0)]),
        volume: Some(Volume { factor: 1.0, edges: &[("width", 1), ("height", 1), ("thickness", 1)] }),
    }),
    spatial: Some(&Solid {
        lengths: &[Length::of_size(EDGES[0], 0), Length::of_size(EDGES[1], 1), Length::of_size(EDGES[2], 2)],
        moments: Some([
            Moment::new(&[(1.0, EDGES[1]), (1.0, EDGES[2])], 12.0),
            Moment::new(&[(1.0, EDGES[0]), (1.0, EDGES[2])], 12.0),
            Moment::new(&[(1.0, EDGES[0]), (1.0, EDGES[1])], 12.0),
        ]),
        volume: Some(Volume { factor: 1.0, edges: &[(EDGES[0], 1), (EDGES[1], 1), (EDGES[2], 1)] }),
    }),
    turns: true,
    states_center: false,
    has_ends: false,
    deforms: Deforms::Not,
    outline: Outline::Box,
};
