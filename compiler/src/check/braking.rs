//! Smooth friction near rest: a damper of the size μ N/v_s, and how long what it brakes takes to come to rest there.
//!
//! ```text
//! t = v_s/((μ N r + o) J A Jᵀ)    of each coordinate that slides, the shortest; J A Jᵀ is one by the mass that is braked
//! ```
//! with N at the start, r the radius of what turns, else 1, and o what does not depend on load (N or N m). Explicit methods of fourth order need steps below
//! 2.78 t (Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, IV.2).

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use super::mobility::{Direction, Mobility};
use crate::diagnostics::Diagnostics;
use crate::equations::{Braked, Equations, Laws, braked};
use crate::model::{Load, LoadId, Mechanism, value_at};
use crate::numbers::significant;
use crate::solve::Solved;
use std::fmt;

/// Where RK4 is stable on the negative real axis.
const STABLE: f64 = 2.78;

/// What a friction is like near rest, at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Braking {
    /// t, s.
    pub time: f64,
    /// N.
    pub pressed: f64,
}

impl fmt::Display for Braking {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [pressed, time, most] =
            [self.pressed, self.time, STABLE * self.time].map(|it| significant(it, 3));
        write!(
            f,
            "pressed by {pressed} N at the start; near rest it brakes within {time} s, so steps below {most} s"
        )
    }
}

/// That of each friction whose law is smooth; an error where one is quicker than is expected.
pub fn braking(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Vec<(LoadId, Braking)> {
    let found = all(mechanism, equations, solved, assembly);
    for expected in &mechanism.expect.friction_times {
        let name = &mechanism.loads[expected.load.0].name.text;
        match found.iter().find(|(id, _)| *id == expected.load).map(|(_, braking)| *braking) {
            None => errors.error(expected.span, messages::no_friction_time(name)),
            Some(Braking { time, pressed }) if time < expected.least => {
                errors.error(expected.span, messages::friction_too_quick(name, time, expected.least, pressed))
            }
            Some(_) => {}
        }
    }
    found
}

fn all(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
) -> Vec<(LoadId, Braking)> {
    let smooth: Vec<(usize, &Load, [f64; 3])> = mechanism
        .loads
        .iter()
        .enumerate()
        .filter_map(|(index, load)| Some((index, load, slope(mechanism, load)?)))
        .collect();
    if smooth.is_empty() {
        return Vec::new();
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    // Where N follows from reactions, it is a symbol.
    let starts: Vec<_> = solved.index1.left.iter().map(|[start, ..]| *start).collect();
    point.evaluate(&Ancestry::of(equations, starts.iter().copied()));
    let normals: Vec<f64> = starts.iter().map(|start| point.get(*start)).collect();
    point.set(&equations.symbols.normals, &normals);
    let (g, symbols) = (equations.graph.sheet(), &equations.symbols);
    let laws = Laws::moving(g, mechanism, symbols, &equations.layout, &equations.kinematics);
    let slides: Vec<Vec<Braked>> = smooth.iter().map(|(_, load, _)| braked(&laws, load)).collect();
    let mobility = Mobility::at(&mut point);
    let mut found = Vec::new();
    for ((index, _, [coefficient, own, speed]), slides) in smooth.into_iter().zip(slides) {
        let mut quickest: Option<Braking> = None;
        for Braked { along, levers, arm, pressed } in slides {
            let nodes = along.iter().flat_map(|jet| jet.columns.values().copied());
            point.evaluate(&Ancestry::of(
                equations,
                nodes.chain(levers.iter().copied()).chain([arm, pressed]),
            ));
            let [arm, pressed] = [arm, pressed].map(|node| point.get(node));
            let size = coefficient * pressed * arm + own;
            for (jet, lever) in along.iter().zip(&levers) {
                let lever = point.get(*lever);
                let direction: Direction =
                    jet.columns.iter().map(|(column, node)| (*column, lever * point.get(*node))).collect();
                let Some(mobility) = mobility.along(&direction) else { continue };
                let time = speed / (size * mobility);
                if time.is_finite() && time > 0.0 && quickest.is_none_or(|known| time < known.time) {
                    quickest = Some(Braking { time, pressed });
                }
            }
        }
        found.extend(quickest.map(|braking| (LoadId(index), braking)));
    }
    found
}

/// μ, o and v_s of a law that is smooth near rest.
fn slope(mechanism: &Mechanism, load: &Load) -> Option<[f64; 3]> {
    if !load.form.rubs || load.form.holds {
        return None;
    }
    let defaults = mechanism.defaults();
    let named = |name: &str| {
        let known = load.form.call.named.iter().any(|argument| argument.name == name);
        if known { value_at(load.named(name), &defaults) } else { Some(0.0) }
    };
    let speed = named("speed").filter(|speed| *speed > 0.0)?;
    let coefficient = named("coefficient")? + named("static")?;
    Some([coefficient, named("force")? + named("torque")?, speed])
}
