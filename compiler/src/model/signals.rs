//! Signals: expressions with a name. Where a signal is named its expression stands, as far as that may stand there.

use super::lower::{Lowering, Use, declared, declared_unit, name};
use super::names::Value;
use super::unused::Scope;
use super::values::Typed;
use super::{Expr, Quantity, Signal};
use crate::messages;
use crate::syntax::{self, Definition, Path};
use crate::units::Dimension;

/// Expressions stand in one another as often as they are named: what a signal may come to.
const LARGEST: usize = 20_000;

/// The signals of a definition as far as they are known.
pub(super) struct Signals {
    known: Vec<Read>,
    /// Those that are being read, each named by the one before it.
    open: Vec<usize>,
}

#[derive(Clone)]
enum Read {
    Unread,
    Wrong,
    Known(Typed),
}

impl Signals {
    pub fn of(definition: &Definition) -> Self {
        Signals { known: vec![Read::Unread; definition.signals.len()], open: Vec::new() }
    }
}

impl Lowering<'_> {
    /// Those that nothing names are checked, too.
    pub fn all_signals(&mut self) {
        for index in 0..self.definition.signals.len() {
            self.signal(index, Use::SIGNAL);
        }
    }

    /// What it is called and measured in.
    pub fn named_signal(&mut self, signal: &syntax::Signal) -> Option<Signal> {
        Some(Signal { name: name(&signal.name), unit: declared_unit(signal.entry.unit.as_ref()) })
    }

    /// What a signal stands for, where it is named.
    pub fn signal_at(&mut self, index: usize, path: &Path, usage: Use) -> Option<Typed> {
        self.used.insert((Scope::Value, &self.definition.signals[index].name.text));
        let typed = self.signal(index, usage)?;
        self.permit_contents(&typed.expr, path, usage)?;
        self.smooth_contents(&typed.expr, path, usage)?;
        Some(Typed { region: path.region, ..typed })
    }

    /// The signal of `name.rate`, where no part has this name.
    pub fn rate_of_signal(&self, path: &Path) -> Option<usize> {
        let [owner, rate] = &path.parts[..] else { return None };
        match self.names.value(&owner.text) {
            Some(Value::Signal(index)) if rate.text == "rate" && self.names.part(&owner.text).is_none() => {
                Some(index)
            }
            _ => None,
        }
    }

    /// The time derivative of a signal of positions and time.
    pub fn signal_rate_at(&mut self, index: usize, path: &Path, usage: Use) -> Option<Typed> {
        self.used.insert((Scope::Value, &self.definition.signals[index].name.text));
        self.permit(usage.velocities, path, "a velocity", usage)?;
        let typed = self.signal(index, usage)?;
        self.permit_contents(&typed.expr, path, Use::RATE)?;
        let dimension = typed.dimension.over(Dimension::TIME);
        Some(Typed { expr: Expr::Rate(Box::new(typed.expr)), dimension, zero: false, region: path.region })
    }

    /// What a signal stands for. Before places are known it is read where it is named, by what may stand there.
    fn signal(&mut self, index: usize, usage: Use) -> Option<Typed> {
        match &self.signals.known[index] {
            Read::Known(typed) => return Some(typed.clone()),
            Read::Wrong => return None,
            Read::Unread => {}
        }
        let definition = self.definition;
        let signal = &definition.signals[index];
        if let Some(from) = self.signals.open.iter().position(|open| *open == index) {
            let circle = self.signals.open[from..].iter().chain([&index]);
            let names: Vec<&str> = circle.map(|open| definition.signals[*open].name.text.as_str()).collect();
            self.diagnostics.error(signal.name.region, messages::signal_of_itself(&names));
            return None;
        }
        let early = self.bodies.len() < definition.bodies.len();
        self.signals.open.push(index);
        let usage = if early { usage } else { Use::SIGNAL };
        let expr = self.declaration("signal", &signal.name.text, &signal.entry, usage);
        self.signals.open.pop();
        let typed = expr.and_then(|expr| {
            let mut size = 0;
            expr.visit(&mut |_| size += 1);
            if size > LARGEST {
                self.diagnostics
                    .error(signal.name.region, messages::signal_too_large(&signal.name.text, size));
                return None;
            }
            let dimension = declared(signal.entry.unit.as_ref());
            Some(Typed { expr, dimension, zero: false, region: signal.name.region })
        });
        match &typed {
            None => self.signals.known[index] = Read::Wrong,
            Some(_) if early => {}
            Some(typed) => self.signals.known[index] = Read::Known(typed.clone()),
        }
        typed
    }

    /// An error if something that a signal depends on may not stand where it is named.
    fn permit_contents(&mut self, expr: &Expr, path: &Path, usage: Use) -> Option<()> {
        let mut found = None;
        expr.visit(&mut |expr| {
            let (permitted, kind) = match expr {
                Expr::Parameter(_) => (usage.parameters, "a parameter"),
                Expr::Input(_) => (usage.inputs, "an input"),
                Expr::State(_) => (usage.states, "a state"),
                Expr::Memory(_) => (usage.states, "a memory"),
                Expr::Time => (usage.time, "the time"),
                Expr::Quantity(Quantity::Coordinate(_)) => (usage.positions, "a position"),
                Expr::Quantity(Quantity::Rate(_) | Quantity::Sliding { .. })
                | Expr::Rate(_)
                | Expr::Gate(..) => (usage.velocities, "a velocity"),
                Expr::Quantity(
                    Quantity::Power(_)
                    | Quantity::DriverPower(_)
                    | Quantity::DriverEffort(_)
                    | Quantity::LoadEffort(_)
                    | Quantity::OfTeeth(..)
                    | Quantity::Pressing(_)
                    | Quantity::ConstraintEffort(_)
                    | Quantity::Reaction(..)
                    | Quantity::KineticEnergy
                    | Quantity::PotentialEnergy
                    | Quantity::Energy,
                ) => (usage.results, "a result"),
                Expr::Number(_)
                | Expr::Unary(..)
                | Expr::Binary(..)
                | Expr::Power(..)
                | Expr::If(..)
                | Expr::Table(..) => (true, ""),
            };
            if !permitted && found.is_none() {
                found = Some(kind);
            }
        });
        match found {
            None => Some(()),
            Some(kind) => {
                let message =
                    messages::signal_not_permitted(&path.text, kind, usage.what, &usage.permitted());
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }
}
