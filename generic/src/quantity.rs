//! Scalars of positions between two bodies, with their analytic derivatives: what joints hold, loads act along and laws name.
//!
//! Each is f with ḟ = Σ (l·ṙ + n·ω) + drift and f̈ = Σ (l·r̈ + n·ω̇) + bias over its bodies. The pair (l, n) is at once a row of D
//! and the force and torque about the centre of mass that a unit effort along f exerts (virtual work).
//! Source: Haug (1989), ch. 3 (plane) and 9 (space); Nikravesh (1988), ch. 4 and 7.

use crate::kinematics::{Kinematics, Place, Point, Section};
use crate::number::Taylor;
use crate::vector::*;
use std::f64::consts::TAU;

#[derive(Clone, Debug)]
pub(crate) enum Quantity {
    /// e_k · p.
    Coordinate { place: Place, axis: usize },
    /// e_k · (p₁ − p₂).
    Gap { first: Place, second: Place, axis: usize },
    /// a · (p₂ − p₁), a fixed to the first body.
    Along { axis: V3, first: Place, second: Place },
    /// a · b, a fixed to the first body or section and b to the second.
    Dot { first: Section, a: V3, second: Section, b: V3 },
    /// θ₂ − θ₁ of planar bodies, or of sections of beams.
    PlaneAngle { first: Section, second: Section },
    /// Across of the directions A (1, σ) of two sections, the first turned on by an angle: (σ₂ − σ₁) cos δ + (1 + σ₁ σ₂) sin δ.
    Sections { first: Section, second: Section, angle: f64 },
    /// A mode of a beam.
    Mode { body: usize, mode: usize },
    /// From x₁ to x₂ about z₁, over several turns.
    Angle { first: Section, axes_1: M3, second: Section, axes_2: M3, counted: usize },
    /// The first or second angle of a universal joint.
    Universal { joint: Box<Universal>, which: usize, counted: usize },
    /// |p₂ − p₁|.
    Length { first: Place, second: Place },
}

/// A₂B₂ = A₁B₁ Rot(a, angle_1) Rot(s, angle_2); a and s in the axes of both places alike.
#[derive(Clone, Debug)]
pub(crate) struct Universal {
    pub first: Section,
    pub axes_1: M3,
    pub second: Section,
    pub axes_2: M3,
    pub a: V3,
    pub s: V3,
}

/// On one body: l along its velocity, n along its ω, world axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pull {
    pub body: Option<usize>,
    pub linear: V3,
    pub angular: V3,
    /// Where on the axis of a beam.
    pub on_axis: Option<f64>,
    /// Along the turn of the section there against its body, world axes.
    pub section: V3,
    /// Along a mode alone.
    pub mode: Option<(usize, f64)>,
}

impl Pull {
    /// On a body as a whole.
    pub fn on(body: Option<usize>, linear: V3, angular: V3) -> Self {
        Pull { body, linear, angular, on_axis: None, section: ZERO, mode: None }
    }

    pub fn scaled(self, factor: f64) -> Self {
        Pull {
            linear: times(factor, self.linear),
            angular: times(factor, self.angular),
            section: times(factor, self.section),
            mode: self.mode.map(|(mode, along)| (mode, factor * along)),
            ..self
        }
    }
}

/// f, ḟ, the bias of f̈, and the gradient on at most two bodies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub along: Taylor,
    pub pulls: [Pull; 2],
}

const NOTHING: Pull =
    Pull { body: None, linear: ZERO, angular: ZERO, on_axis: None, section: ZERO, mode: None };

/// d · p.
pub(crate) fn of_point(point: &Point, direction: V3) -> Pull {
    let pull = Pull::on(point.body, direction, cross(point.arm, direction));
    Pull { on_axis: point.on_axis, ..pull }
}

/// On a body and on the turn of a section of it.
fn of_spin(section: Section, direction: V3) -> Pull {
    Pull { on_axis: section.x, section: direction, ..Pull::on(section.body, ZERO, direction) }
}

/// The same about z.
fn of_section(section: Section, along: f64) -> Pull {
    of_spin(section, [0.0, 0.0, along])
}

impl Quantity {
    /// The bodies that it depends on.
    pub fn bodies(&self) -> [Option<usize>; 2] {
        match self {
            Quantity::Coordinate { place, .. } => [place.body, None],
            Quantity::Gap { first, second, .. }
            | Quantity::Along { first, second, .. }
            | Quantity::Length { first, second } => [first.body, second.body],
            Quantity::PlaneAngle { first, second } | Quantity::Sections { first, second, .. } => {
                [first.body, second.body]
            }
            Quantity::Mode { body, .. } => [Some(*body), None],
            Quantity::Dot { first, second, .. } | Quantity::Angle { first, second, .. } => {
                [first.body, second.body]
            }
            Quantity::Universal { joint, .. } => [joint.first.body, joint.second.body],
        }
    }

