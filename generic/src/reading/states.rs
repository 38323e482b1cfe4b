//! Internal states: their starts and their rates.

use super::laws::May;
use super::{Read, Reader};
use crate::definition::InternalState;
use crate::error::DefinitionError;
use crate::json::{field, list, name};

impl Reader<'_> {
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
        Ok(states)
    }
}
