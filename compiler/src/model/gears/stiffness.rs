//! The stiffness of a pair of teeth along the line of action, from their own shape, and its series over a pitch.
//!
//! Along the path of contact each tooth is a beam that is clamped at its root. `section`: a cantilever as thick as the tooth is where it is
//! touched (k = 3 E I/h³). `profile`: bending, shear and compression along the true flank (Cornell, Compliance and stress sensitivity of
//! spur gear teeth, J. Mech. Des. 103, 1981; Yang & Lin 1987), with the body below the tooth (Sainsot, Velex & Duverger, Contribution of
//! gear body to tooth deflections, J. Mech. Des. 126, 2004, table 1) and the contact, 4 (1 − ν²)/(π E b) (Yang & Sun, A rotary model for spur
//! gear dynamics, J. Mech. Trans. 107, 1985). Teeth of a ring stand on a rim that gives nothing, and so do those of a rack, whose flanks are straight. Pairs in contact add up.

use super::pair::Mesh;
use super::toothing::{Toothing, involute};
use crate::forms::Rim;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Positions over a pitch at which the stiffness is found.
const POSITIONS: usize = 256;
/// Across a slanted face, of what is shown; the series has their mean in closed form.
const SLICES: usize = 64;

/// What `involute(…)` says.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// E, Pa.
    pub young: f64,
    /// ν.
    pub poisson: f64,
    pub tooth: Tooth,
    pub harmonics: usize,
    /// The part of a pitch over which a pair enters or leaves.
    pub entry: f64,
}

/// What a tooth is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tooth {
    Section,
    Profile,
}

/// k = k₀ + Σ aₕ cos 2πhτ + bₕ sin 2πhτ, N/m.
#[derive(Clone, Debug)]
pub struct Series {
    pub mean: f64,
    pub waves: Vec<[f64; 2]>,
    /// What the series leaves out, rms, and the largest step of what it is the series of; parts of the mean.
    pub left_out: f64,
    pub step: f64,
}

/// One wheel of a pair: its shape, and where the path of contact touches it.
struct Flank {
    toothing: Toothing,
    width: f64,
    material: Material,
    /// E of bending and compression: of a plate where the face is wide.
    stiffness: f64,
    /// Half the angle of a tooth at the base circle, π/2z + inv α; of a ring that of its space there with its sign turned.
    base_angle: f64,
}

/// What the deflection of a wheel's body follows from.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// θ_f, half the angle of a tooth at its foot.
    pub half: f64,
    /// r_f by the radius of the bore.
    pub ratio: f64,
}

impl Body {
    pub fn of(wheel: &Toothing) -> Body {
        let (base, root) = (wheel.base_radius(), wheel.root_radius());
        let at_base = wheel.half_tooth() + involute(wheel.transverse_angle());
        let half = if root > base { at_base - involute(libm::acos(base / root)) } else { at_base };
        Body { half, ratio: root / wheel.bore.map_or(root / 2.0, |bore| 0.5 * bore) }
    }

    /// Where Sainsot, Velex and Duverger fitted their polynomials: θ_f from 0.01 to 0.12 rad, ratios from 1.4 to 7.
    pub fn is_known(&self) -> bool {
        (0.01..=0.12).contains(&self.half) && (1.4..=7.0).contains(&self.ratio)
    }
}

impl Series {
    /// k at a phase.
    pub fn at(&self, phase: f64) -> f64 {
        let waves = self.waves.iter().zip(1..).map(|([a, b], h)| {
            let angle = TAU * f64::from(h) * phase;
            a * libm::cos(angle) + b * libm::sin(angle)
        });
        self.mean + waves.sum::<f64>()
    }
}

impl Flank {
    /// Half the angle of the tooth where the pressure angle is α.
    fn half(&self, angle: f64) -> f64 {
        if self.toothing.is_internal() {
            self.base_angle + involute(angle)
        } else {
            self.base_angle - involute(angle)
        }
    }

    /// Of the tooth alone, m/N, touched at a distance ρ from the base tangent point; of a rack so far above its line.
    fn compliance(&self, along: f64) -> f64 {
        match self.material.tooth {
            _ if self.toothing.form.rim == Rim::Rack => self.straight(along),
            Tooth::Section => self.section(along),
            Tooth::Profile => self.profile(along),
        }
    }

