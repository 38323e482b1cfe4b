//! Checks: static rules on the model, numeric rules by assembling the mechanism, budgets on what comes out.

pub mod assemble;
mod messages;
pub mod rules;

use crate::diagnostics::Diagnostics;
use crate::model::Mechanism;
use crate::schedule::{Function, Programs, count};

/// The static rules.
pub fn check(mechanism: &Mechanism) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    rules::check(mechanism, &mut errors);
    errors.finish(())
}

/// Operations against `expect`.
pub fn budget(mechanism: &Mechanism, programs: &Programs, errors: &mut Diagnostics) {
    for (name, limit, span) in &mechanism.expect.operations {
        let name = name.as_deref().unwrap_or(Function::AccelerationBaumgarte.name());
        let Some((_, program)) = programs.functions.iter().find(|(function, _)| function.name() == name)
        else {
            let known: Vec<&str> = programs.functions.iter().map(|(function, _)| function.name()).collect();
            errors.error(*span, messages::unknown_function(name, &known));
            continue;
        };
        let found = count(program).total();
        if found > *limit {
            errors.error(*span, messages::too_many_operations(name, *limit, found));
        }
    }
}
