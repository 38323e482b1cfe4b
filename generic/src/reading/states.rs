//! Internal states, those of loads among them: their names, starts and rates.

use super::laws::May;
use super::{Read, Reader};
use crate::definition::InternalState;
use crate::error::DefinitionError;
use crate::json::{field, list, name};

impl Reader<'_> {
    /// Declared ones first, then those of loads.
    pub(super) fn name_states(&mut self) -> Read<()> {
        let declared = list(self.tree, "states", "states")?.iter();
        let declared = declared.map(|state| name(state, "states").map(str::to_string));
        let names = declared.chain(self.states_of_loads()?.into_iter().map(Ok));
        self.states = names.enumerate().map(|(at, name)| Ok((name?, at))).collect::<Read<_>>()?;
        Ok(())
    }

    pub(super) fn read_states(&self) -> Read<Vec<InternalState>> {
        let rates = list(self.tree, "rates", "rates")?;
        let mut states = Vec::new();
        for node in list(self.tree, "states", "states")? {
            let own = name(node, "states")?;
            let rate = rates.iter().find(|rate| name(rate, "rates") == Ok(own));
            let rate = rate.ok_or_else(|| DefinitionError::malformed(own, "a rate"))?;
            states.push(InternalState {
                name: own.to_string(),
                start: self.entry(node, own)?,
                rate: self.law(field(rate, "value", own)?, own, May::Results)?,
            });
        }
        states.extend(self.hysteresis_states()?);
        Ok(states)
    }
}
