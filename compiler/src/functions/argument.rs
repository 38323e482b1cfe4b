//! What functions are given: names, shapes and the symbols they stand for in the equations.

use super::shape::Shape;
use crate::complete::Complete;
use crate::symbolic::Node;
use std::slice::from_ref;

/// An argument, in the order of [`ARGUMENTS`], which is that in which a function reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    Time,
    Q,
    V,
    /// Internal states.
    Z,
    /// Gates that are held over a step.
    Gates,
    /// The state as a whole, of which q, v, z and the gates are parts.
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
    pub symbols: fn(&Complete) -> &[Node],
}

const fn given(
    argument: Argument,
    name: &'static str,
    shape: Shape,
    symbols: fn(&Complete) -> &[Node],
) -> Given {
    Given { argument, name, shape, symbols }
}

/// All arguments.
pub static ARGUMENTS: [Given; 20] = [
    given(Argument::Time, "time", Shape::Scalar, |c| from_ref(&c.equations.symbols.time)),
    given(Argument::Q, "q", Shape::Positions, |c| &c.equations.symbols.q),
    given(Argument::V, "v", Shape::Velocities, |c| &c.equations.symbols.v),
    given(Argument::Z, "z", Shape::Internal, |c| &c.equations.symbols.internal),
    given(Argument::Gates, "gates", Shape::Gates, |c| &c.equations.symbols.gates),
    // Its entries are those of q, v, z and the gates.
    given(Argument::State, "state", Shape::State, |_| &[]),
    given(Argument::Inputs, "u", Shape::Inputs, |c| &c.equations.symbols.inputs),
    // 2 α and β² of Baumgarte's terms, 1/s and 1/s².
    given(Argument::TwoAlpha, "two_alpha", Shape::Scalar, |c| from_ref(&c.equations.symbols.two_alpha)),
    given(Argument::BetaSquared, "beta_squared", Shape::Scalar, |c| {
        from_ref(&c.equations.symbols.beta_squared)
    }),
    given(Argument::Acceleration, "a", Shape::Velocities, |c| &c.equations.symbols.acceleration),
    given(Argument::Lambda, "lambda", Shape::Rows, |c| &c.equations.symbols.lambda),
    // What is asked of each condition of the start.
    given(Argument::Target, "target", Shape::Conditions, |c| &c.conditions.targets),
    // c of K(c).
    given(Argument::Compliance, "compliance", Shape::Scalar, |c| from_ref(&c.equations.symbols.compliance)),
    // The right-hand sides of K(c), and what is kept of its factorisation.
    given(Argument::GivenForces, "forces", Shape::Velocities, |c| c.further.given_forces()),
    given(Argument::GivenRows, "rows", Shape::Rows, |c| c.further.given_rows()),
    given(Argument::Store, "store", Shape::Store, |c| c.further.kept()),
    // What is kept of D = L U.
    given(Argument::Lu, "lu", Shape::Lu, |c| c.further.lu()),
    given(Argument::Parameters, "parameters", Shape::Parameters, |c| &c.equations.symbols.parameters),
    given(Argument::Phases, "phases", Shape::Phases, |c| &c.equations.symbols.phases),
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
    /// Its entry of the table.
    pub fn given(self) -> &'static Given {
        &ARGUMENTS[self as usize]
    }

    /// Its name in every function that has it.
    pub fn name(self) -> &'static str {
        self.given().name
    }

    /// The arguments that it brings along, as the state brings q and v.
    pub fn parts(self) -> &'static [Argument] {
        match self {
            Argument::State => &[Argument::Q, Argument::V, Argument::Z, Argument::Gates],
            _ => &[],
        }
    }

    /// Its entries in the equations.
    pub fn symbols(self, complete: &Complete) -> &[Node] {
        (self.given().symbols)(complete)
    }
}
