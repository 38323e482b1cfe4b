//! Pairs of racks, cones and worms, whose factors follow from velocities where their pitch surfaces touch; and that place, where their teeth press.

use super::gears::{Body, Kind, Pair, Toothing, Turning, wrapped};
use super::{Read, Reader};
use crate::mesh::Touch;
use crate::vector::*;
use std::collections::BTreeMap;
use std::f64::consts::PI;

impl Reader<'_> {
    /// A pinion on a rack: the pitch circle rolls on the line, ω × r = v along it.
    pub(super) fn rolling(&self, wheels: [Toothing; 2], which: usize, own: &str) -> Read<Option<Pair>> {
        let (rack, pinion) = (&wheels[which], &wheels[1 - which]);
        let lines = self.fixed_to(rack, own)?;
        for (carrier, center) in self.pinned(&pinion.center) {
            for (index, joint) in self.joints.iter().enumerate() {
                let ends = [joint.first.body, joint.second.body];
                if joint.kind != "prismatic" || carrier == Some(pinion.body) || !ends.contains(&carrier) {
                    continue;
                }
                let body = if ends[0] == carrier { ends[1] } else { ends[0] };
                let Some((_, at, along)) = lines.iter().find(|(known, ..)| *known == body) else { continue };
                let turn = self.axes_in(body, carrier, own)?;
                let axis = column(&joint.frame, if self.spatial { 2 } else { 0 });
                // Of two ends the carrier is the one whose place and axes count.
                let (base, far, moves) = if ends[0] == carrier {
                    (joint.first.local, joint.second.local, axis)
                } else {
                    (joint.second.local, joint.first.local, turned(&turn, times(-1.0, axis)))
                };
                let start = plus(base, turned(&turn, minus(*at, far)));
                let along = turned(&turn, *along);
                let mut still = 0.0;
                let (terms, about) = if self.spatial {
                    let Some((terms, Some(about))) = self.turn(Some(pinion.body), carrier) else {
                        return Ok(None);
                    };
                    (terms.into_iter().map(|(joint, sign)| (sign, Turning::Joint(joint))).collect(), about)
                } else {
                    let mut terms = Vec::new();
                    for (sign, body) in [(1.0, Some(pinion.body)), (-1.0, carrier)] {
                        match (body, self.orientation(body, own)?) {
                            (Some(body), (Some(_), _)) => terms.push((sign, Turning::Body(body))),
                            (_, (_, angle)) => still += sign * angle,
                        }
                    }
                    (terms, unit_axis(2))
                };
                let way = minus(start, center);
                let towards = minus(minus(way, times(dot(way, along), along)), times(dot(way, about), about));
                let Some(towards) = unit(towards) else { return Ok(None) };
                let rolls = dot(cross(about, times(pinion.pitch(), towards)), along);
                let mut all: Vec<(f64, Turning)> =
                    terms.iter().map(|(sign, what)| (sign * pinion.teeth, *what)).collect();
                all.push((-dot(moves, along) * pinion.teeth / rolls, Turning::Travel(index)));
                // A tooth of the rack stands in the middle of the first point of its line.
                let psi = self.angle_about(about, towards);
                let beyond = pinion.teeth / rolls * dot(way, along);
                let constant = PI + pinion.teeth * (psi - pinion.first - still) + beyond;
                let order = if which == 0 { -1.0 } else { 1.0 };
                let (sine, cosine) = pinion.transverse().sin_cos();
                let touch = Touch {
                    carrier,
                    from: 1 - which,
                    at: times(pinion.pitch(), towards),
                    push: times(order * cosine, cross(about, towards)),
                    part: times(order * sine, towards),
                };
                let full = minus(minus(way, times(dot(way, along), along)), times(dot(way, about), about));
                return Ok(Some(Pair {
                    terms: all,
                    constant: wrapped(constant),
                    distance: norm(full),
                    direction: psi,
                    carrier,
                    counted: 1 - which,
                    turns: terms,
                    still,
                    first: pinion.first,
                    side: 1.0,
                    radius: pinion.base() / pinion.teeth,
                    touch: Some(touch),
                    follows: false,
                    wheels,
                }));
            }
        }
        Ok(None)
    }

    /// The line of a rack in everything that its body is fixed to.
    pub(super) fn fixed_to(&self, rack: &Toothing, own: &str) -> Read<Vec<(Body, V3, V3)>> {
        let mut found = vec![(Some(rack.body), rack.center.local, rack.along)];
        let mut next = 0;
        while let Some((body, at, along)) = found.get(next).copied() {
            next += 1;
            for joint in self.joints.iter().filter(|joint| joint.kind == "fixed") {
                for (near, far) in [(&joint.first, &joint.second), (&joint.second, &joint.first)] {
                    if near.body == body && found.iter().all(|(known, ..)| *known != far.body) {
                        let turn = self.axes_in(body, far.body, own)?;
                        let there = plus(far.local, turned(&turn, minus(at, near.local)));
                        found.push((far.body, there, turned(&turn, along)));
                    }
                }
            }
        }
        Ok(found)
    }

    /// The axes of a body in those of another that keeps its orientation against it.
    fn axes_in(&self, body: Body, other: Body, own: &str) -> Read<M3> {
        if self.spatial {
            return Ok(IDENTITY);
        }
        let angle = self.orientation(body, own)?.1 - self.orientation(other, own)?.1;
        let (sine, cosine) = angle.sin_cos();
        Ok(from_columns([cosine, sine, 0.0], [-sine, cosine, 0.0], unit_axis(2)))
    }

    /// Bevel gears and worms: at the point that touches both velocities have the same part along the normal of the flanks.
    pub(super) fn crossing(&self, wheels: [Toothing; 2]) -> Option<Pair> {
        let (carrier, across) = self.carrier(&wheels)?;
        let turns = [self.turn(Some(wheels[0].body), carrier)?, self.turn(Some(wheels[1].body), carrier)?];
        let axes = [turns[0].1?, turns[1].1?];
        let square = cross(axes[0], axes[1]);
        let worm = wheels.iter().position(|wheel| wheel.kind == Kind::Worm);
        let (touch, flank, apart, angle, beyond, toward) =
            match wheels.iter().position(|wheel| wheel.kind == Kind::Worm) {
                Some(worm) => {
                    let normal = unit(times(dot(square, across).signum(), square))?;
                    let (screw, driven) = (&wheels[worm], &wheels[1 - worm]);
                    let of = |wheel: &Toothing| match wheel.kind {
                        // On the pitch circle of the wheel, whatever its shift.
                        Kind::Worm => dot(normal, across).abs() - driven.pitch(),
                        _ => wheel.pitch(),
                    };
                    let mut touch = [times(of(&wheels[0]), normal), times(-of(&wheels[1]), normal)];
                    let slope = driven.helix.signum() * screw.teeth * screw.module / (2.0 * of(screw));
                    let around = cross(axes[worm], unit(touch[worm])?);
                    let lead = slope.abs().atan();
                    let angle = (driven.transverse().tan() * lead.cos()).atan();
                    let on_worm = if worm == 0 { dot(across, axes[worm]) } else { -dot(across, axes[worm]) };
                    // In the middle plane of the wheel.
                    touch[worm] = plus(touch[worm], times(on_worm, axes[worm]));
                    let beyond = -2.0 * on_worm / screw.module;
                    // Along a thread, then across it in the plane that touches both pitch cylinders.
                    let flank = unit(cross(plus(around, times(slope, axes[worm])), normal))?;
                    (touch, flank, normal, angle, beyond, [normal, times(-1.0, normal)])
                }
                None => {
                    let apex = times(dot(cross(across, axes[1]), square) / dot(square, square), axes[0]);
                    let out = [unit(times(-1.0, apex))?, unit(minus(across, apex))?];
                    let toward = unit(minus(out[1], times(dot(out[0], out[1]), out[0])))?;
                    let (sine, cosine) = wheels[0].cone.sin_cos();
                    let line = plus(times(cosine, out[0]), times(sine, toward));
                    let long = wheels[0].pitch() / sine;
                    let face = wheels.iter().filter_map(|wheel| wheel.width).fold(f64::INFINITY, f64::min);
                    let long = if face.is_finite() { long - 0.5 * face } else { long };
                    let point = plus(apex, times(long, line));
                    let flank = unit(square)?;
                    let apart = cross(line, flank);
                    let apart = times(dot(apart, toward).signum(), apart);
                    ([point, minus(point, across)], flank, apart, wheels[0].angle, 0.0, [out[1], out[0]])
                }
            };
        let speeds = [0, 1].map(|k| dot(cross(axes[k], touch[k]), flank));
        let factors = [wheels[0].teeth, -wheels[0].teeth * speeds[1] / speeds[0]];
        let terms =
            turns.clone().into_iter().zip(factors).flat_map(|((own, _), factor)| {
                own.into_iter().map(move |(joint, sign)| (factor * sign, joint))
            });
        let mut found: BTreeMap<usize, f64> = BTreeMap::new();
        terms.for_each(|(factor, joint)| *found.entry(joint).or_default() += factor);
        let psi = [0, 1].map(|k| self.angle_about(axes[k], toward[k]));
        // The constant of a worm counts along its own factor, which is that of the first.
        let order = match worm {
            Some(0) => wheels[1].helix.signum(),
            Some(_) => (factors[1] * wheels[0].helix.signum()).signum(),
            None => 1.0,
        };
        let constant =
            order * (PI + beyond) + (0..2).map(|k| factors[k] * (psi[k] - wheels[k].first)).sum::<f64>();
        let counted = usize::from(worm == Some(0));
        let turns = turns[counted].0.iter().map(|(joint, sign)| (*sign, Turning::Joint(*joint))).collect();
        let touch = Touch {
            carrier,
            from: counted,
            at: touch[counted],
            push: times(angle.cos() * speeds[0].signum(), flank),
            part: times(angle.sin(), apart),
        };
        Some(Pair {
            terms: found.into_iter().map(|(joint, factor)| (factor, Turning::Joint(joint))).collect(),
            constant: wrapped(constant),
            distance: norm(across),
            direction: psi[counted],
            carrier,
            counted,
            turns,
            still: 0.0,
            first: wheels[counted].first,
            side: factors[counted].signum(),
            radius: angle.cos() * speeds[0].abs() / wheels[0].teeth,
            touch: Some(touch),
            follows: false,
            wheels,
        })
    }

    /// The angle of a direction about an axle, from x of J of the axle; in the plane of itself.
    fn angle_about(&self, axle: V3, direction: V3) -> f64 {
        let joint = self.joints.iter().find(|joint| dot(column(&joint.frame, 2), axle) > 1.0 - 1e-12);
        match joint {
            Some(joint) if self.spatial => {
                dot(column(&joint.frame, 1), direction).atan2(dot(column(&joint.frame, 0), direction))
            }
            _ => direction[1].atan2(direction[0]),
        }
    }
}

/// Of cylinders in space: where their pitch circles touch, between the middles of both.
pub(super) fn beside(wheels: &[Toothing; 2], sense: f64, carrier: Body, axle: V3, across: V3) -> Touch {
    let [first, second] = wheels;
    let along = dot(axle, across);
    let between = minus(across, times(along, axle));
    let distance = norm(between);
    let apart = times(1.0 / distance, between);
    let working = ((second.base() + sense * first.base()).abs() / distance).acos();
    let (sine, cosine) = working.sin_cos();
    let out = if second.internal { -1.0 } else { 1.0 };
    let push = plus(
        times(out * cosine, cross(axle, apart)),
        times(-first.helix.tan() * first.transverse().cos(), axle),
    );
    let at = plus(times(out * first.base() / cosine, apart), times(0.5 * along, axle));
    Touch { carrier, from: 0, at, push, part: times(sense * sine, apart) }
}
