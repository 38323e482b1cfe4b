//! What functions are given: names, shapes and the symbols they stand for in the equations.

use super::shape::Shape;
use crate::equations::coordinates::Symbols;
use crate::symbolic::Node;
use std::slice::from_ref;

/// An argument, in the order of [`ARGUMENTS`], which is that in which a function reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    Time,
    Q,
    V,
    /// The state as a whole, of which q and v are parts.
    State,
    Inputs,
    TwoAlpha,
    BetaSquared,
    Acceleration,
    Lambda,
    Target,
    Compliance,
    GivenForces,
    GivenRows,
    Store,
    Lu,
    Parameters,
    Phases,
    Constants,
}

/// What is known of an argument.
pub struct Given {
    pub argument: Argument,
    pub name: &'static str,
    pub shape: Shape,
    /// Its entries in the equations. The constants of the prepared model are no symbols but expressions.
    pub symbols: fn(&Symbols) -> &[Node],
}

const fn given(
    argument: Argument,
    name: &'static str,
    shape: Shape,
    symbols: fn(&Symbols) -> &[Node],
) -> Given {
    Given { argument, name, shape, symbols }
}

/// All arguments.
pub static ARGUMENTS: [Given; 18] = [
    given(Argument::Time, "time", Shape::Scalar, |s| from_ref(&s.time)),
    given(Argument::Q, "q", Shape::Positions, |s| &s.q),
    given(Argument::V, "v", Shape::Velocities, |s| &s.v),
    // Its entries are those of q and v.
    given(Argument::State, "state", Shape::State, |_| &[]),
    given(Argument::Inputs, "u", Shape::Inputs, |s| &s.inputs),
    // 2 α and β² of Baumgarte's terms, 1/s and 1/s².
    given(Argument::TwoAlpha, "two_alpha", Shape::Scalar, |s| from_ref(&s.two_alpha)),
    given(Argument::BetaSquared, "beta_squared", Shape::Scalar, |s| from_ref(&s.beta_squared)),
    given(Argument::Acceleration, "a", Shape::Velocities, |s| &s.acceleration),
    given(Argument::Lambda, "lambda", Shape::Rows, |s| &s.lambda),
    // What is asked of each condition of the start.
    given(Argument::Target, "target", Shape::Conditions, |s| &s.targets),
    // c of K(c).
    given(Argument::Compliance, "compliance", Shape::Scalar, |s| from_ref(&s.compliance)),
    // The right-hand sides of K(c), and what is kept of its factorisation.
    given(Argument::GivenForces, "forces", Shape::Velocities, |s| &s.given_forces),
    given(Argument::GivenRows, "rows", Shape::Rows, |s| &s.given_rows),
    given(Argument::Store, "store", Shape::Store, |s| &s.kept),
    // What is kept of D = L U.
    given(Argument::Lu, "lu", Shape::Lu, |s| &s.lu),
    given(Argument::Parameters, "parameters", Shape::Parameters, |s| &s.parameters),
    given(Argument::Phases, "phases", Shape::Phases, |s| &s.phases),
    given(Argument::Constants, "constants", Shape::Constants, |_| &[]),
];

const _: () = {
    let mut index = 0;
    while index < ARGUMENTS.len() {
        assert!(ARGUMENTS[index].argument as usize == index, "the table and the arguments are in one order");
        index += 1;
    }
};

impl Argument {
    pub fn given(self) -> &'static Given {
        &ARGUMENTS[self as usize]
    }

    pub fn name(self) -> &'static str {
        self.given().name
    }

    /// Its entries in the equations.
    pub fn symbols(self, symbols: &Symbols) -> &[Node] {
        (self.given().symbols)(symbols)
    }
}
