//! Loads: what they act on, their arguments, their laws. Directions become unit vectors here.

use super::fold;
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::values::padded;
use super::{Expr, Function1, Function2, JointId, Load, Rotor, Subject, Vector};
use crate::forms::{Acts, Argument, Law, Value};
use crate::messages;
use crate::syntax::{self, LawTerm, Named, Space, SubjectTerm, Tuple};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    pub fn load(&mut self, load: &'d syntax::Load) -> Option<Load> {
        if self.is_torque_on_body_in_space(load) {
            return None;
        }
        let on = self.subjects(load);
        let (arguments, along) = (load.form.call.named.iter(), along(on.as_deref()));
        let values: Vec<Option<Vec<Expr>>> =
            arguments.map(|argument| self.load_argument(load, argument, along)).collect();
        let law = self.law(load, on.as_deref());
        let (on, values): (_, Option<Vec<_>>) = (on?, values.into_iter().collect());
        let (mut values, law) = (values?, law?);
        self.rates_of_arguments(load, &mut values)?;
        self.rubs(load, &on, &mut values)?;
        self.yields(load, &on, &mut values)?;
        let ungated = self.held_by(load, &on)?;
        let law = match (load.form.law, &law[..]) {
            (Law::Components(_), [value]) => directed(load, &values, value),
            _ => law,
        };
        let teeth = self.meshing(load, &on)?;
        Some(Load {
            name: name(&load.name),
            form: load.form,
            on,
            values,
            law,
            states: 0..0,
            teeth,
            normal: None,
            slides: Vec::new(),
            ungated,
            restitutions: Vec::new(),
            adheres: false,
        })
    }

    /// A torque on a body in space has components.
    fn is_torque_on_body_in_space(&mut self, load: &'d syntax::Load) -> bool {
        let (Law::Value(_), Space::Spatial) = (load.form.law, self.definition.space) else { return false };
        for (subject, acts) in load.on.iter().zip(load.form.acts()) {
            if let (SubjectTerm::Name(label), Acts::Rotor) = (subject, acts)
                && let Some(Part::Body(_)) = self.names.part(&label.text)
            {
                self.diagnostics.error(label.region, messages::torque_of_components(&label.text));
                return true;
            }
        }
        false
    }

    /// What it acts on; two places belong to two things.
    fn subjects(&mut self, load: &'d syntax::Load) -> Option<Vec<Subject>> {
        let subjects: Vec<_> =
            load.on.iter().zip(load.form.acts()).map(|(written, acts)| self.subject(written, acts)).collect();
        let subjects: Vec<Subject> = subjects.into_iter().collect::<Option<_>>()?;
        for (subject, written) in subjects.iter().zip(&load.on) {
            if let Subject::Place(place) = subject
                && load.form.turns
                && self.is_particle(place.frame)
            {
                self.diagnostics.error(written.region(), messages::particle_turns(&place.text));
                return None;
            }
        }
        for (subject, written) in subjects.iter().zip(&load.on) {
            let message = match subject {
                Subject::Rotor(Rotor::Body(body)) | Subject::Body(body) if self.has_mean_direction(*body) => {
                    self.torque_on_mean(*body)
                }
                Subject::Place(place) if place.of_mean => self.origin_of_mean(place),
                Subject::Place(place) if load.form.turns && self.bends(place.frame) => {
                    messages::bushing_on_beam(&place.text)
                }
                _ => continue,
            };
            self.diagnostics.error(written.region(), message);
            return None;
        }
        for (which, pair) in subjects.windows(2).enumerate() {
            if let [Subject::Place(first), Subject::Place(second)] = pair
                && first.frame == second.frame
            {
                let region = load.on[which].region().to(load.on[which + 1].region());
                self.diagnostics.error(region, messages::spring_in_one_body(&first.text, &second.text));
                return None;
            }
        }
        Some(subjects)
    }

    pub(super) fn subject(&mut self, written: &'d SubjectTerm, acts: Acts) -> Option<Subject> {
        match (written, acts) {
            (SubjectTerm::Place(place), Acts::Place) => self.place(place).map(Subject::Place),
            (SubjectTerm::Name(label), Acts::Rotor) => self.rotor(label).map(Subject::Rotor),
            (SubjectTerm::Name(label), Acts::Travel) => self.slide(label).map(Subject::Travel),
            (SubjectTerm::Name(label), Acts::Bearing) => self.bearing(label),
            (SubjectTerm::Name(label), Acts::Joint) => match self.names.part(&label.text) {
                Some(Part::Joint(index)) => Some(Subject::Joint(JointId(index))),
                _ => None,
            },
            (SubjectTerm::Name(label), Acts::Body) => self.turning_body(label).map(Subject::Body),
            (SubjectTerm::Place(syntax::PlaceTerm::Named(path)), Acts::Toothing) => {
                self.toothing_of(path).map(Subject::Toothing)
            }
            (SubjectTerm::Expression(term), Acts::Expression) => {
                let typed = self.value(term, Use::ALONG)?;
                let mut moves = false;
                typed.expr.quantities(&mut |_| moves = true);
                if !moves {
                    self.diagnostics.error(term.region, messages::along_what_stands());
                    return None;
                }
                Some(Subject::Expression(typed.expr, typed.dimension))
            }
            (SubjectTerm::Expression(term), Acts::Way) => {
                self.way(term).or_else(|| self.subject(written, Acts::Expression))
            }
            // The parser hands over names where names are meant.
            (
                SubjectTerm::Place(_),
                Acts::Rotor
                | Acts::Travel
                | Acts::Bearing
                | Acts::Joint
                | Acts::Body
                | Acts::Toothing
                | Acts::Expression
                | Acts::Way,
            )
            | (SubjectTerm::Name(_), Acts::Place | Acts::Toothing | Acts::Expression | Acts::Way)
            | (
                SubjectTerm::Expression(_),
                Acts::Place
                | Acts::Rotor
                | Acts::Travel
                | Acts::Bearing
                | Acts::Joint
                | Acts::Body
                | Acts::Toothing,
            ) => None,
        }
    }

    /// `along`: what the way measures that it acts along, where there is one.
    fn load_argument(
        &mut self,
        load: &'d syntax::Load,
        argument: &Argument,
        along: Option<Dimension>,
    ) -> Option<Vec<Expr>> {
        match argument.value {
            Value::Direction => match load.named.tuple(argument.name) {
                Some(tuple) => self.direction(tuple, argument.name).map(|it| normalised(it).to_vec()),
                None => Some(Vec::new()),
            },
            Value::Scalar(dimension) | Value::Moving(dimension) => match load.named.entry(argument.name) {
                Some(entry) => Some(vec![self.entry(entry, dimension, Use::COEFFICIENT, argument.name)?]),
                None => Some(vec![Expr::Number(0.0)]),
            },
            Value::Varying(dimension) => match load.named.entry(argument.name) {
                Some(entry) => Some(vec![self.entry(entry, dimension, Use::VARYING, argument.name)?]),
                None => Some(vec![Expr::Number(0.0)]),
            },
            // It follows from another, which is read before it.
            Value::RateOf { varying, .. } => {
                let of = load.form.call.named.iter().find(|other| other.name == varying)?.dimension()?;
                match load.named.entry(argument.name) {
                    Some(entry) => {
                        Some(vec![self.entry(entry, of.over(Dimension::TIME), Use::LOAD, argument.name)?])
                    }
                    None => Some(Vec::new()),
                }
            }
            Value::Diagonal(dimension) => self.diagonal(&load.named, argument.name, dimension),
            Value::Way => {
                let entry = load.named.entry(argument.name)?;
                Some(vec![self.entry(entry, along?, Use::COEFFICIENT, argument.name)?])
            }
            Value::Stiffness => {
                let (entry, way) = (load.named.entry(argument.name)?, along?);
                let dimension = Dimension::TORQUE.over(way).over(way);
                Some(vec![self.entry(entry, dimension, Use::COEFFICIENT, argument.name)?])
            }
            Value::Law(dimension) => match load.named.entry(argument.name) {
                Some(entry) => Some(vec![self.entry(entry, dimension, Use::LOAD, argument.name)?]),
                None => Some(vec![Expr::Number(0.0)]),
            },
            Value::Along { effort, way, time } => match load.named.entry(argument.name) {
                Some(entry) => {
                    let dimension = sliding(along?, effort, way, time);
                    Some(vec![self.entry(entry, dimension, Use::COEFFICIENT, argument.name)?])
                }
                None => Some(vec![Expr::Number(0.0)]),
            },
            Value::Exponent => self.exponent(load.named.entry(argument.name)?, argument.name),
            Value::Backbone => self.backbone(load.named.entry(argument.name)?, along?),
            // It says what the load is, and is no value: read elsewhere.
            Value::Word => Some(Vec::new()),
            // Of laws of contacts, which are read elsewhere, and of joints.
            Value::OfGap | Value::Outline | Value::OfParameter(_) => None,
            Value::TeethStiffness => self.teeth_stiffness(load, argument.name),
            Value::TeethDamping => self.teeth_damping(load, argument.name),
        }
    }

    /// Those that are not written are derivatives.
    fn rates_of_arguments(&mut self, load: &'d syntax::Load, values: &mut [Vec<Expr>]) -> Option<()> {
        let arguments = load.form.call.named;
        for (which, argument) in arguments.iter().enumerate() {
            let Value::RateOf { varying, for_sake_of } = argument.value else { continue };
            let of = arguments.iter().position(|other| other.name == varying)?;
            let [value] = &values[of][..] else { continue };
            if !values[which].is_empty() {
                continue;
            }
            let unknown = value.is_given();
            let rate = if unknown || !value.moves() {
                Expr::Number(0.0)
            } else {
                Expr::Rate(Box::new(value.clone()))
            };
            if let (true, Some(asks)) = (unknown, load.named.entry(for_sake_of)) {
                let message = messages::rate_not_known(varying, argument.name, for_sake_of);
                self.diagnostics.error(asks.value.region, message);
                return None;
            }
            values[which] = vec![rate];
        }
        Some(())
    }

    /// One value for each axis: as written, or the same for all.
    pub(super) fn diagonal(
        &mut self,
        named: &'d Named,
        name: &str,
        dimension: Dimension,
    ) -> Option<Vec<Expr>> {
        let axes = self.definition.space.dimensions();
        match (named.tuple(name), named.entry(name)) {
            (Some(tuple), _) => {
                let values = self.vector(tuple, dimension, Use::COEFFICIENT, name)?;
                Some(values.into_iter().take(axes).collect())
            }
            (None, Some(entry)) => Some(vec![self.entry(entry, dimension, Use::COEFFICIENT, name)?; axes]),
            (None, None) => Some(vec![Expr::Number(0.0); axes]),
        }
    }

    /// Of a load on these subjects; `None` if there was an error in them.
    fn law(&mut self, load: &'d syntax::Load, on: Option<&[Subject]>) -> Option<Vec<Expr>> {
        let dimension = match (load.form.law, on) {
            (Law::None, _) => return Some(Vec::new()),
            (Law::Value(dimension) | Law::Components(dimension), _) => dimension,
            (Law::Conjugate, Some([Subject::Expression(_, along)])) => Dimension::TORQUE.over(*along),
            // What it acts along has been complained of.
            (Law::Conjugate, _) => return None,
        };
        let what = messages::quoted(&load.name.text);
        match &load.law {
            LawTerm::None => Some(Vec::new()),
            LawTerm::Value(value) => {
                let value = self.value(value, Use::LOAD)?;
                Some(vec![self.expect_dimension(value, dimension, &what)?])
            }
            LawTerm::Components(components) => {
                Some(self.vector(components, dimension, Use::LOAD, &what)?.to_vec())
            }
        }
    }

    /// Components of any one dimension, of which only the ratios matter; not all zero.
    pub fn direction(&mut self, tuple: &'d Tuple, what: &str) -> Option<Vector> {
        let direction = match &tuple.unit {
            Some(unit) => self.vector(tuple, unit.unit.dimension, Use::DIRECTION, what)?,
            None => {
                let values: Vec<_> =
                    tuple.values.iter().map(|value| self.value(value, Use::DIRECTION)).collect();
                let values: Option<Vec<_>> = values.into_iter().collect();
                let values = values?;
                for value in &values[1..] {
                    self.same(&values[0], value, &format!("the components of the {what}"))?;
                }
                let components = values.into_iter().map(|value| self.in_range(value.expr, value.region));
                padded(components.collect::<Option<_>>()?)
            }
        };
        if direction.iter().all(|component| matches!(component, Expr::Number(0.0))) {
            self.diagnostics.error(tuple.region, messages::zero_direction(what, self.definition.space));
            return None;
        }
        Some(direction)
    }
}

