//! Quantities of the mechanism by name: `crank_pin.angle`, `slider.center.velocity.x`, `power(motor)`, `energy`.

use super::lower::{Lowering, Use};
use super::names::Part;
use super::values::Typed;
use super::{
    BodyId, ConstraintId, Coordinate, DriverId, Expr, Frame, JointId, LoadId, OfTeeth, Place, Quantity,
    ReactionPart, Rotor,
};
use crate::diagnostics::Region;
use crate::forms::{Acts, Spans};
use crate::messages;
use crate::syntax::{ConstraintTerm, FirstTerm, Label, LineTerm, Path, PlaceTerm, Space, Term, TermKind};
use crate::units::Dimension;

pub(super) struct Found {
    quantity: Quantity,
    dimension: Dimension,
}

impl Found {
    fn position(coordinate: Coordinate) -> Option<Self> {
        let dimension = coordinate.dimension();
        Some(Self { quantity: Quantity::Coordinate(coordinate), dimension })
    }

    pub(super) fn velocity(coordinate: Coordinate) -> Option<Self> {
        let dimension = coordinate.rate_dimension();
        Some(Self { quantity: Quantity::Rate(coordinate), dimension })
    }

    pub(super) fn result(quantity: Quantity, dimension: Dimension) -> Option<Self> {
        Some(Self { quantity, dimension })
    }
}

impl<'d> Lowering<'d> {
    /// A quantity that may stand in an expression of this use.
    pub fn permitted_quantity(&mut self, path: &Path, usage: Use) -> Option<(Quantity, Dimension)> {
        if let (Some(Part::Body(index)), 2..) = (self.names.part(&path.parts[0].text), path.parts.len())
            && index >= self.bodies.len()
        {
            // What bodies are made of is read before any place is known.
            self.permit(false, path, "a position or velocity", usage)?;
        }
        let found = self.find(path)?;
        let (permitted, kind) = match found.quantity {
            Quantity::Coordinate(_) => (usage.positions, "a position"),
            Quantity::Rate(_) | Quantity::Sliding { .. } => (usage.velocities, "a velocity"),
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
            | Quantity::Energy => (usage.results, "a result"),
        };
        self.permit(permitted, path, kind, usage)?;
        Some((found.quantity, found.dimension))
    }

    /// An angle, travel or position.
    pub fn coordinate(&mut self, path: &Path, verb: &str) -> Option<Coordinate> {
        match self.find(path)?.quantity {
            Quantity::Coordinate(coordinate) => Some(coordinate),
            _ => {
                self.diagnostics.error(path.region, messages::not_a_position(&path.text, verb));
                None
            }
        }
    }

    /// An angle, travel, position or the rate of one.
    pub fn coordinate_or_rate(&mut self, path: &Path) -> Option<(Coordinate, bool, Dimension)> {
        let found = self.find(path)?;
        match found.quantity {
            Quantity::Coordinate(coordinate) => Some((coordinate, false, found.dimension)),
            Quantity::Rate(coordinate) => Some((coordinate, true, found.dimension)),
            _ => {
                self.diagnostics.error(path.region, messages::not_a_state(&path.text));
                None
            }
        }
    }

