//! `options` and `expect`.

use super::lower::Lowering;
use super::names::Part;
use super::{Budget, Coordinates, Emit, Expect, JointId, Options, Quantity, Redundant};
use crate::messages;
use crate::syntax::{ExpectEntry, Label, OptionEntry, Path};
use proc_macro2::{Span, TokenStream};

impl<'d> Lowering<'d> {
    pub fn options(&mut self) -> Options {
        let mut coordinates = Coordinates::Auto;
        let mut redundant = Redundant::Refuse;
        let mut accept_inertia = false;
        let (mut cut, mut independent) = (Vec::new(), Vec::new());
        let mut crate_path: Option<TokenStream> = None;
        let mut emit = Emit::default();
        let mut self_check = None;
        for entry in &self.definition.options {
            match entry {
                OptionEntry::Coordinates(word) => {
                    coordinates = match word.text.as_str() {
                        "absolute" => Coordinates::Absolute,
                        "tree" => Coordinates::Tree,
                        _ => Coordinates::Auto,
                    };
                }
                OptionEntry::Redundant(word) => {
                    redundant = match word.text.as_str() {
                        "drop" => Redundant::Drop,
                        "keep" => Redundant::Keep,
                        _ => Redundant::Refuse,
                    };
                }
                OptionEntry::Inertia(word) => accept_inertia = word.text == "accept",
                OptionEntry::Cut(joints) => cut.extend(joints.iter().filter_map(|joint| self.cut(joint))),
                OptionEntry::Independent(paths) => {
                    independent.extend(paths.iter().filter_map(|path| self.independent(path)));
                }
                OptionEntry::Emit(words) => words.iter().for_each(|word| emit.set(&word.text)),
                OptionEntry::SelfCheck(word) => self_check = Some(word.text == "on"),
                OptionEntry::Crate(path) => crate_path = Some(path.clone()),
            }
        }
        self.options_twice();
        Options { coordinates, redundant, accept_inertia, cut, independent, emit, self_check, crate_path }
    }

    fn options_twice(&mut self) {
        let written = |entry: &'d OptionEntry| match entry {
            OptionEntry::Coordinates(label) => Some(("coordinates", label)),
            OptionEntry::Redundant(label) => Some(("redundant", label)),
            OptionEntry::Inertia(label) => Some(("inertia", label)),
            OptionEntry::SelfCheck(label) => Some(("self_check", label)),
            _ => None,
        };
        let mut seen: Vec<(&str, &Label)> = Vec::new();
        for (option, label) in self.definition.options.iter().filter_map(written) {
            match seen.iter().find(|(name, _)| *name == option) {
                Some((_, first)) => {
                    let message = messages::property_twice(option, "options");
                    let note = messages::first_here(option);
                    self.diagnostics.conflict(label.region, message, first.region, note);
                }
                None => seen.push((option, label)),
            }
        }
    }

    fn cut(&mut self, joint: &'d Label) -> Option<(JointId, Span)> {
        if let Some(Part::Joint(index)) = self.names.part(&joint.text) {
            return Some((JointId(index), joint.region.span()));
        }
        let similar = self.names.similar_part(&joint.text, |part| matches!(part, Part::Joint(_)));
        self.diagnostics.error(joint.region, messages::unknown("joint", &joint.text, similar));
        None
    }

    fn independent(&mut self, path: &'d Path) -> Option<(Quantity, Span)> {
        let (quantity, _) = self.position_quantity(path, "be an independent coordinate")?;
        Some((quantity, path.region.span()))
    }

    pub fn expect(&mut self) -> Expect {
        let mut expect = Expect::default();
        for entry in &self.definition.expect {
            match entry {
                ExpectEntry::DegreesOfFreedom(count, region) => {
                    expect.degrees_of_freedom = Some((*count, region.span()));
                }
                ExpectEntry::Budget(written) => {
                    let function = written.function.as_ref().map(|label| label.text.clone());
                    let (of, limit, span) = (written.of, written.limit, written.region.span());
                    expect.budgets.push(Budget { of, function, limit, span });
                }
            }
        }
        expect
    }
}
