//! What uses of parts give to ports: it must be of the port's kind.

use super::UsedPart;
use super::lower::{Lowering, name};
use super::names::Part;
use crate::messages;
use crate::syntax::{Definition, Given, PartUse, PlaceTerm, PortKind};

impl<'d> Lowering<'d> {
    /// Checks what every use gives, so that what is wrong is said there and not inside the part.
    pub fn given(&mut self) {
        for PartUse { given, .. } in &self.definition.uses {
            for given in given {
                self.of_kind(given);
            }
        }
    }

    /// What `explain` and builds have to know of uses.
    pub fn used_parts(&self) -> Vec<UsedPart> {
        let Definition { uses, files, .. } = self.definition;
        let used = |used: &PartUse| UsedPart {
            name: name(&used.name),
            of: used.part.clone(),
            file: used.file.and_then(|index| files.get(index)?.on_disk.clone()),
        };
        uses.iter().map(used).collect()
    }

    fn of_kind(&mut self, given: &'d Given) {
        let Given { port, kind, path } = given;
        let text = path.text.as_str();
        let part = self.names.part(text);
        let fits = match kind {
            PortKind::Place => {
                self.place(&PlaceTerm::Named(path.clone()));
                return;
            }
            PortKind::Body => matches!(part, Some(Part::Body(_))),
            PortKind::Joint => matches!(part, Some(Part::Joint(_))),
            PortKind::Table => self.names.table(text).is_some(),
        };
        if fits {
            return;
        }
        let wanted = kind.word();
        let message = match part {
            Some(part) => messages::wrong_kind_given(port, wanted, text, part.kind()),
            None if self.names.value(text).is_some() => {
                messages::wrong_kind_given(port, wanted, text, "a value")
            }
            None => {
                let similar = match kind {
                    PortKind::Table => self.names.similar_table(text),
                    _ => self.names.similar_part(text, |part| match kind {
                        PortKind::Body => matches!(part, Part::Body(_)),
                        PortKind::Joint => matches!(part, Part::Joint(_)),
                        PortKind::Place | PortKind::Table => false,
                    }),
                };
                messages::unknown(wanted, text, similar)
            }
        };
        self.diagnostics.error(path.region, message);
    }
}