    /// `power(load)`.
    pub fn power_of_load(&mut self, argument: &Term, region: Region, usage: Use) -> Option<Typed> {
        let TermKind::Name(path) = &argument.kind else {
            self.diagnostics.error(argument.region, messages::power_of_what());
            return None;
        };
        let contact = self.contact_named(&path.text).map(|index| self.load_of_contact(index));
        if let Some(load) = contact.or_else(|| match self.names.part(&path.text) {
            Some(Part::Load(index)) => Some(LoadId(index)),
            _ => None,
        }) {
            self.permit(usage.results, path, "a result", usage)?;
            let expr = Expr::Quantity(Quantity::Power(load));
            return Some(Typed { expr, dimension: Dimension::POWER, zero: false, region });
        }
        match self.names.part(&path.text) {
            Some(Part::Driver(_)) => {
                self.diagnostics.error(path.region, messages::power_of_driver(&path.text));
                None
            }
            _ => {
                let message = self.names.not_found("load", &path.text, |part| matches!(part, Part::Load(_)));
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }

    /// `distance(a.p, ground(0, 0))`.
    pub fn distance(&mut self, arguments: &[Term], region: Region, usage: Use) -> Option<Typed> {
        if !usage.positions {
            self.diagnostics.error(
                region,
                messages::not_permitted("distance(…)", "a position", usage.what, &usage.permitted()),
            );
            return None;
        }
        let (first, second) = (self.place_term(&arguments[0]), self.place_term(&arguments[1]));
        let (first, second) = (first?, second?);
        if first.frame == second.frame {
            self.diagnostics.error(region, messages::distance_in_one_body());
            return None;
        }
        let expr =
            Expr::Quantity(Quantity::Coordinate(Coordinate::Distance(Box::new(first), Box::new(second))));
        Some(Typed { expr, dimension: Dimension::LENGTH, zero: false, region })
    }

    /// A place that stands among expressions.
    fn place_term(&mut self, term: &Term) -> Option<Place> {
        match &term.kind {
            TermKind::Name(path) => self.place(&PlaceTerm::Named(path.clone())),
            TermKind::Ground(ground) => self.place(&PlaceTerm::Ground(ground.clone())),
            _ => {
                self.diagnostics.error(term.region, messages::value_as_place());
                None
            }
        }
    }

    fn find(&mut self, path: &Path) -> Option<Found> {
        let head = &path.parts[0];
        if path.parts.len() == 1 {
            return self.find_single(path);
        }
        match self.names.part(&head.text) {
            Some(Part::Body(index)) => self.of_body(BodyId(index), path),
            Some(Part::Joint(index)) => self.of_joint(JointId(index), path),
            Some(Part::Driver(index)) => self.of_driver(DriverId(index), path),
            Some(Part::Constraint(index)) if self.is_equation(index) => {
                self.of_equation(ConstraintId(index), path)
            }
            Some(Part::Load(index)) => self.of_load(LoadId(index), path),
            Some(Part::Contact(_)) => {
                self.diagnostics.error(path.region, messages::contact_by_quantity(&path.text, &head.text));
                None
            }
            Some(other) => {
                self.diagnostics.error(path.region, messages::no_quantities(&head.text, other.kind()));
                None
            }
            None => {
                let moving = |part| matches!(part, Part::Body(_) | Part::Joint(_) | Part::Driver(_));
                let similar = self.names.similar_part(&head.text, moving);
                let message = self.names.unknown("body, joint or driver", &head.text, similar);
                if !self.diagnostics.is_full() {
                    self.diagnostics.error(head.region, message);
                }
                None
            }
        }
    }

    fn find_single(&mut self, path: &Path) -> Option<Found> {
        match path.text.as_str() {
            "energy" => Found::result(Quantity::Energy, Dimension::TORQUE),
            "kinetic_energy" => Found::result(Quantity::KineticEnergy, Dimension::TORQUE),
            "potential_energy" => Found::result(Quantity::PotentialEnergy, Dimension::TORQUE),
            text => {
                let message = match self.names.part(text) {
                    Some(Part::Joint(index)) => {
                        let (angles, travels) = self.coordinates(JointId(index));
                        let names: Vec<&str> = angles.iter().chain(travels).map(|[name, _]| *name).collect();
                        messages::joint_as_value(text, &names)
                    }
                    Some(part) => messages::part_as_value(text, part.kind()),
                    None => match self.names.value(text) {
                        Some(value) => messages::value_as_quantity(text, value.kind()),
                        None => self.names.unknown("value", text, self.names.similar_value(text)),
                    },
                };
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }

    fn of_body(&mut self, body: BodyId, path: &Path) -> Option<Found> {
        let quantity = &path.parts[1];
        match self.mode(body, path).or_else(|| self.mode_of_file(body, path)) {
            Some(Ok((mode, false))) => return Found::position(mode),
            Some(Ok((mode, true))) => return Found::velocity(mode),
            Some(Err(())) => return None,
            None => {}
        }
        if path.parts.len() == 2 {
            match quantity.text.as_str() {
                "angle" | "rate" if self.is_particle(Frame::Body(body)) => {
                    self.diagnostics.error(path.region, messages::particle_turns(&path.parts[0].text));
                    return None;
                }
                "angle" | "orientation" if self.definition.space == Space::Spatial => {
                    self.diagnostics.error(path.region, messages::body_has_no_angle(&path.parts[0].text));
                    return None;
                }
                "rate" if self.definition.space == Space::Spatial => {
                    self.diagnostics.error(path.region, messages::quantities_of_rate(&path.parts[0].text));
                    return None;
                }
                "angle" => return Found::position(Coordinate::Angle(Rotor::Body(body))),
                "rate" => return Found::velocity(Coordinate::Angle(Rotor::Body(body))),
                _ => {}
            }
        }
        if let (Space::Spatial, "rate", [_, _, component]) =
            (self.definition.space, quantity.text.as_str(), path.parts.as_slice())
        {
            if self.is_particle(Frame::Body(body)) {
                self.diagnostics.error(path.region, messages::particle_turns(&path.parts[0].text));
                return None;
            }
            let Some(axis) = axis_of(&component.text, 3) else {
                let message = messages::quantities_of_rate(&path.parts[0].text);
                self.diagnostics.error(component.region, message);
                return None;
            };
            return Found::velocity(Coordinate::Turn(body, axis));
        }
        let point = Path {
            text: format!("{}.{}", path.parts[0].text, quantity.text),
            parts: path.parts[..2].to_vec(),
            region: path.parts[0].region.to(quantity.region),
        };
        let rest: Vec<&str> = path.parts[2..].iter().map(|part| part.text.as_str()).collect();
        let place = self.place(&PlaceTerm::Named(point))?;
        let along = |axis| Coordinate::Position(Box::new(place.clone()), axis);
        let space = self.definition.space;
        let axis = rest.last().and_then(|component| axis_of(component, space.dimensions()));
        match (rest.as_slice(), axis) {
            ([_], Some(axis)) => Found::position(along(axis)),
            (["velocity", _], Some(axis)) => Found::velocity(along(axis)),
            ([], _) => {
                self.diagnostics.error(path.region, messages::place_without_axis(&path.text, space));
                None
            }
            _ => {
                let region = path.parts[2].region.to(path.region);
                self.diagnostics.error(region, messages::quantities_of_place(&place.text, space));
                None
            }
        }
    }

    fn of_joint(&mut self, joint: JointId, path: &Path) -> Option<Found> {
        let quantity = &path.parts[1];
        if let Some(found) = self.of_play(joint, path) {
            return found;
        }
        if quantity.text == "reaction" {
            let part = self.reaction(joint, path)?;
            return Found::result(Quantity::Reaction(joint, part), part.dimension());
        }
        let term = &self.definition.joints[joint.0];
        if quantity.text == "power"
            && path.parts.len() == 2
            && let Some(load) = self.load_of_joint(term)
        {
            return Found::result(Quantity::Power(load), Dimension::POWER);
        }
        let effort = term.form.effort();
        if path.parts.len() == 2 && effort == Some(quantity.text.as_str()) {
            let rod = term.form.spans == Spans::Rod;
            let part = if rod { ReactionPart::Tension } else { ReactionPart::Pressing };
            return Found::result(Quantity::Reaction(joint, part), part.dimension());
        }
        let (angles, travels) = self.coordinates(joint);
        let find = |names: &[[&str; 2]], which: usize| {
            let found = names.iter().position(|names| names[which] == quantity.text);
            found.filter(|_| path.parts.len() == 2)
        };
        if let Some(index) = find(angles, 0) {
            return Found::position(Coordinate::Angle(Rotor::Joint(joint, index)));
        }
        if let Some(index) = find(angles, 1) {
            return Found::velocity(Coordinate::Angle(Rotor::Joint(joint, index)));
        }
        if let Some(index) = find(travels, 0) {
            return Found::position(Coordinate::Travel(joint, index));
        }
        if let Some(index) = find(travels, 1) {
            return Found::velocity(Coordinate::Travel(joint, index));
        }
        let message = self.joint_has(joint, &quantity.text);
        self.diagnostics.error(quantity.region, message);
        None
    }

    /// What a joint with play has beyond its contact and its angle: `wrist.offset.x` from its first place to its second along the axes of the
    /// first, `wrist.eccentricity`.
    fn of_play(&mut self, joint: JointId, path: &Path) -> Option<Option<Found>> {
        let term = &self.definition.joints[joint.0];
        let FirstTerm::Place(first) = term.first.clone() else { return None };
        let parts: Vec<&str> = path.parts[1..].iter().map(|part| part.text.as_str()).collect();
        let axis = match (term.loose, &parts[..]) {
            (true, ["offset", axis]) => Some(axis_of(axis, self.definition.space.dimensions())?),
            (true, ["eccentricity"]) => None,
            (true, ["reaction", ..]) => {
                self.diagnostics.error(path.region, messages::reaction_of_loose(&term.name.text));
                return Some(None);
            }
            _ => return None,
        };
        let second = term.second.clone();
        let places = self.place(&first).zip(self.place(&second));
        Some(places.and_then(|(first, second)| {
            Found::position(match axis {
                Some(axis) => Coordinate::Way(Box::new([first, second]), Box::new(Coordinate::along(axis))),
                None => Coordinate::Distance(Box::new(first), Box::new(second)),
            })
        }))
    }

    /// What a joint has instead of the quantity asked for.
    fn joint_has(&self, joint: JointId, asked: &str) -> String {
        let term = &self.definition.joints[joint.0];
        let (angles, travels) = self.coordinates(joint);
        let quantities: Vec<&str> = angles.iter().chain(travels).flatten().copied().collect();
        let of_particle =
            angles.is_empty() && !term.form.angles.is_empty() && matches!(asked, "angle" | "rate");
        if of_particle {
            return messages::joint_of_particle(&term.name.text, asked);
        }
        let (name, kind) = (&term.name.text, term.form.call.word);
        if !quantities.is_empty() {
            return messages::joint_has(name, kind, asked, &quantities);
        }
        let body = match &term.second {
            PlaceTerm::Named(path) => path.parts[0].text.as_str(),
            PlaceTerm::Ground(_) => "body",
        };
        let instead = match self.definition.space {
            Space::Planar => format!("`{body}.angle`"),
            Space::Spatial => format!("`{body}.rate.x`"),
        };
        messages::joint_has_none(name, kind, asked, &instead)
    }

    fn of_driver(&mut self, driver: DriverId, path: &Path) -> Option<Found> {
        let term = &self.definition.drivers[driver.0];
        let angular = term.quantity.parts.last().is_some_and(|last| last.text == "angle");
        match (path.parts[1].text.as_str(), path.parts.len()) {
            ("effort", 2) if angular => Found::result(Quantity::DriverEffort(driver), Dimension::TORQUE),
            ("effort", 2) => Found::result(Quantity::DriverEffort(driver), Dimension::FORCE),
            ("power", 2) => Found::result(Quantity::DriverPower(driver), Dimension::POWER),
            _ => {
                let region = path.parts[1].region;
                self.diagnostics.error(region, messages::quantities_of_driver(&path.parts[0].text));
                None
            }
        }
    }

    fn is_equation(&self, index: usize) -> bool {
        matches!(self.definition.constraints[index].kind, ConstraintTerm::Equation { .. })
    }

    fn of_equation(&mut self, constraint: ConstraintId, path: &Path) -> Option<Found> {
        if (path.parts[1].text.as_str(), path.parts.len()) != ("effort", 2) {
            let region = path.parts[1].region;
            self.diagnostics.error(region, messages::quantities_of_equation(&path.parts[0].text));
            return None;
        }
        // Where equations are not known yet, no effort may stand.
        let known = self.equations.get(constraint.0).copied();
        let dimension = known.unwrap_or(Some(Dimension::ONE))?;
        Found::result(Quantity::ConstraintEffort(constraint), Dimension::TORQUE.over(dimension))
    }

    fn of_load(&mut self, load: LoadId, path: &Path) -> Option<Found> {
        let written = &self.definition.loads[load.0];
        if written.form.rubs {
            return self.of_friction(load, path);
        }
        let effort = written.form.effort;
        if path.parts.len() == 2 && effort == Some(path.parts[1].text.as_str()) {
            return Found::result(Quantity::LoadEffort(load), self.effort(written));
        }
        if path.parts.len() == 2 && written.form.on.first() == Some(&Acts::Toothing) {
            let asked = path.parts[1].text.as_str();
            if let Some((_, part)) = OfTeeth::ALL.into_iter().find(|(name, _)| *name == asked) {
                return Found::result(Quantity::OfTeeth(load, part), part.dimension());
            }
            let message = messages::quantity_of_teeth(&path.parts[0].text, asked);
            self.diagnostics.error(path.parts[1].region, message);
            return None;
        }
        self.diagnostics.error(path.region, messages::quantity_of_load(&path.parts[0].text, effort));
        None
    }

    /// A joint with one angle, or in the plane a body that turns.
    pub fn rotor(&mut self, label: &'d Label) -> Option<Rotor> {
        match self.names.part(&label.text) {
            Some(Part::Body(index)) if self.is_particle(Frame::Body(BodyId(index))) => {
                self.diagnostics.error(label.region, messages::particle_turns(&label.text));
                None
            }
            Some(Part::Body(_)) if self.definition.space == Space::Spatial => {
                self.diagnostics.error(label.region, messages::body_has_no_angle(&label.text));
                None
            }
            Some(Part::Body(index)) => Some(Rotor::Body(BodyId(index))),
            Some(Part::Joint(index)) => {
                let joint = JointId(index);
                let (angles, _) = self.coordinates(joint);
                if angles.len() == 1 {
                    return Some(Rotor::Joint(joint, 0));
                }
                let names: Vec<&str> = angles.iter().map(|[angle, _]| *angle).collect();
                let message = match self.definition.space {
                    Space::Planar => self.joint_has(joint, "angle"),
                    Space::Spatial => messages::which_angle(&label.text, &names),
                };
                self.diagnostics.error(label.region, message);
                None
            }
            _ => {
                let fits = |part| matches!(part, Part::Body(_) | Part::Joint(_));
                let message = self.names.not_found("joint or body", &label.text, fits);
                self.diagnostics.error(label.region, message);
                None
            }
        }
    }

    /// A body in space that turns.
    pub fn turning_body(&mut self, label: &'d Label) -> Option<BodyId> {
        match self.names.part(&label.text) {
            Some(Part::Body(index)) if self.is_particle(Frame::Body(BodyId(index))) => {
                self.diagnostics.error(label.region, messages::particle_turns(&label.text));
                None
            }
            Some(Part::Body(index)) => Some(BodyId(index)),
            Some(Part::Joint(_)) => {
                self.diagnostics.error(label.region, messages::torque_of_components("body"));
                None
            }
            _ => {
                let message = self.names.not_found("body", &label.text, |part| matches!(part, Part::Body(_)));
                self.diagnostics.error(label.region, message);
                None
            }
        }
    }

    /// The body whose orientation `start` states.
    pub fn oriented_body(&mut self, path: &Path) -> Option<BodyId> {
        let head = &path.parts[0];
        match self.names.part(&head.text) {
            Some(Part::Body(_)) if self.definition.space == Space::Planar || path.parts.len() != 2 => {
                self.diagnostics.error(path.region, messages::not_a_state(&path.text));
                None
            }
            Some(Part::Body(index)) if self.is_particle(Frame::Body(BodyId(index))) => {
                self.diagnostics.error(path.region, messages::particle_turns(&head.text));
                None
            }
            Some(Part::Body(index)) => Some(BodyId(index)),
            _ => {
                let message = self.names.not_found("body", &head.text, |part| matches!(part, Part::Body(_)));
                self.diagnostics.error(head.region, message);
                None
            }
        }
    }

    /// A joint that slides along one direction.
    pub fn slide(&mut self, label: &'d Label) -> Option<JointId> {
        match self.names.part(&label.text) {
            Some(Part::Joint(index)) if self.coordinates(JointId(index)).1.len() == 1 => Some(JointId(index)),
            Some(Part::Joint(index)) => {
                let message = self.joint_has(JointId(index), "travel");
                self.diagnostics.error(label.region, message);
                None
            }
            _ => {
                let message =
                    self.names.not_found("joint", &label.text, |part| matches!(part, Part::Joint(_)));
                self.diagnostics.error(label.region, message);
                None
            }
        }
    }

    /// The names of a joint's angles and travels: those of its kind, and angles only between two things with an orientation.
    pub(super) fn coordinates(
        &self,
        joint: JointId,
    ) -> (&'static [[&'static str; 2]], &'static [[&'static str; 2]]) {
        let term = &self.definition.joints[joint.0];
        let first = match &term.first {
            FirstTerm::Place(first) => self.head(first),
            FirstTerm::Line(LineTerm::Named(_)) => Some(Frame::Ground),
            FirstTerm::Line(LineTerm::Inline { from, .. }) => self.head(from),
        };
        let second = self.head(&term.second);
        if [first, second].into_iter().flatten().any(|frame| self.is_particle(frame)) {
            return (&[], term.form.travels);
        }
        (term.form.angles, term.form.travels)
    }

    /// The body of a place, without any message.
    fn head(&self, place: &PlaceTerm) -> Option<Frame> {
        match place {
            PlaceTerm::Ground(_) => Some(Frame::Ground),
            PlaceTerm::Named(path) => match self.names.part(&path.parts[0].text) {
                Some(Part::Body(index)) => Some(Frame::Body(BodyId(index))),
                _ => None,
            },
        }
    }

    /// Whether this is a body without orientation.
    pub fn is_particle(&self, frame: Frame) -> bool {
        match frame {
            Frame::Ground => false,
            Frame::Body(body) => !self.definition.bodies[body.0].form.turns,
        }
    }
}

/// Index of a component by its name.
fn axis_of(name: &str, dimensions: usize) -> Option<usize> {
    ["x", "y", "z"][..dimensions].iter().position(|known| *known == name)
}