    pub fn jet(&self, at: &Kinematics) -> Jet {
        match self {
            Quantity::Coordinate { place, axis } => {
                let (p, k) = (at.point(place), *axis);
                Jet {
                    along: Taylor { value: p.position[k], rate: p.velocity[k], bias: p.bias[k] },
                    pulls: [of_point(&p, unit_axis(k)), NOTHING],
                }
            }
            Quantity::Gap { first, second, axis } => {
                let (p, q, k) = (at.point(first), at.point(second), *axis);
                Jet {
                    along: Taylor {
                        value: p.position[k] - q.position[k],
                        rate: p.velocity[k] - q.velocity[k],
                        bias: p.bias[k] - q.bias[k],
                    },
                    pulls: [of_point(&p, unit_axis(k)), of_point(&q, times(-1.0, unit_axis(k)))],
                }
            }
            Quantity::Along { axis, first, second } => along(at, *axis, first, second),
            Quantity::Dot { first, a, second, b } => dot_product(at, (*first, *a), (*second, *b)),
            Quantity::PlaneAngle { first, second } => {
                let (one, other) = (at.frame(first.body), at.frame(second.body));
                let [back, ahead] = [at.slope(*first), at.slope(*second)];
                Jet {
                    along: Taylor {
                        value: other.angle - one.angle + ahead[0] - back[0],
                        rate: other.spin[2] - one.spin[2] + ahead[1] - back[1],
                        bias: 0.0,
                    },
                    pulls: [of_section(*first, -1.0), of_section(*second, 1.0)],
                }
            }
            Quantity::Sections { first, second, angle } => sections(at, *first, *second, *angle),
            Quantity::Mode { body, mode } => {
                let [value, rate] = at.modal[at.frames[*body].modes + mode];
                let pull = Pull { mode: Some((*mode, 1.0)), ..Pull::on(Some(*body), ZERO, ZERO) };
                Jet { along: Taylor { value, rate, bias: 0.0 }, pulls: [pull, NOTHING] }
            }
            Quantity::Angle { first, axes_1, second, axes_2, counted } => {
                let (one, other) = (at.turned(*first), at.turned(*second));
                let (e1, e2) = (product(&one.axes, axes_1), product(&other.axes, axes_2));
                let [x1, y1, z1] = [0, 1, 2].map(|k| column(&e1, k));
                let (x2, z2) = (column(&e2, 0), column(&e2, 2));
                // Each body's rate about its own axis: constant in its axes, so that of f̈ there is left what sections do by themselves.
                Jet {
                    along: Taylor {
                        value: nearest(dot(y1, x2).atan2(dot(x1, x2)), at.counted[*counted]),
                        rate: dot(z2, other.spin) - dot(z1, one.spin),
                        bias: dot(z2, other.faster) - dot(z1, one.faster),
                    },
                    pulls: [of_spin(*first, times(-1.0, z1)), of_spin(*second, z2)],
                }
            }
            Quantity::Universal { joint, which, counted } => joint.jet(at, *which, at.counted[*counted]),
            Quantity::Length { first, second } => length(&at.point(first), &at.point(second)),
        }
    }
}

/// f = a·Δ: ḟ = (ω₁ × a)·Δ + a·Δ̇, f̈ = (ω₁ × (ω₁ × a))·Δ + 2 (ω₁ × a)·Δ̇ + a·Δ̈ + (α₁ × a)·Δ.
fn along(at: &Kinematics, axis: V3, from: &Place, to: &Place) -> Jet {
    let (first, second) = (&at.point(from), &at.point(to));
    let frame = at.turned(at.section(from));
    let a = turned(&frame.axes, axis);
    let (delta, delta_rate) =
        (minus(second.position, first.position), minus(second.velocity, first.velocity));
    let a_rate = cross(frame.spin, a);
    let back = of_point(first, times(-1.0, a));
    Jet {
        along: Taylor {
            value: dot(a, delta),
            rate: dot(a_rate, delta) + dot(a, delta_rate),
            bias: dot(plus(cross(frame.faster, a), cross(frame.spin, a_rate)), delta)
                + 2.0 * dot(a_rate, delta_rate)
                + dot(a, minus(second.bias, first.bias)),
        },
        pulls: [
            Pull { angular: plus(back.angular, cross(a, delta)), section: cross(a, delta), ..back },
            of_point(second, a),
        ],
    }
}

