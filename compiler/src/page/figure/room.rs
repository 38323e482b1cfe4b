//! Where the sheet is free: rectangles, and whether something that is drawn reaches into them.

use crate::drawing::canvas::Trace;
use crate::drawing::view::Spot;

/// Between a name and what is drawn, px.
const GAP: f64 = 1.0;

/// A rectangle along the axes of the picture: centre and half sizes.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    pub center: Spot,
    pub half: [f64; 2],
}

impl Area {
    pub fn overlaps(&self, other: &Area) -> bool {
        (0..2).all(|k| (self.center[k] - other.center[k]).abs() < self.half[k] + other.half[k])
    }

    /// Whether a line or circle is seen in it, or within a small gap around it.
    pub fn is_crossed(&self, trace: &Trace) -> bool {
        match trace {
            Trace::Line([a, b], half) => self.meets(*a, *b, half + GAP),
            Trace::Circle { center, radius, half, is_full } => {
                let apart = [0, 1].map(|k| (self.center[k] - center[k]).abs());
                let nearest = size([0, 1].map(|k| (apart[k] - self.half[k]).max(0.0)));
                let farthest = size([0, 1].map(|k| apart[k] + self.half[k]));
                nearest < radius + half + GAP && (*is_full || farthest > radius - half - GAP)
            }
        }
    }

    /// Whether a line enters the rectangle with so much around it: what is left of the line between the limits of both
    /// axes (Liang and Barsky).
    fn meets(&self, a: Spot, b: Spot, around: f64) -> bool {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for k in 0..2 {
            let half = self.half[k] + around;
            let (start, way) = (a[k] - self.center[k], b[k] - a[k]);
            if way.abs() < 1e-9 {
                if start.abs() >= half {
                    return false;
                }
                continue;
            }
            let (one, other) = ((-half - start) / way, (half - start) / way);
            (from, to) = (from.max(one.min(other)), to.min(one.max(other)));
        }
        from < to
    }

    /// The nearest of its points to a spot.
    pub fn nearest(&self, spot: Spot) -> Spot {
        [0, 1].map(|k| self.center[k] + (spot[k] - self.center[k]).clamp(-self.half[k], self.half[k]))
    }
}

fn size([x, y]: [f64; 2]) -> f64 {
    libm::sqrt(x * x + y * y)
}
