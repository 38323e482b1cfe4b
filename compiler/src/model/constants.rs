//! Constants: values at expansion, in an order in which each stands after those it names.

use super::lower::Lowering;
use super::names::Value;
use crate::messages;
use crate::syntax::{Path, Term, TermKind};

impl Lowering<'_> {
    /// The SI values of the constants, each after those it names.
    pub fn constants(&mut self) {
        self.constants = vec![None; self.definition.constants.len()];
        for index in self.order_of_constants() {
            let constant = &self.definition.constants[index];
            self.constants[index] = self.declared_number("const", &constant.name.text, &constant.entry);
        }
    }

    /// Depth first along the names, with a stack of its own: chains may be long.
    fn order_of_constants(&mut self) -> Vec<usize> {
        #[derive(Clone, Copy, PartialEq)]
        enum Mark {
            New,
            Open,
            Done,
        }
        let constants = &self.definition.constants;
        let mut marks = vec![Mark::New; constants.len()];
        let mut order = Vec::with_capacity(constants.len());
        let mut stack: Vec<(usize, Vec<usize>)> = Vec::new();
        for root in 0..constants.len() {
            if marks[root] != Mark::New {
                continue;
            }
            marks[root] = Mark::Open;
            stack.push((root, self.constants_in(&constants[root].entry.value)));
            while let Some((index, pending)) = stack.last_mut() {
                let index = *index;
                match pending.pop() {
                    None => {
                        if marks[index] == Mark::Open {
                            marks[index] = Mark::Done;
                            order.push(index);
                        }
                        stack.pop();
                    }
                    Some(next) if marks[next] == Mark::New => {
                        marks[next] = Mark::Open;
                        stack.push((next, self.constants_in(&constants[next].entry.value)));
                    }
                    Some(next) if marks[next] == Mark::Open => {
                        // Left out of the order, so that nothing is said about the value.
                        marks[index] = Mark::Done;
                        let open = stack.iter().map(|(index, _)| &constants[*index].name);
                        let cycle: Vec<_> =
                            open.skip_while(|name| name.text != constants[next].name.text).collect();
                        let names: Vec<&str> = cycle.iter().map(|name| name.text.as_str()).collect();
                        if let Some(first) = cycle.first() {
                            self.diagnostics.error(first.region, messages::cyclic_constants(&names));
                        }
                    }
                    Some(_) => {}
                }
            }
        }
        order
    }

    fn constants_in(&self, term: &Term) -> Vec<usize> {
        let mut found = Vec::new();
        visit_names(term, &mut |path| {
            if let Some(Value::Constant(index)) = self.names.value(&path.text) {
                found.push(index);
            }
        });
        found
    }
}

/// Calls `visit` with every name in an expression.
fn visit_names(term: &Term, visit: &mut impl FnMut(&Path)) {
    match &term.kind {
        TermKind::Name(path) => visit(path),
        TermKind::Operation(_, terms) | TermKind::Call(_, terms) => {
            terms.iter().for_each(|term| visit_names(term, visit));
        }
        TermKind::Measured(inner, _) => visit_names(inner, visit),
        TermKind::Ground(ground) => ground.at.iter().for_each(|term| visit_names(term, visit)),
        TermKind::Number { .. } => {}
    }
}
