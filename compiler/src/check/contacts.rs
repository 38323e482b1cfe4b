//! Contacts at the start: none is closed there, each can be opened and closed, and how long a blow takes.

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use super::mobility::{Direction, Mobility};
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::{Equations, Jet, Laws};
use crate::model::{Expr, Load, LoadId, Mechanism, Subject};
use crate::numbers::significant;
use std::f64::consts::PI;
use std::fmt;

/// Within a touch.
const STEPS: f64 = 20.0;
/// Of a length of the mechanism, what is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// What a blow is like at the start, with nothing but the contact acting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blow {
    /// m_e = 1/(J A Jᵀ) with A the inverse of M on the velocities that constraints admit, kg or kg m².
    pub mass: f64,
    /// From touch to parting of the law without its losses, s.
    pub time: f64,
    /// Whether it is about an angle.
    pub turns: bool,
    /// That of the impact, where the time depends on it, m/s or rad/s.
    pub speed: Option<f64>,
}

impl fmt::Display for Blow {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let unit = if self.turns { "kg m²" } else { "kg" };
        write!(
            f,
            "stops {} {unit}; a touch takes {} s",
            significant(self.mass, 4),
            significant(self.time, 3)
        )?;
        if let Some(speed) = self.speed {
            let unit = if self.turns { "rad/s" } else { "m/s" };
            write!(f, " at {} {unit}", significant(speed, 4))?;
        }
        write!(f, ", so steps of {} s or less", significant(self.time / STEPS, 2))
    }
}

