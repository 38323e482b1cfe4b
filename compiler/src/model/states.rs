//! Internal states: what is declared by `state`, each with the one `rate` that names it.

use super::lower::{Lowering, Use, declared, declared_unit, name};
use super::names::Value;
use super::{Expr, InternalState, Rate};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, Entry, StateRate};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    /// All states with their rates. What their starts and rates name is known.
    pub fn states(&mut self) -> Vec<InternalState> {
        let definition = self.definition;
        let mut rates: Vec<Option<&'d StateRate>> = vec![None; definition.states.len()];
        for rate in &definition.rates {
            match self.names.value(&rate.name.text) {
                Some(Value::State(index)) if rates[index].is_none() => rates[index] = Some(rate),
                Some(Value::State(_)) => {
                    self.diagnostics.error(rate.name.region, messages::two_rates(&rate.name.text));
                }
                Some(_) => {
                    self.diagnostics.error(rate.name.region, messages::rate_of_no_state(&rate.name.text));
                }
                None => {
                    let states = definition.states.iter().map(|state| state.name.text.as_str());
                    let message = messages::unknown_state(&rate.name.text, states);
                    self.diagnostics.error(rate.name.region, message);
                }
            }
        }
        let states = definition.states.iter().zip(rates);
        states.filter_map(|(state, rate)| self.state(state, rate)).collect()
    }

    /// The states of `start { steady = (…); }`.
    pub fn steady(&mut self) -> Vec<(usize, Region)> {
        let definition = self.definition;
        let mut found: Vec<(usize, Region)> = Vec::new();
        for path in &definition.steady {
            let Some(Value::State(index)) = self.names.value(&path.text) else {
                let states = definition.states.iter().map(|state| state.name.text.as_str());
                self.diagnostics.error(path.region, messages::unknown_state(&path.text, states));
                continue;
            };
            match found.iter().find(|(known, _)| *known == index) {
                Some((_, first)) => {
                    let message = messages::steady_twice(&path.text);
                    self.diagnostics.conflict(path.region, message, *first, messages::first_here(&path.text));
                }
                None => found.push((index, path.region)),
            }
        }
        found
    }

    fn state(
        &mut self,
        state: &'d syntax::InternalState,
        rate: Option<&'d StateRate>,
    ) -> Option<InternalState> {
        let text = &state.name.text;
        let dimension = declared(state.entry.unit.as_ref());
        let start = self.declaration("state", text, &state.entry, Use::START);
        let scale = state.scale.as_ref().map(|value| self.scale_of_state(state, value, dimension));
        let Some(rate) = rate else {
            self.diagnostics.error(state.name.region, messages::state_without_rate(text));
            return None;
        };
        let value = self.value(&rate.value, Use::STATE_RATE)?;
        let what = messages::rate_of(text);
        let value = self.expect_dimension(value, dimension.over(Dimension::TIME), &what)?;
        if value == Expr::Number(0.0) {
            self.diagnostics.error(rate.value.region, messages::state_that_rests(text));
            return None;
        }
        let scale = match scale {
            Some(scale) => Some(scale?),
            None => None,
        };
        Some(InternalState {
            name: name(&state.name),
            unit: declared_unit(state.entry.unit.as_ref()),
            docs: state.docs.to_string(),
            start: start?,
            scale,
            rate: Rate::Written(value),
        })
    }

    /// A positive number in the unit of the state.
    fn scale_of_state(
        &mut self,
        state: &'d syntax::InternalState,
        value: &'d syntax::Term,
        dimension: Dimension,
    ) -> Option<f64> {
        let entry = Entry { unit: state.entry.unit.clone(), value: value.clone() };
        let scale = self.number(&entry, dimension, "scale")?;
        if scale > 0.0 {
            return Some(scale);
        }
        self.diagnostics.error(value.region, messages::scale_not_positive(scale));
        None
    }
}