/// f = a·b: ḟ = (ω₁ − ω₂)·(a × b), f̈ = (ω₁ × (ω₁ × a))·b + 2 (ω₁ × a)·(ω₂ × b) + a·(ω₂ × (ω₂ × b)) + (α₁ − α₂)·(a × b).
fn dot_product(at: &Kinematics, first: (Section, V3), second: (Section, V3)) -> Jet {
    let (one, other) = (at.turned(first.0), at.turned(second.0));
    let (a, b) = (turned(&one.axes, first.1), turned(&other.axes, second.1));
    let (a_rate, b_rate) = (cross(one.spin, a), cross(other.spin, b));
    let normal = cross(a, b);
    Jet {
        along: Taylor {
            value: dot(a, b),
            rate: dot(a_rate, b) + dot(a, b_rate),
            bias: dot(cross(one.spin, a_rate), b)
                + 2.0 * dot(a_rate, b_rate)
                + dot(a, cross(other.spin, b_rate))
                + dot(minus(one.faster, other.faster), normal),
        },
        pulls: [of_spin(first.0, normal), of_spin(second.0, times(-1.0, normal))],
    }
}

/// With δ = θ₂ − θ₁ − angle, across σ₂ − σ₁ and level 1 + σ₁ σ₂: all of it moves, so that the second derivative at v̇ = 0 is
/// (level¨) sin δ + 2 (across˙ (−sin δ) + level˙ cos δ) δ˙ − (across cos δ + level sin δ) δ˙².
fn sections(at: &Kinematics, first: Section, second: Section, angle: f64) -> Jet {
    let (one, other) = (at.frame(first.body), at.frame(second.body));
    let ([s1, r1], [s2, r2]) = (at.slope(first), at.slope(second));
    let (sin, cos) = (other.angle - one.angle - angle).sin_cos();
    let turning = other.spin[2] - one.spin[2];
    let (across, level) = (s2 - s1, 1.0 + s1 * s2);
    let (across_rate, level_rate, level_bias) = (r2 - r1, r1 * s2 + s1 * r2, 2.0 * r1 * r2);
    let value = across * cos + level * sin;
    let by_turn = level * cos - across * sin;
    let rate = across_rate * cos + level_rate * sin + by_turn * turning;
    let bias =
        level_bias * sin + 2.0 * (level_rate * cos - across_rate * sin) * turning - value * turning * turning;
    let pull = |section: Section, turn: f64, slope: f64| Pull {
        section: [0.0, 0.0, slope],
        ..of_section(section, turn)
    };
    let pulls = [pull(first, -by_turn, s2 * sin - cos), pull(second, by_turn, cos + s1 * sin)];
    Jet { along: Taylor { value, rate, bias }, pulls }
}

/// l = |Δ|: l̇ = e·Δ̇, l̈ = e·Δ̈ + (Δ̇² − l̇²)/l with e = Δ/l.
fn length(first: &Point, second: &Point) -> Jet {
    let (delta, delta_rate) =
        (minus(second.position, first.position), minus(second.velocity, first.velocity));
    let length = norm(delta);
    let e = times(1.0 / length, delta);
    let rate = dot(e, delta_rate);
    Jet {
        along: Taylor {
            value: length,
            rate,
            bias: dot(e, minus(second.bias, first.bias))
                + (dot(delta_rate, delta_rate) - rate * rate) / length,
        },
        pulls: [of_point(first, times(-1.0, e)), of_point(second, e)],
    }
}

/// f = (Δ·Δ)/2, of which a distance is made: ḟ = Δ·Δ̇, f̈ = Δ̇·Δ̇ + Δ·Δ̈.
pub(crate) fn half_square(at: &Kinematics, first: &Place, second: &Place) -> Jet {
    let (p, q) = (at.point(first), at.point(second));
    let (delta, delta_rate) = (minus(q.position, p.position), minus(q.velocity, p.velocity));
    Jet {
        along: Taylor {
            value: 0.5 * dot(delta, delta),
            rate: dot(delta, delta_rate),
            bias: dot(delta_rate, delta_rate) + dot(delta, minus(q.bias, p.bias)),
        },
        pulls: [of_point(&p, times(-1.0, delta)), of_point(&q, delta)],
    }
}