    fn section(&self, along: f64) -> f64 {
        let base = self.toothing.base_radius();
        let (radius, angle) = (libm::hypot(base, along), libm::atan2(along, base));
        let half = self.half(angle);
        self.cantilever(
            (radius * libm::cos(half) - self.toothing.root_radius()).abs(),
            2.0 * radius * libm::sin(half),
        )
    }

    /// h³/3 E I.
    fn cantilever(&self, height: f64, thickness: f64) -> f64 {
        4.0 * height.powi(3) / (self.material.young * self.width * thickness.powi(3))
    }

    /// Of a rack's tooth, half as thick as a pitch at the line and by α thinner on either side above.
    fn straight(&self, height: f64) -> f64 {
        let (angle, root) = (self.toothing.pressure_angle, -self.toothing.module * self.toothing.dedendum);
        let half = |y: f64| 0.25 * PI * self.toothing.module - y * libm::tan(angle);
        match self.material.tooth {
            Tooth::Section => self.cantilever(height - root, 2.0 * half(height)),
            Tooth::Profile => {
                integral([root, height], |y| self.slice([height, half(height)], angle, [y, half(y)]))
            }
        }
    }

    /// What a slice of half the thickness x at the height y adds where the load acts at a place of the flank, by an angle from across the tooth.
    fn slice(&self, [height, across]: [f64; 2], load: f64, [y, x]: [f64; 2]) -> f64 {
        let (sine, cosine) = (libm::sin(load), libm::cos(load));
        let shear = 0.5 * self.material.young / (1.0 + self.material.poisson);
        let (area, second) = (2.0 * self.width * x, 2.0 / 3.0 * self.width * x * x * x);
        let moment = (height - y) * cosine - across * sine;
        moment * moment / (self.stiffness * second)
            + 1.2 * cosine * cosine / (shear * area)
            + sine * sine / (self.stiffness * area)
    }

    fn profile(&self, along: f64) -> f64 {
        let (base, root) = (self.toothing.base_radius(), self.toothing.root_radius());
        let ring = self.toothing.is_internal();
        // Heights of a ring's teeth count inwards.
        let inwards = if ring { -1.0 } else { 1.0 };
        let (radius, angle) = (libm::hypot(base, along), libm::atan2(along, base));
        let half = self.half(angle);
        let load = angle - inwards * half;
        let (height, across) = (inwards * radius * libm::cos(half), radius * libm::sin(half));
        let slice = |y: f64, x: f64| self.slice([height, across], load, [y, x]);
        // Below the base circle flanks are radial.
        let mut sum = 0.0;
        if !ring && root < base {
            let tangent = libm::tan(self.base_angle);
            let ends = [root, base].map(|radius| radius * libm::cos(self.base_angle));
            sum += integral(ends, |y| slice(y, y * tangent));
        }
        let foot = if root > base { libm::acos(base / root) } else { 0.0 };
        sum += integral([foot, angle], |angle| {
            let (half, tangent) = (self.half(angle), libm::tan(angle));
            let radius = base / libm::cos(angle);
            let (sine, cosine) = (libm::sin(half), libm::cos(half));
            // d(r cos ϑ)/dα with dr/dα = r tan α and dϑ/dα = ∓ tan² α.
            let growth = radius * tangent * (cosine + inwards * sine * tangent);
            slice(inwards * radius * cosine, radius * sine) * (inwards * growth)
        });
        if ring { sum } else { sum + self.foundation(load, height, across) }
    }

    /// cos² α_F/(b E) (L (u/S)² + M u/S + P (1 + Q tan² α_F)).
    fn foundation(&self, load: f64, height: f64, across: f64) -> f64 {
        let root = self.toothing.root_radius();
        let Body { half, ratio } = Body::of(&self.toothing);
        let of = |[a, b, c, d, e, f]: [f64; 6]| {
            a / (half * half) + b * ratio * ratio + c * ratio / half + d / half + e * ratio + f
        };
        let l = of([-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045]);
        let m = of([60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086]);
        let p = of([-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236]);
        let q = of([-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904]);
        let tangent = libm::tan(load);
        let up = height - across * tangent - root * libm::cos(half);
        let part = up / (2.0 * root * half);
        let cosine = libm::cos(load);
        cosine * cosine / (self.width * self.material.young)
            * (l * part * part + m * part + p * (1.0 + q * tangent * tangent))
    }
}

