//! Bodies that deform as a `.flex` file has it: read beside the file that names them, checked, and handed to the definition as numbers. The
//! format is described in `docs/flex-format.md`.

mod read;
mod rules;

use super::tables::term;
use super::{FileOf, Source, disk};
use crate::diagnostics::{Diagnostics, Region};
use crate::messages;
use crate::modal::Reduced;
use crate::syntax::{Body, Definition, ModalTerm, NodeTerm, ReadModes, Tuple};
use std::sync::Arc;

/// What is wrong, and where it is to be said.
type Misread = (Region, String);

/// The modes of a text, if it keeps to all rules; else its place and what is wrong.
pub fn modes(source: &Source) -> Result<Reduced, String> {
    let (reduced, places) = read::read(source)?;
    rules::check(&reduced, &places).map_err(|(place, message)| place.of(source) + &message)?;
    Ok(reduced)
}

/// Puts what files say into the bodies that name them.
pub(super) fn read_bodies(definition: &mut Definition, file_of: FileOf, errors: &mut Diagnostics) {
    for body in &mut definition.bodies {
        let Some(modal) = &mut body.modal else { continue };
        match data(&body.name.text, modal, file_of) {
            Ok(read) => {
                for NodeTerm { name, number, region, unit } in &modal.nodes {
                    let Some(node) = read.reduced.nodes.iter().find(|it| it.number == *number) else {
                        let message = messages::no_such_node(*number, &read.shown, &numbers(&read.reduced));
                        errors.error(*region, message);
                        continue;
                    };
                    let values = node.at.map(|value| term(value, *region)).to_vec();
                    body.points.push((name.clone(), Tuple { unit: unit.clone(), values, region: *region }));
                }
                modal.read = Some(read);
            }
            Err((region, message)) => errors.error(region, message),
        }
    }
}

fn numbers(reduced: &Reduced) -> Vec<u64> {
    reduced.nodes.iter().map(|node| node.number).collect()
}

fn data(body: &str, modal: &ModalTerm, file_of: FileOf) -> Result<ReadModes, Misread> {
    let region = modal.file.region;
    let at_file = |message| (region, message);
    let caller = file_of(region.start);
    let source = disk::read(&modal.file.name, caller.as_deref()).map_err(at_file)?;
    let on_disk = disk::on_disk(&source, caller).map_err(at_file)?;
    let all = modes(&source).map_err(at_file)?;
    let rigid = rules::rigid(&all);
    let reduced = match &modal.modes {
        Some(([from, to], region)) => {
            if *to > all.modes() {
                return Err((*region, messages::modes_beyond(&source.name, *to, all.modes())));
            }
            if *from <= rigid {
                return Err((*region, messages::rigid_modes_taken(body, rigid, all.modes())));
            }
            all.only(*from..=*to)
        }
        None if rigid > 0 => return Err((region, messages::rigid_modes_taken(body, rigid, all.modes()))),
        None => all,
    };
    Ok(ReadModes { shown: source.name, on_disk, reduced: Arc::new(reduced) })
}

impl Body {
    /// What its file says, once it has been read.
    pub fn reduced(&self) -> Option<&Arc<Reduced>> {
        self.modal.as_ref()?.read.as_ref().map(|read| &read.reduced)
    }
}