impl Universal {
    /// s has turned about a by angle_1 as seen from the first, a about s by −angle_2 as seen from the second; the rates are those of
    /// ω₂ − ω₁ along a, fixed to the first, and along s, fixed to the second.
    fn jet(&self, at: &Kinematics, which: usize, counted: f64) -> Jet {
        let (one, other) = (at.turned(self.first), at.turned(self.second));
        let (e1, e2) = (product(&one.axes, &self.axes_1), product(&other.axes, &self.axes_2));
        let relative = minus(other.spin, one.spin);
        let (angle, axis, axis_rate) = if which == 0 {
            let seen = turned_back(&e1, turned(&e2, self.s));
            let axis = turned(&e1, self.a);
            (angle_about(self.a, self.s, seen), axis, cross(one.spin, axis))
        } else {
            let seen = turned_back(&e2, turned(&e1, self.a));
            let axis = turned(&e2, self.s);
            (-angle_about(self.s, self.a, seen), axis, cross(other.spin, axis))
        };
        Jet {
            along: Taylor {
                value: nearest(angle, counted),
                rate: dot(axis, relative),
                bias: dot(axis_rate, relative) + dot(axis, minus(other.faster, one.faster)),
            },
            pulls: [of_spin(self.first, times(-1.0, axis)), of_spin(self.second, axis)],
        }
    }
}

fn angle_about(axis: V3, start: V3, end: V3) -> f64 {
    dot(axis, cross(start, end)).atan2(dot(start, end) - dot(axis, start) * dot(axis, end))
}

/// The angle with the whole turns that bring it nearest to another.
pub(crate) fn nearest(angle: f64, to: f64) -> f64 {
    angle + TAU * ((to - angle) / TAU).round()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::Frame;

    /// Two bodies that move with constant velocities and constant ω in their own axes.
    fn at(time: f64) -> Kinematics {
        let frame = |position: V3, turn: V3, velocity: V3, omega: V3| {
            let start = rotation(quaternion_of_turn(turn));
            let axes = product(&start, &rotation(quaternion_of_turn(times(time, omega))));
            Frame {
                position: plus(position, times(time, velocity)),
                axes,
                velocity,
                spin: turned(&axes, omega),
                angle: time * omega[2],
                modes: 0,
            }
        };
        let frames = vec![
            frame([0.1, -0.4, 0.3], [0.3, 0.5, -0.2], [0.7, 0.2, -0.5], [1.1, -0.6, 0.4]),
            frame([1.2, 0.3, -0.2], [-0.4, 0.1, 0.6], [-0.3, 0.9, 0.4], [-0.5, 0.8, 1.3]),
        ];
        Kinematics { time, frames, counted: vec![0.0; 2], ..Kinematics::default() }
    }

    fn place(body: usize, local: V3) -> Place {
        Place { body: Some(body), local, axes: IDENTITY, moving: None, of_mean: false }
    }

    /// ḟ is that of the gradient and of differences, f̈ that of differences.
    fn is_differentiated(jet: impl Fn(&Kinematics) -> Jet) {
        const H: f64 = 1e-4;
        let now = jet(&at(0.0));
        let [before, behind] = [-H, H].map(|time| jet(&at(time)).along.value);
        let (rate, bias) =
            ((behind - before) / (2.0 * H), (behind - 2.0 * now.along.value + before) / (H * H));
        assert!((now.along.rate - rate).abs() < 1e-7, "{now:?} {rate}");
        assert!((now.along.bias - bias).abs() < 1e-6, "{now:?} {bias}");
        let frames = at(0.0);
        let along = |pull: Pull| {
            let frame = frames.frame(pull.body);
            dot(pull.linear, frame.velocity) + dot(pull.angular, frame.spin)
        };
        let total: f64 = now.pulls.into_iter().map(along).sum();
        assert!((total - now.along.rate).abs() < 1e-14, "{now:?} {total}");
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let (first, second) = (place(0, [0.2, 0.1, -0.3]), place(1, [-0.1, 0.4, 0.2]));
        let (a, b) = ([0.6, 0.0, 0.8], [0.0, -0.6, 0.8]);
        let quantities = [
            Quantity::Coordinate { place: first.clone(), axis: 1 },
            Quantity::Gap { first: first.clone(), second: second.clone(), axis: 2 },
            Quantity::Along { axis: a, first: first.clone(), second: second.clone() },
            Quantity::Dot { first: Section::whole(Some(0)), a, second: Section::whole(Some(1)), b },
            Quantity::Length { first: first.clone(), second: second.clone() },
        ];
        for quantity in &quantities {
            is_differentiated(|at| quantity.jet(at));
        }
        is_differentiated(|at| half_square(at, &first, &second));
    }
}