/// What the way measures that a load acts along.
fn along(on: Option<&[Subject]>) -> Option<Dimension> {
    match on {
        Some([Subject::Expression(_, along) | Subject::Bearing(_, along)]) => Some(*along),
        Some([Subject::Touches(_)]) => Some(Dimension::LENGTH),
        _ => None,
    }
}

/// Of what slides along a way that measures this: effort, way and time in these powers.
fn sliding(along: Dimension, effort: bool, way: i32, time: i32) -> Dimension {
    let powers = |dimension: Dimension, times: i32| {
        (0..times.abs()).fold(Dimension::ONE, |product, _| match times > 0 {
            true => product.times(dimension),
            false => product.over(dimension),
        })
    };
    let of = if effort { Dimension::TORQUE.over(along) } else { Dimension::ONE };
    of.times(powers(along, way)).times(powers(Dimension::TIME, time))
}

/// A value along the direction among the arguments.
fn directed(load: &syntax::Load, values: &[Vec<Expr>], value: &Expr) -> Vec<Expr> {
    let arguments = load.form.call.named.iter().zip(values);
    let directions = arguments.filter(|(argument, _)| argument.is_direction()).flat_map(|(_, it)| it);
    directions.map(|component| fold::binary(Function2::Mul, value.clone(), component.clone())).collect()
}

/// x/|x|.
pub(super) fn normalised(vector: Vector) -> Vector {
    if let [Expr::Number(x), Expr::Number(y), Expr::Number(z)] = &vector {
        let length = libm::hypot(libm::hypot(*x, *y), *z);
        return [x, y, z].map(|component| Expr::Number(component / length));
    }
    let square = |value: &Expr| fold::binary(Function2::Mul, value.clone(), value.clone());
    let sum = |a, b| fold::binary(Function2::Add, a, b);
    let length = sum(sum(square(&vector[0]), square(&vector[1])), square(&vector[2]));
    let length = fold::unary(Function1::Sqrt, length);
    vector.map(|component| fold::binary(Function2::Div, component, length.clone()))
}
