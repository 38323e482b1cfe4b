//! Vectors in expressions: places, their velocities, and what is made of these, as arguments of `dot`, `cross` and `norm`. No value
//! is a vector: each of the three gives a number, but for the cross product in space, which stands in one of the others.

use super::fold;
use super::lower::{Lowering, Use};
use super::names::Part;
use super::values::Typed;
use super::{Coordinate, Expr, Function1, Function2, Place, Quantity};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{Operator, Path, PlaceTerm, Space, Term, TermKind};
use crate::units::Dimension;

/// Components along the axes of the world.
struct TypedVector {
    components: Vec<Expr>,
    dimension: Dimension,
    region: Region,
}

impl TypedVector {
    /// As the first of its components stands in sums.
    fn typed(&self) -> Typed {
        Typed { expr: Expr::Number(1.0), dimension: self.dimension, zero: false, region: self.region }
    }

    fn map(self, f: impl Fn(Expr) -> Expr) -> Self {
        Self { components: self.components.into_iter().map(f).collect(), ..self }
    }
}

impl Lowering<'_> {
    /// `dot(a, b)`, `cross(a, b)` of the plane, `norm(a)`.
    pub(super) fn of_vectors(
        &mut self,
        name: &str,
        arguments: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        if name == "cross" && self.definition.space == Space::Spatial {
            self.diagnostics.error(region, messages::cross_is_a_vector());
            return None;
        }
        let vectors: Vec<_> = arguments.iter().map(|term| self.vector_of(term, name, usage)).collect();
        let vectors: Vec<TypedVector> = vectors.into_iter().collect::<Option<_>>()?;
        let (a, b) = (&vectors[0], &vectors[vectors.len() - 1]);
        let (expr, dimension) = match name {
            "norm" => {
                let squares = a.components.iter().map(|x| fold::power(x.clone(), 2.0));
                (fold::unary(Function1::Sqrt, sum(squares)), a.dimension)
            }
            "dot" => {
                let products = a.components.iter().zip(&b.components).map(|(x, y)| times(x, y));
                (sum(products), a.dimension.times(b.dimension))
            }
            _ => (crossed(a, b, 0, 1), a.dimension.times(b.dimension)),
        };
        let expr = self.finite(expr, region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// Whether a term can only be a vector.
    fn is_vector(&self, term: &Term) -> bool {
        match &term.kind {
            TermKind::Ground(_) => true,
            TermKind::Name(path) => match (self.names.part(&path.parts[0].text), &path.parts[1..]) {
                (Some(Part::Marker(_)), []) => self.names.value(&path.text).is_none(),
                (Some(Part::Marker(_)), [last]) | (Some(Part::Body(_)), [_, last]) => last.text == "velocity",
                (Some(Part::Body(_)), [point]) => !["angle", "rate", "orientation"].contains(&&*point.text),
                _ => false,
            },
            TermKind::Operation(operator, operands) => match operator {
                Operator::Divide => self.is_vector(&operands[0]),
                Operator::Negate | Operator::Add | Operator::Subtract | Operator::Multiply => {
                    operands.iter().any(|operand| self.is_vector(operand))
                }
                _ => false,
            },
            TermKind::Call(function, _) => {
                function.text == "cross" && self.definition.space == Space::Spatial
            }
            TermKind::Number { .. } | TermKind::Measured(..) => false,
        }
    }

    /// An argument of `function`, or a part of one.
    fn vector_of(&mut self, term: &Term, function: &str, usage: Use) -> Option<TypedVector> {
        let region = term.region;
        match &term.kind {
            TermKind::Ground(ground) => {
                self.permitted_place("a place", region, usage)?;
                let place = self.place(&PlaceTerm::Ground(ground.clone()))?;
                Some(self.at(&place, region, false))
            }
            TermKind::Name(path) if self.is_vector(term) => self.place_or_velocity(path, usage),
            TermKind::Operation(Operator::Negate, operands) => {
                let vector = self.vector_of(&operands[0], function, usage)?;
                Some(vector.map(|x| fold::unary(Function1::Neg, x)))
            }
            TermKind::Operation(operator @ (Operator::Add | Operator::Subtract), operands) => {
                let [a, b] = [0, 1].map(|k| self.vector_of(&operands[k], function, usage));
                let (a, b) = (a?, b?);
                let (operation, what) = match operator {
                    Operator::Add => (Function2::Add, "the summands"),
                    _ => (Function2::Sub, "the two sides of `-`"),
                };
                let dimension = self.same(&a.typed(), &b.typed(), what)?;
                let both = a.components.into_iter().zip(b.components);
                let components = both.map(|(x, y)| fold::binary(operation, x, y)).collect();
                Some(TypedVector { components, dimension, region })
            }
            TermKind::Operation(operator @ (Operator::Multiply | Operator::Divide), operands)
                if self.is_vector(term) =>
            {
                self.scaled_vector(*operator, operands, function, region, usage)
            }
            TermKind::Call(product, arguments) if self.is_vector(term) => {
                if arguments.len() != 2 {
                    self.diagnostics.error(region, messages::arguments(&product.text, &[2], arguments.len()));
                    return None;
                }
                let [a, b] = [0, 1].map(|k| self.vector_of(&arguments[k], &product.text, usage));
                let (a, b) = (a?, b?);
                let components = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| crossed(&a, &b, i, j)).to_vec();
                Some(TypedVector { components, dimension: a.dimension.times(b.dimension), region })
            }
            TermKind::Number { .. }
            | TermKind::Name(_)
            | TermKind::Operation(..)
            | TermKind::Call(..)
            | TermKind::Measured(..) => {
                self.diagnostics.error(region, messages::no_vector(function));
                None
            }
        }
    }

    /// A number times a vector, or a vector over a number.
    fn scaled_vector(
        &mut self,
        operator: Operator,
        operands: &[Term],
        function: &str,
        region: Region,
        usage: Use,
    ) -> Option<TypedVector> {
        let (one, other) = (&operands[0], &operands[1]);
        let (vector, factor) = if self.is_vector(one) { (one, other) } else { (other, one) };
        if self.is_vector(factor) {
            self.diagnostics.error(region, messages::product_of_vectors());
            return None;
        }
        let (vector, factor) = (self.vector_of(vector, function, usage), self.value(factor, usage));
        let (vector, factor) = (vector?, factor?);
        let (operation, dimension) = match operator {
            Operator::Multiply => (Function2::Mul, vector.dimension.times(factor.dimension)),
            _ => (Function2::Div, vector.dimension.over(factor.dimension)),
        };
        if operation == Function2::Div && factor.expr == Expr::Number(0.0) {
            self.diagnostics.error(region, messages::division_by_zero());
            return None;
        }
        let scaled = vector.map(|x| fold::binary(operation, x, factor.expr.clone()));
        Some(TypedVector { dimension, region, ..scaled })
    }

    /// `arm.end`, `arm.end.velocity`, a marker of the ground.
    fn place_or_velocity(&mut self, path: &Path, usage: Use) -> Option<TypedVector> {
        let moves = path.parts.len() > 1 && path.parts.last().is_some_and(|last| last.text == "velocity");
        let named = match path.text.strip_suffix(".velocity").filter(|_| moves) {
            Some(text) => Path {
                text: text.to_string(),
                parts: path.parts[..path.parts.len() - 1].to_vec(),
                region: path.region,
            },
            None => path.clone(),
        };
        if moves {
            self.permit(usage.velocities, path, "a velocity", usage)?;
        } else {
            self.permitted_place(&path.text, path.region, usage)?;
        }
        let place = self.place(&PlaceTerm::Named(named))?;
        Some(self.at(&place, path.region, moves))
    }

    fn permitted_place(&mut self, text: &str, region: Region, usage: Use) -> Option<()> {
        if !usage.positions {
            let message = messages::not_permitted(text, "a position", usage.what, &usage.permitted());
            self.diagnostics.error(region, message);
        }
        usage.positions.then_some(())
    }

    /// The components of a place or of its velocity.
    fn at(&self, place: &Place, region: Region, moves: bool) -> TypedVector {
        let component = |axis| {
            let coordinate = Coordinate::Position(Box::new(place.clone()), axis);
            Expr::Quantity(if moves { Quantity::Rate(coordinate) } else { Quantity::Coordinate(coordinate) })
        };
        let dimension = if moves { Dimension::SPEED } else { Dimension::LENGTH };
        let components = (0..self.definition.space.dimensions()).map(component).collect();
        TypedVector { components, dimension, region }
    }
}

/// aᵢ bⱼ − aⱼ bᵢ.
fn crossed(a: &TypedVector, b: &TypedVector, i: usize, j: usize) -> Expr {
    let product = |i: usize, j: usize| times(&a.components[i], &b.components[j]);
    fold::binary(Function2::Sub, product(i, j), product(j, i))
}

fn times(a: &Expr, b: &Expr) -> Expr {
    fold::binary(Function2::Mul, a.clone(), b.clone())
}

fn sum(terms: impl Iterator<Item = Expr>) -> Expr {
    let sum = terms.reduce(|sum, term| fold::binary(Function2::Add, sum, term));
    sum.unwrap_or(Expr::Number(0.0))
}