/// Errors of contacts that are closed at the start, warnings of those that never change.
pub fn contacts(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
    warnings: &mut Diagnostics,
) {
    let gaps = gaps(mechanism, equations);
    if gaps.is_empty() {
        return;
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    point.evaluate(&Ancestry::of_jets(equations, gaps.iter().map(|(_, jet)| jet)));
    // Friction of a contact itself that is not dry.
    let smooth = |contact: &Load| {
        let on = |load: &Load| {
            load.contact().is_some_and(|at| mechanism.loads[at.0].name.text == contact.name.text)
        };
        mechanism.loads.iter().find(|load| load.form.rubs && !load.form.holds && on(load))
    };
    let mut said: Option<&str> = None;
    for (load, jet) in &gaps {
        let (name, at) = (load.name.text.as_str(), load.name.span);
        if said == Some(name) {
            continue;
        }
        if let (false, Some(Load { name: friction, .. })) = (load.restitutions.is_empty(), smooth(load)) {
            said = Some(name);
            errors.error(friction.span, messages::rigid_with_friction(&friction.text, name));
            continue;
        }
        if jet.columns.is_empty() && equations.graph.sheet().is_zero(jet.drift) {
            said = Some(name);
            if !mechanism.allowed.covers(Lint::NoEffect, at) {
                warnings.warning(Lint::NoEffect, at, messages::gap_never_changes(name));
            }
            continue;
        }
        let gap = point.get(jet.value);
        let moved = jet.columns.iter().map(|(column, node)| point.get(*node) * assembly.v[*column]);
        let rate = point.get(jet.drift) + moved.sum::<f64>();
        if !load.restitutions.is_empty() {
            if gap < -ROUNDING {
                said = Some(name);
                errors.error(at, messages::rigid_inside(name, -gap, is_angle(load)));
            } else if gap < ROUNDING && rate < -ROUNDING {
                said = Some(name);
                errors.error(at, messages::rigid_closing(name, -rate, is_angle(load)));
            }
            continue;
        }
        if keeps_speed(mechanism, load) && gap < ROUNDING && rate < -ROUNDING {
            said = Some(name);
            errors.error(at, messages::starts_in_a_touch(name, -rate, is_angle(load)));
            continue;
        }
        if gap < -ROUNDING && !mechanism.allowed.covers(Lint::Penetration, at) {
            said = Some(name);
            errors.error(at, messages::penetration(name, -gap, is_angle(load)));
        }
    }
}

/// Whether its law is told the speed of each touch.
fn keeps_speed(mechanism: &Mechanism, load: &Load) -> bool {
    let of = |id: LoadId| mechanism.loads.get(id.0).is_some_and(|it| it.name.text == load.name.text);
    mechanism.memories.iter().filter_map(|memory| memory.touch_of).any(of)
}

/// The blow of each contact with a named law, at the start; an error where one is shorter than is expected.
pub fn contact_times(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Vec<(LoadId, Blow)> {
    let found = blows(mechanism, equations, assembly);
    for expected in &mechanism.expect.contact_times {
        let blow = found.iter().find(|(id, _)| *id == expected.load).map(|(_, blow)| *blow);
        let name = &mechanism.loads[expected.load.0].name.text;
        match blow {
            None => {
                let is_known = elastic(mechanism, &mechanism.loads[expected.load.0]).is_some();
                errors.error(expected.span, messages::no_contact_time(name, is_known));
            }
            Some(blow) if blow.time < expected.least => {
                errors.error(
                    expected.span,
                    messages::contact_too_short(name, blow.time, expected.least, blow.mass),
                );
            }
            Some(_) => {}
        }
    }
    found
}

fn blows(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly) -> Vec<(LoadId, Blow)> {
    let gaps = gaps(mechanism, equations);
    let mut found: Vec<(LoadId, Blow)> = Vec::new();
    if gaps.is_empty() {
        return found;
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    point.evaluate(&Ancestry::of_jets(equations, gaps.iter().map(|(_, jet)| jet)));
    let direction = |(_, jet): &(&Load, Jet)| -> Direction {
        jet.columns.iter().map(|(index, column)| (*index, point.get(*column))).collect()
    };
    let directions: Vec<Direction> = gaps.iter().map(direction).collect();
    let mobility = Mobility::at(&mut point);
    for ((load, _), direction) in gaps.iter().zip(&directions) {
        let Some(id) = mechanism.loads.iter().position(|it| it.name.text == load.name.text).map(LoadId)
        else {
            continue;
        };
        if found.last().is_some_and(|(last, _)| *last == id) {
            continue;
        }
        let Some((stiffness, exponent, speed)) = elastic(mechanism, load) else { continue };
        if let Some(mobility) = mobility.along(direction) {
            let mass = 1.0 / mobility;
            let time = contact_time(mass, stiffness, exponent, speed);
            let speed = (exponent != 1.0).then_some(speed);
            found.push((id, Blow { mass, time, turns: is_angle(load), speed }));
        }
    }
    found
}

/// From touch to parting of m ẍ = −K dⁿ at speed v: the deepest is d_m = ((n + 1) m v²/(2K))^(1/(n+1)), and both ways take
/// 2 (d_m/v) ∫₀¹ dx/√(1 − xⁿ⁺¹) = 2 (d_m/v) √π Γ(1 + 1/(n+1))/Γ(½ + 1/(n+1)) (Johnson, Contact Mechanics, 1985, 11.4 for n = 3/2).
fn contact_time(mass: f64, stiffness: f64, exponent: f64, speed: f64) -> f64 {
    let power = exponent + 1.0;
    let deepest = libm::pow(power * mass * speed * speed / (2.0 * stiffness), 1.0 / power);
    let share = libm::sqrt(PI) * libm::tgamma(1.0 + 1.0 / power) / libm::tgamma(0.5 + 1.0 / power);
    2.0 * deepest / speed * share
}

/// K, n and v of a named law, if its stiffness acts at the defaults; without a speed of its own, of 1 m/s.
fn elastic(mechanism: &Mechanism, load: &Load) -> Option<(f64, f64, f64)> {
    let [stiffness, exponent, speed] = &load.values[..] else { return None };
    let defaults = mechanism.defaults();
    let at = |value: &[Expr]| crate::model::value_at(value.first()?, &defaults);
    let (stiffness, exponent, speed) = (at(stiffness)?, at(exponent)?, at(speed)?);
    (stiffness > 0.0).then_some((stiffness, exponent, speed))
}

/// Each gap of each contact.
pub fn gaps<'m>(mechanism: &'m Mechanism, equations: &Equations) -> Vec<(&'m Load, Jet)> {
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    let contacts = mechanism.loads.iter().filter(|load| load.is_contact());
    let gaps = contacts.flat_map(|load| load.along().map(move |gap| (load, gap)));
    gaps.map(|(load, gap)| (load, laws.jet(gap).jet)).collect()
}

pub fn is_angle(load: &Load) -> bool {
    matches!(load.on.first(), Some(Subject::Expression(_, way)) if way.fits(crate::units::Dimension::ANGLE))
}
