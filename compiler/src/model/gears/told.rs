//! A pair of toothings in words and numbers, for the page and `explain`.

use super::super::Mechanism;
use super::{Pair, Toothing};
use crate::numbers::coordinate;

/// What is told of a pair.
#[derive(Clone, Debug)]
pub struct Told {
    pub name: String,
    /// `sun.rim` and `planet.rim`.
    pub of: [String; 2],
    /// `40 and 20 teeth of 2 mm`.
    pub teeth: String,
    /// m.
    pub distance: f64,
    /// α_w, degrees.
    pub working_angle: f64,
    pub contact_ratio: f64,
    /// ε_β, zero of straight teeth.
    pub overlap: f64,
    /// After so many turns of the first wheel the same teeth meet again.
    pub hunting: f64,
}

impl Told {
    pub fn of(mechanism: &Mechanism, pair: &Pair) -> Told {
        let ([first, second], mesh) = mechanism.mesh_of(pair);
        let of = |toothing: &Toothing| toothing.text.clone();
        Told {
            name: pair.name.text.clone(),
            of: [of(first), of(second)],
            teeth: format!(
                "{} and {} teeth of {} mm",
                first.teeth,
                second.teeth,
                coordinate(1e3 * first.module, 6)
            ),
            distance: pair.distance(),
            working_angle: mesh.working_angle.map_or(0.0, f64::to_degrees),
            contact_ratio: mesh.contact_ratio,
            overlap: mesh.overlap,
            hunting: second.teeth / common(first.teeth, second.teeth),
        }
    }

    /// As cells of a table, with names as they are set there.
    pub fn cells(&self, set: fn(&str) -> String) -> Vec<String> {
        let overlap = if self.overlap > 0.0 {
            format!(" and overlap {}", coordinate(self.overlap, 4))
        } else {
            String::new()
        };
        let turns = if self.hunting == 1.0 {
            "every turn".to_string()
        } else {
            format!("every {} turns", self.hunting)
        };
        vec![
            set(&self.name),
            self.of.each_ref().map(|of| set(of)).join(" and "),
            self.teeth.clone(),
            format!(
                "axes {} mm apart at {} deg",
                coordinate(1e3 * self.distance, 6),
                coordinate(self.working_angle, 5)
            ),
            format!("contact ratio {}{overlap}", coordinate(self.contact_ratio, 4)),
            format!("the same teeth meet {turns}"),
        ]
    }
}

/// The greatest common divisor of whole numbers.
fn common(a: f64, b: f64) -> f64 {
    let (mut a, mut b) = (a, b);
    while b != 0.0 {
        (a, b) = (b, a % b);
    }
    a
}
