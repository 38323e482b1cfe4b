//! `options` and `expect`.

use super::lower::Lowering;
use super::lower::Use;
use super::names::Part;
use super::values::Typed;
use super::{
    Budget, Coordinate, Coordinates, EffortBound, Emit, Expect, Expr, JointId, Options, Redundant, Rotor,
    SolvedBy, Space, Turning, Within,
};
use crate::diagnostics::Region;
use crate::messages;
use crate::scalar::Scalar;
use crate::syntax::{ExpectEntry, Label, OptionEntry, Path, RangeTerm, Side, Term, TermKind, WrittenUnit};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    pub fn options(&mut self) -> Options {
        let mut coordinates = Coordinates::Auto;
        let mut solution = SolvedBy::Auto;
        let mut redundant = Redundant::Refuse;
        let mut accept_inertia = false;
        let (mut cut, mut independent) = (Vec::new(), Vec::new());
        let mut crate_path: Option<String> = None;
        let mut emit = Emit::default();
        let (mut self_check, mut export_c, mut friction_passes) = (None, None, None);
        let held = self.holds_gates() || self.has_rigid_contacts();
        let (mut held_at, mut by_impulses) = (None, false);
        for entry in &self.definition.options {
            match entry {
                OptionEntry::Coordinates(word) => {
                    coordinates = match word.text.as_str() {
                        "absolute" => Coordinates::Absolute,
                        "tree" => Coordinates::Tree,
                        _ => Coordinates::Auto,
                    };
                }
                OptionEntry::Solution(word) => {
                    solution = match word.text.as_str() {
                        "multipliers" => SolvedBy::Multipliers,
                        "independent" => SolvedBy::Independent,
                        _ => SolvedBy::Auto,
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
                OptionEntry::ExportC(word) => export_c = Scalar::named(&word.text),
                OptionEntry::FrictionPasses(passes, _) => friction_passes = Some(*passes),
                OptionEntry::Contact(word) => {
                    held_at = held.then_some(word.region);
                    if held && self.definition.contacts.is_empty() {
                        self.diagnostics.error(word.region, messages::holds_nothing());
                    }
                    let export = self.definition.options.iter().find_map(|entry| match entry {
                        OptionEntry::ExportC(scalar) => Some(scalar.region),
                        _ => None,
                    });
                    if held && let Some(export) = export {
                        self.diagnostics.error(export, messages::held_in_c());
                    }
                }
                OptionEntry::Impact(word) => {
                    by_impulses = word.text == "poisson";
                    if !self.has_rigid_contacts() {
                        self.diagnostics.error(word.region, messages::strikes_nothing(&word.text));
                    }
                }
                OptionEntry::Crate(path) => crate_path = Some(path.to_string()),
            }
        }
        self.options_twice();
        self.beside_rigid();
        self.beside_sticking();
        Options {
            coordinates,
            solution,
            redundant,
            friction_passes,
            held,
            held_at,
            by_impulses,
            accept_inertia,
            cut,
            independent,
            emit,
            self_check,
            export_c,
            crate_path,
        }
    }

    fn options_twice(&mut self) {
        let written = |entry: &'d OptionEntry| match entry {
            OptionEntry::Coordinates(label) => Some(("coordinates", label)),
            OptionEntry::Solution(label) => Some(("solution", label)),
            OptionEntry::Redundant(label) => Some(("redundant", label)),
            OptionEntry::Inertia(label) => Some(("inertia", label)),
            OptionEntry::SelfCheck(label) => Some(("self_check", label)),
            OptionEntry::ExportC(label) => Some(("export_c", label)),
            OptionEntry::Contact(label) => Some(("contact", label)),
            OptionEntry::Impact(label) => Some(("impact", label)),
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

    fn cut(&mut self, joint: &'d Label) -> Option<(JointId, Region)> {
        if let Some(Part::Joint(index)) = self.names.part(&joint.text) {
            return Some((JointId(index), joint.region));
        }
        let message = self.names.not_found("joint", &joint.text, |part| matches!(part, Part::Joint(_)));
        self.diagnostics.error(joint.region, message);
        None
    }

    fn independent(&mut self, path: &'d Path) -> Option<(Coordinate, Region)> {
        let coordinate = self.coordinate(path, "be an independent coordinate")?;
        Some((coordinate, path.region))
    }

    pub fn expect(&mut self) -> Expect {
        let mut expect = Expect::default();
        for entry in &self.definition.expect {
            match entry {
                ExpectEntry::DegreesOfFreedom(count, region) => {
                    expect.degrees_of_freedom = Some((*count, *region));
                }
                ExpectEntry::Budget(written) => {
                    let function = written.function.as_ref().map(|label| label.text.clone());
                    let (of, limit, span) = (written.of, written.limit, written.region);
                    expect.budgets.push(Budget { of, function, limit, span });
                }
                ExpectEntry::Rotates(labels) => {
                    expect.motion.rotates.extend(labels.iter().filter_map(|label| self.turning(label)));
                }
                ExpectEntry::NoSingularity(region) => {
                    if self.can_be_swept("no_singularity", *region) {
                        expect.motion.no_singularity = Some(*region);
                    }
                }
                ExpectEntry::Within(path, range) => expect.motion.within.extend(self.within(path, range)),
                ExpectEntry::Effort(path, unit, side, bound) => {
                    expect.motion.efforts.extend(self.effort_bound(path, unit.as_ref(), *side, bound));
                }
                ExpectEntry::ContactTime(path, time) => {
                    expect.contact_times.extend(self.contact_time(path, time))
                }
                ExpectEntry::FrictionTime(path, time) => {
                    expect.friction_times.extend(self.friction_time(path, time))
                }
                ExpectEntry::Frequency(path, side, bound) => {
                    expect.frequencies.extend(self.frequency(path, *side, bound));
                }
                ExpectEntry::Deflection(place, side, bound) => {
                    expect.deflections.extend(self.deflection(place, *side, bound));
                }
            }
        }
        self.expectations_twice();
        expect
    }

    /// The motion is followed at expansion in the plane only.
    fn can_be_swept(&mut self, what: &str, at: Region) -> bool {
        let planar = self.definition.space == Space::Planar;
        if !planar {
            self.diagnostics.error(at, messages::motion_in_space(what));
        }
        planar
    }

    fn turning(&mut self, label: &'d Label) -> Option<Turning> {
        if !self.can_be_swept("rotates", label.region) {
            return None;
        }
        let rotor: Rotor = self.rotor(label)?;
        Some(Turning { rotor, name: label.text.clone(), span: label.region })
    }

    fn within(&mut self, path: &'d Path, range: &'d RangeTerm) -> Option<Within> {
        if !self.can_be_swept("a range", path.region) {
            return None;
        }
        let coordinate = self.coordinate(path, "be expected in a range")?;
        let dimension = coordinate.dimension();
        let what = messages::quoted(&path.text);
        let mut end = |term| match self.with_unit(term, range.unit.as_ref(), dimension, Use::RANGE, &what)? {
            Expr::Number(value) => Some(value),
            _ => {
                self.diagnostics.error(term.region, messages::not_constant(&what));
                None
            }
        };
        let (from, to) = (end(&range.from)?, end(&range.to)?);
        let si = if dimension == Dimension::ANGLE { "rad" } else { "m" };
        let unit = range
            .unit
            .as_ref()
            .map_or((si.to_string(), 1.0), |written| (written.unit.text.clone(), written.unit.scale));
        if from >= to {
            let turn = (dimension == Dimension::ANGLE).then_some(std::f64::consts::TAU / unit.1);
            let message = messages::range_upside_down(from / unit.1, to / unit.1, &unit.0, turn);
            self.diagnostics.error(range.from.region.to(range.to.region), message);
            return None;
        }
        Some(Within { coordinate, text: path.text.clone(), from, to, unit, span: path.region })
    }

    /// A force or torque by its name, on one side of a number.
    fn effort_bound(
        &mut self,
        path: &'d Path,
        unit: Option<&'d WrittenUnit>,
        side: Side,
        bound: &'d Term,
    ) -> Option<EffortBound> {
        if !self.can_be_swept("a bound of a force", path.region) {
            return None;
        }
        let named = Term { kind: TermKind::Name(path.clone()), region: path.region, height: 0 };
        let Typed { expr: value, dimension, .. } = self.value(&named, Use::OUTPUT)?;
        let unit_of = [(Dimension::FORCE, "N"), (Dimension::TORQUE, "N m")];
        let Some((_, si)) = unit_of.into_iter().find(|(known, _)| dimension.fits(*known)) else {
            self.diagnostics.error(path.region, messages::bound_of_no_effort(&path.text, dimension));
            return None;
        };
        let what = messages::quoted(&path.text);
        let Expr::Number(number) = self.with_unit(bound, unit, dimension, Use::RANGE, &what)? else {
            self.diagnostics.error(bound.region, messages::not_constant(&what));
            return None;
        };
        if self.definition.drivers.is_empty() {
            self.diagnostics.error(path.region, messages::effort_without_driver(&path.text));
            return None;
        }
        if !self.definition.states.is_empty() {
            self.diagnostics.error(path.region, messages::effort_by_states(&path.text));
            return None;
        }
        Some(EffortBound { value, text: path.text.clone(), side, bound: number, unit: si, span: path.region })
    }

    /// One range for a coordinate, one number of freedoms.
    fn expectations_twice(&mut self) {
        let mut seen: Vec<(&str, Region)> = Vec::new();
        for entry in &self.definition.expect {
            let (name, region) = match entry {
                ExpectEntry::DegreesOfFreedom(_, region) => ("degrees_of_freedom", *region),
                ExpectEntry::Within(path, _) => (path.text.as_str(), path.region),
                ExpectEntry::NoSingularity(region) => ("no_singularity", *region),
                _ => continue,
            };
            match seen.iter().find(|(known, _)| *known == name) {
                Some((_, first)) => {
                    let message = messages::property_twice(name, "expect");
                    self.diagnostics.conflict(region, message, *first, messages::first_here(name));
                }
                None => seen.push((name, region)),
            }
        }
    }
}
