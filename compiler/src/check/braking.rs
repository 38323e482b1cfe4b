//! Friction near rest, and how short steps have to be there.
//!
//! ```text
//! smooth      a damper d = (μ N r + o)/v_s         t = 1/(d w)      steps below 2.78 t
//! bristles    a spring k = N r σ₀, d = N r σ₁      t = 1/|s|, s² + d w s + k w = 0, |s| the larger      steps below 2 t
//! ```
//! of each coordinate that slides, the shortest. N is that at the start, r the radius of what turns, else 1, o what does not depend on load (N or N m), and w =
//! J A Jᵀ one by the mass that is braked. Explicit methods of fourth order need steps below 2.78 t beside a damper, and no explicit method takes steps of more
//! than some 2 t beside a spring (Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, IV.2). Bristles give back no more than they took where
//! c ≥ N r σ₁ (μ_s − μ_k)/μ_k (Barabanov and Ortega, IEEE TAC 45 (2000) 830).

use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use super::mobility::{Direction, Mobility};
use crate::diagnostics::Diagnostics;
use crate::equations::{Braked, Equations, Laws, braked};
use crate::model::{Load, LoadId, Mechanism, value_at};
use crate::numbers::significant;
use crate::solve::Solved;
use std::fmt;

/// What a friction is like near rest, at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Braking {
    /// t, s.
    pub time: f64,
    /// N.
    pub pressed: f64,
    pub by: By,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    /// A damper.
    Smooth,
    /// Springs; c, and from where on they give back no more than they took, N s/m or N m s/rad.
    Bristles { viscous: f64, passive: f64 },
}

impl Braking {
    /// s.
    pub fn longest_step(&self) -> f64 {
        match self.by {
            By::Smooth => 2.78 * self.time,
            By::Bristles { .. } => 2.0 * self.time,
        }
    }
}

impl fmt::Display for Braking {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let short = |it: f64| significant(it, 3);
        write!(f, "pressed by {} N at the start; near rest ", short(self.pressed))?;
        match self.by {
            By::Smooth => write!(f, "it brakes within {} s", short(self.time))?,
            By::Bristles { .. } => write!(f, "its bristles swing within {} s", short(self.time))?,
        }
        write!(f, ", so steps below {} s", short(self.longest_step()))?;
        match self.by {
            By::Bristles { viscous, passive } if viscous < passive => {
                write!(f, "; it may give back more than it took: `viscous` is {}, ", short(viscous))?;
                write!(f, "and would have to be {}", short(passive))
            }
            _ => Ok(()),
        }
    }
}

/// That of each friction by `coulomb`, `stribeck`, `lugre` and `asperity` that something presses at the start; an error where one is quicker than is expected.
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
            Some(Braking { time, pressed, by }) if time < expected.least => {
                let softer = match by {
                    By::Smooth => "its `speed` larger",
                    By::Bristles { .. } => "its `stiffness` and `damping` smaller",
                };
                let message = messages::friction_too_quick(name, time, expected.least, pressed, softer);
                errors.error(expected.span, message);
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
    let rubbing: Vec<(usize, &Load, Law)> = mechanism
        .loads
        .iter()
        .enumerate()
        .filter_map(|(index, load)| Some((index, load, Law::of(mechanism, load)?)))
        .collect();
    if rubbing.is_empty() {
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
    let slides: Vec<Vec<Braked>> = rubbing.iter().map(|(_, load, _)| braked(&laws, load)).collect();
    let mobility = Mobility::at(&mut point);
    let mut found = Vec::new();
    for ((index, _, law), slides) in rubbing.into_iter().zip(slides) {
        let mut quickest: Option<Braking> = None;
        for Braked { along, levers, arm, pressed } in slides {
            let nodes = along.iter().flat_map(|jet| jet.columns.values().copied());
            point.evaluate(&Ancestry::of(
                equations,
                nodes.chain(levers.iter().copied()).chain([arm, pressed]),
            ));
            let [arm, pressed] = [arm, pressed].map(|node| point.get(node));
            for (jet, lever) in along.iter().zip(&levers) {
                let lever = point.get(*lever);
                let direction: Direction =
                    jet.columns.iter().map(|(column, node)| (*column, lever * point.get(*node))).collect();
                let Some(mobility) = mobility.along(&direction) else { continue };
                let (time, by) = law.near_rest(pressed, arm, mobility);
                if time.is_finite() && time > 0.0 && quickest.is_none_or(|known| time < known.time) {
                    quickest = Some(Braking { time, pressed, by });
                }
            }
        }
        found.extend(quickest.map(|braking| (LoadId(index), braking)));
    }
    found
}

/// A law near rest, at the defaults of parameters.
enum Law {
    Smooth { coefficient: f64, own: f64, speed: f64 },
    Bristles { stiffness: f64, damping: f64, viscous: f64, excess: f64 },
}

impl Law {
    /// Nothing where inputs or what moves have a part in it, and of what holds.
    fn of(mechanism: &Mechanism, load: &Load) -> Option<Self> {
        if !load.form.rubs || load.form.holds {
            return None;
        }
        let defaults = mechanism.defaults();
        let known = |name: &str| load.form.call.named.iter().any(|argument| argument.name == name);
        let named = |name: &str| if known(name) { value_at(load.named(name), &defaults) } else { Some(0.0) };
        if known("speed") {
            let speed = named("speed").filter(|speed| *speed > 0.0)?;
            let coefficient = named("coefficient")? + named("static")?;
            return Some(Self::Smooth { coefficient, own: named("force")? + named("torque")?, speed });
        }
        let (most, least) = (named("static")?, named("kinetic")?);
        let excess = if least > 0.0 { (most - least) / least } else { 0.0 };
        let [stiffness, damping, viscous] = ["stiffness", "damping", "viscous"].map(named);
        Some(Self::Bristles { stiffness: stiffness?, damping: damping?, viscous: viscous?, excess })
    }

    /// t, and what brakes.
    fn near_rest(&self, pressed: f64, arm: f64, mobility: f64) -> (f64, By) {
        let load = pressed * arm;
        match *self {
            Self::Smooth { coefficient, own, speed } => {
                (speed / ((coefficient * load + own) * mobility), By::Smooth)
            }
            Self::Bristles { stiffness, damping, viscous, excess } => {
                let by = By::Bristles { viscous, passive: load * damping * excess };
                let [spring, half] = [load * stiffness * mobility, 0.5 * load * damping * mobility];
                // The largest root of s² + 2 h s + k, by its size.
                let overdamped = half * half - spring;
                let rate = if overdamped > 0.0 { half + overdamped.sqrt() } else { spring.sqrt() };
                (1.0 / rate, by)
            }
        }
    }
}