/// Gauss and Legendre's rule with sixteen points, in two parts: towards the tip, where the tooth is thin, the integrand is steep. Of teeth of
/// involutes, pointed ones included, that is 3e-15 of what a rule of 640 points gives.
fn integral([from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    const RULE: [[f64; 2]; 8] = [
        [0.095_012_509_837_637_44, 0.189_450_610_455_068_5],
        [0.281_603_550_779_258_9, 0.182_603_415_044_923_58],
        [0.458_016_777_657_227_37, 0.169_156_519_395_002_54],
        [0.617_876_244_402_643_8, 0.149_595_988_816_576_74],
        [0.755_404_408_355_003, 0.124_628_971_255_533_88],
        [0.865_631_202_387_831_8, 0.095_158_511_682_492_79],
        [0.944_575_023_073_232_6, 0.062_253_523_938_647_894],
        [0.989_400_934_991_649_9, 0.027_152_459_411_754_096],
    ];
    let cut = from + 0.7 * (to - from);
    let parts = [[from, cut], [cut, to]];
    let points = parts.into_iter().flat_map(|[from, to]| {
        let (center, half) = (0.5 * (from + to), 0.5 * (to - from));
        RULE.into_iter().map(move |[at, weight]| (center, half * at, half * weight))
    });
    points.map(|(center, at, weight)| weight * (f(center - at) + f(center + at))).sum()
}

/// The stiffness of a pair of wheels at any place along the path of contact.
pub struct Stiffness {
    wheel: Flank,
    other: Flank,
    mesh: Mesh,
    /// a, and a sin α_w.
    distance: f64,
    tangent: f64,
    contact: f64,
    entry: f64,
}

impl Stiffness {
    /// Of two wheels, or of a wheel in a ring or on a rack, the wheel first.
    pub fn new(
        [wheel, other]: [Toothing; 2],
        mesh: Mesh,
        distance: f64,
        width: f64,
        material: Material,
    ) -> Self {
        let Material { young, poisson, tooth, .. } = material;
        let flank = |toothing: Toothing| {
            let half = toothing.half_tooth();
            let inv = involute(toothing.transverse_angle());
            let base_angle = if toothing.is_internal() { half - inv } else { half + inv };
            let thickness = match toothing.form.rim {
                Rim::Rack => 0.5 * PI * toothing.module,
                _ => 2.0 * toothing.pitch_radius() * half,
            };
            let is_wide = tooth == Tooth::Profile && width > 5.0 * thickness;
            let stiffness = if is_wide { young / (1.0 - poisson * poisson) } else { young };
            Flank { toothing, width, material, stiffness, base_angle }
        };
        let contact = match tooth {
            Tooth::Section => 0.0,
            Tooth::Profile => 4.0 * (1.0 - poisson * poisson) / (PI * young * width),
        };
        Stiffness {
            wheel: flank(wheel),
            other: flank(other),
            distance,
            tangent: distance * libm::sin(mesh.working_angle.unwrap_or(0.0)),
            contact,
            entry: material.entry,
            mesh,
        }
    }

    /// Of one pair of teeth that touch this far from the base tangent point of the wheel.
    pub fn of_one(&self, along: f64) -> f64 {
        let across = match self.other.toothing.form.rim {
            Rim::Internal => self.tangent + along,
            Rim::Rack => {
                let angle = self.mesh.working_angle.unwrap_or(0.0);
                self.distance
                    - self.wheel.toothing.base_radius() * libm::cos(angle)
                    - along * libm::sin(angle)
            }
            Rim::External | Rim::Bevel | Rim::Worm => self.tangent - along,
        };
        1.0 / (self.wheel.compliance(along) + self.other.compliance(across) + self.contact)
    }

    /// Of all pairs, τ pitches after one has begun to touch, in the middle of the face: slanted teeth are thin straight ones side by side, each a little later
    /// than the one before it, by ε_β over the face.
    pub fn at(&self, phase: f64) -> f64 {
        if self.mesh.overlap == 0.0 {
            return self.of_slice(phase);
        }
        let slices = (0..SLICES).map(|slice| (slice as f64 + 0.5) / SLICES as f64 - 0.5);
        slices.map(|at| self.of_slice(phase - at * self.mesh.overlap)).sum::<f64>() / SLICES as f64
    }

    /// Of straight teeth as wide as the face.
    fn of_slice(&self, phase: f64) -> f64 {
        let (begin, ratio) = (self.mesh.path[0], self.mesh.contact_ratio);
        let along = |at: f64| begin + at * self.mesh.base_pitch;
        touching(phase, ratio).map(|at| self.share(at, ratio) * self.of_one(along(at))).sum()
    }

    /// How many pairs touch then.
    pub fn pairs(&self, phase: f64) -> usize {
        touching(phase, self.mesh.contact_ratio).count()
    }

    /// How much of a pair is there: s² (3 − 2s) where it enters and leaves.
    fn share(&self, at: f64, ratio: f64) -> f64 {
        if self.entry == 0.0 {
            return 1.0;
        }
        let s = (at / self.entry).min((ratio - at) / self.entry).clamp(0.0, 1.0);
        s * s * (3.0 - 2.0 * s)
    }

    /// Its series over a pitch.
    pub fn series(&self, harmonics: usize) -> Series {
        let positions = POSITIONS as f64;
        let curve: Vec<f64> = (0..POSITIONS).map(|at| self.of_slice(at as f64 / positions)).collect();
        let mean = curve.iter().sum::<f64>() / positions;
        let turns: Vec<[f64; 2]> = (0..POSITIONS)
            .map(|at| TAU * at as f64 / positions)
            .map(|angle| [libm::cos(angle), libm::sin(angle)])
            .collect();
        let wave = |h: usize| {
            let sums = curve.iter().enumerate().fold([0.0; 2], |[a, b], (at, k)| {
                let [c, s] = turns[at * h % POSITIONS];
                [a + k * c, b + k * s]
            });
            sums.map(|sum| 2.0 * sum / positions)
        };
        // The mean of cos 2πh(τ − s) over the face is sin(πhε)/(πhε) cos 2πhτ.
        let averaged = |h: usize| {
            let angle = PI * h as f64 * self.mesh.overlap;
            let part = if angle == 0.0 { 1.0 } else { libm::sin(angle) / angle };
            wave(h).map(|wave| part * wave)
        };
        let waves: Vec<[f64; 2]> = (1..=harmonics).map(averaged).collect();
        let curve: Vec<f64> = match self.mesh.overlap {
            0.0 => curve,
            _ => (0..POSITIONS).map(|at| self.at(at as f64 / positions)).collect(),
        };
        let left = curve.iter().enumerate().map(|(at, k)| {
            let series = waves.iter().enumerate().map(|(h, [a, b])| {
                let [c, s] = turns[at * (h + 1) % POSITIONS];
                a * c + b * s
            });
            (k - mean - series.sum::<f64>()).powi(2)
        });
        let left_out = libm::sqrt(left.sum::<f64>() / positions) / mean;
        let [begin, end] = self.mesh.path;
        // Slanted teeth enter bit by bit.
        let step = if self.entry == 0.0 && self.mesh.overlap == 0.0 {
            self.of_one(begin).max(self.of_one(end)) / mean
        } else {
            0.0
        };
        Series { mean, waves, left_out, step }
    }
}

/// Where the pairs that touch are on their path, pitches.
fn touching(phase: f64, ratio: f64) -> impl Iterator<Item = f64> {
    let first = phase - libm::floor(phase);
    (0..).map(move |pair| first + f64::from(pair)).take_while(move |at| *at < ratio)
}

/// The phase of the wheel of a pair, pitches: where the leading flank of the tooth at the angle θ against the line of centres touches.
/// ξ = r_b tan α_w + r_b (θ − ψ) + r_b half, the half being that of a tooth at the working circle.
pub fn phase(wheel: &Toothing, mesh: &Mesh) -> f64 {
    let working = mesh.working_angle.unwrap_or(0.0);
    let half = wheel.half_tooth() + involute(wheel.transverse_angle()) - involute(working);
    let along = wheel.base_radius() * (libm::tan(working) + half);
    debug_assert!(half < FRAC_PI_2);
    (along - mesh.path[0]) / mesh.base_pitch
}
