//! Derivatives: of every model those of the equations against differences, by the interpreter of their programs.

use crate::registry::{Model, Random, for_each, vector};
use linkwright::{Vector, retract};
use linkwright_compiler::equations::Jet;
use linkwright_compiler::equations::tangent::Matrix;
use linkwright_compiler::schedule::{self, Function, Inputs};
use linkwright_compiler::symbolic::{Node, evaluate_reachable};
use linkwright_compiler::{Compiled, compile};

const POINTS: usize = 2;

for_each!(tangents_are_the_derivatives);

/// The definition with `emit = (tangent)`, through all stages but the last.
pub fn with_tangent(source: &str) -> Compiled {
    let tokens = asking_for_tangent(source).parse().expect("the source was tokens");
    compile(tokens, None).unwrap_or_else(|errors| panic!("{errors}"))
}

fn asking_for_tangent(source: &str) -> String {
    match source.find("options {") {
        Some(at) => format!("{} emit = (tangent); {}", &source[..at + 9], &source[at + 9..]),
        None => {
            let end = source.rfind('}').expect("a definition ends with a brace");
            format!("{} options {{ emit = (tangent); }} }}", &source[..end])
        }
    }
}

fn tangents_are_the_derivatives<M: Model>() {
    let model = M::standard();
    let compiled = with_tangent(M::source());
    let mut random = Random::new(40);
    let moved = |q: &[f64], delta: &[f64]| {
        let from: M::Q = vector(q);
        let mut to = from;
        retract(model.layout(), &from, &vector::<M::V>(delta), &mut to);
        to.as_slice().to_vec()
    };
    let checked = Checked::of(&compiled, &moved);
    for _ in 0..POINTS {
        checked.at(&random.point(&compiled));
    }
}

/// What a derivative is taken by.
#[derive(Clone, Copy, Debug, PartialEq)]
enum By {
    Position(usize),
    Velocity(usize),
    Input(usize),
    Lambda(usize),
    Internal(usize),
    Acceleration(usize),
    Parameter(usize),
}

/// What is differentiated.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Of {
    Residual,
    /// The same without friction by reactions, and that with the other sign.
    WithoutFriction,
    Friction,
    Accelerations,
    Rates,
    Constraints,
    Outputs,
    InternalRates,
    StartInternal,
    Coordinates,
}

/// q and δ → q ⊕ δ.
type Moved<'a> = dyn Fn(&[f64], &[f64]) -> Vec<f64> + 'a;

struct Checked<'a> {
    compiled: &'a Compiled,
    /// q ⊕ δ.
    moved: &'a Moved<'a>,
    /// What the outputs and the rates of internal states need, operands first.
    results: Vec<Node>,
}

impl<'a> Checked<'a> {
    fn of(compiled: &'a Compiled, moved: &'a Moved<'a>) -> Self {
        let equations = &compiled.complete.equations;
        let results = equations.outputs.iter().chain(&equations.internal_rates).copied();
        let results = equations.graph.read().reachable(results);
        Checked { compiled, moved, results }
    }

    fn at(&self, point: &Inputs) {
        let tangents = self.compiled.complete.tangents.as_ref().expect("they are asked for");
        let e = &self.compiled.complete.equations;
        let (n, m, inputs) = (e.layout.velocities(), e.rows.len(), e.symbols.inputs.len());
        assert_eq!(
            tangents.states.len(),
            n - (m - e.idle.len()),
            "{}: states",
            self.compiled.mechanism.name.text
        );
        let range = |count: usize, by: fn(usize) -> By| (0..count).map(by).collect::<Vec<_>>();
        let positions = range(n, By::Position);
        let state = [positions.clone(), range(n, By::Velocity)].concat();
        let internal = range(e.symbols.internal.len(), By::Internal);
        let all = [
            state.clone(),
            range(inputs, By::Input),
            range(m, By::Lambda),
            internal.clone(),
            range(n, By::Acceleration),
        ]
        .concat();
        let parameters = range(e.symbols.parameters.len(), By::Parameter);

        let values = self.run(Function::Tangent, point);
        let (stiffness, damping) = values.split_at(stored(&tangents.stiffness));
        self.compare(point, &[Of::Residual], &positions, &tangents.stiffness, stiffness);
        self.compare(point, &[Of::Residual], &state[n..], &tangents.damping, damping);
        let values = self.run(Function::RowTangent, point);
        let (stiffness, damping) = values.split_at(stored(&tangents.row_stiffness));
        self.compare(point, &[Of::Accelerations], &positions, &tangents.row_stiffness, stiffness);
        self.compare(point, &[Of::Accelerations], &state[n..], &tangents.row_damping, damping);
        let designed = [
            Of::Residual,
            Of::Accelerations,
            Of::Rates,
            Of::Constraints,
            Of::Outputs,
            Of::InternalRates,
            Of::StartInternal,
        ];
        let rest: [(Function, &[Of], &[By], &Matrix); 7] = [
            (Function::RateTangent, &[Of::Rates], &positions, &tangents.rate),
            (Function::InputTangent, &[Of::WithoutFriction], &all[2 * n..2 * n + inputs], &tangents.input),
            (Function::ParameterTangent, &designed, &parameters, &tangents.parameter),
            (Function::InternalTangent, &[Of::WithoutFriction], &internal, &tangents.internal),
            (Function::OutputTangent, &[Of::Outputs], &all, &tangents.output),
            (Function::InternalRateTangent, &[Of::InternalRates], &all, &tangents.internal_rate),
            (Function::CoordinateTangent, &[Of::Coordinates], &state, &tangents.coordinate),
        ];
        for (function, of, by, matrix) in rest {
            self.compare(point, of, by, matrix, &self.run(function, point));
        }
        if !e.friction.is_none() {
            let by = &all[2 * n..];
            let values = self.run(Function::FrictionTangent, point);
            self.compare(point, &[Of::Friction], by, &tangents.friction, &values);
        }
    }

    /// All entries of a matrix, those that are not stored too, against central differences extrapolated to fourth order.
    fn compare(&self, point: &Inputs, of: &[Of], by: &[By], matrix: &Matrix, values: &[f64]) {
        let name = &self.compiled.mechanism.name.text;
        let mut dense = vec![vec![0.0; by.len()]; matrix.len()];
        let places =
            matrix.iter().enumerate().flat_map(|(row, r)| r.keys().map(move |column| (row, *column)));
        for ((row, column), value) in places.zip(values) {
            dense[row][column] = *value;
        }
        let value = |by: By, h: f64| -> Vec<f64> {
            let moved = self.along(point, by, h);
            of.iter().flat_map(|of| self.value(*of, &moved)).collect()
        };
        for (column, by) in by.iter().enumerate() {
            // Some parameters are thousandths, some are millions; teeth make waves of many to a turn.
            let size = match by {
                By::Parameter(k) if point.parameters[*k] != 0.0 => point.parameters[*k].abs(),
                By::Internal(k) => self.compiled.mechanism.states[*k].scale.unwrap_or(1.0),
                By::Position(_) if !self.compiled.mechanism.pairs.is_empty() => 0.05,
                _ => 1.0,
            };
            let slope = |h: f64| -> Vec<f64> {
                let h = h * size;
                let (ahead, behind) = (value(*by, h), value(*by, -h));
                ahead.iter().zip(behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect()
            };
            let (coarse, fine) = (slope(1e-3), slope(5e-4));
            // What is as large as the forces of stiff teeth rounds away small slopes.
            let rounded: Vec<f64> =
                value(*by, 0.0).iter().map(|value| 1e-15 * value.abs() / (5e-4 * size)).collect();
            assert_eq!(coarse.len(), matrix.len(), "{name}: {of:?}");
            for (row, entries) in dense.iter().enumerate() {
                let expected = (4.0 * fine[row] - coarse[row]) / 3.0;
                let found = entries[column];
                let largest = entries.iter().fold(1.0, |largest, entry| f64::max(largest, entry.abs()));
                let same = (found - expected).abs() <= 2e-7 * largest + rounded[row];
                assert!(same, "{name}: ∂{of:?}[{row}]/∂{by:?} is {found}, by differences {expected}");
            }
        }
    }

    fn along(&self, point: &Inputs, by: By, h: f64) -> Inputs {
        let mut moved = point.clone();
        match by {
            By::Position(k) => {
                let mut delta = vec![0.0; point.v.len()];
                delta[k] = h;
                moved.q = (self.moved)(&point.q, &delta);
            }
            By::Velocity(k) => moved.v[k] += h,
            By::Input(k) => moved.inputs[k] += h,
            By::Lambda(k) => moved.lambda[k] += h,
            By::Internal(k) => moved.internal[k] += h,
            By::Acceleration(k) => moved.acceleration[k] += h,
            By::Parameter(k) => moved.parameters[k] += h,
        }
        moved.prepared = Vec::new();
        moved
    }

    fn run(&self, function: Function, point: &Inputs) -> Vec<f64> {
        let mut point = point.clone();
        let programs = &self.compiled.programs;
        point.prepared = schedule::run(programs.get(Function::Prepare), &point);
        schedule::run(programs.get(function), &point)
    }

    fn value(&self, of: Of, point: &Inputs) -> Vec<f64> {
        let e = &self.compiled.complete.equations;
        let rows: Vec<&Jet> = e.rows.iter().map(|row| &row.jet).collect();
        let of_rows = |constant: Function, sign: f64, x: &[f64]| {
            let jacobian = self.run(Function::ConstraintJacobian, point);
            let constant = self.run(constant, point).into_iter().map(|entry| sign * entry).collect();
            add_product(constant, &rows, &jacobian, x)
        };
        match of {
            Of::Residual | Of::WithoutFriction => {
                let mut residual = self.run(Function::InverseDynamics, point);
                let jacobian = self.run(Function::ConstraintJacobian, point);
                for ((row, column), entry) in places(&rows).into_iter().zip(jacobian) {
                    residual[column] += entry * point.lambda[row];
                }
                // Of a tree inverse dynamics has friction.
                let friction = self.friction(point);
                let sign = match (of, e.rows.is_empty()) {
                    (Of::Residual, false) => -1.0,
                    (Of::WithoutFriction, true) => 1.0,
                    _ => 0.0,
                };
                residual
                    .iter_mut()
                    .zip(friction)
                    .for_each(|(residual, friction)| *residual += sign * friction);
                residual
            }
            Of::Friction => self.friction(point).into_iter().map(|force| -force).collect(),
            Of::Accelerations => of_rows(Function::Gamma, -1.0, &point.acceleration),
            Of::Rates => of_rows(Function::Nu, -1.0, &point.v),
            Of::Constraints => self.run(Function::Constraints, point),
            Of::Outputs => self.on_graph(&e.outputs, point),
            Of::InternalRates => self.on_graph(&e.internal_rates, point),
            Of::StartInternal => self.run(Function::StartInternal, point),
            Of::Coordinates => {
                let states = &self.compiled.complete.tangents.as_ref().expect("they are asked for").states;
                let all: Vec<&Jet> =
                    self.compiled.complete.conditions.rows.iter().map(|condition| &condition.jet).collect();
                let jacobian = self.run(Function::ConditionJacobian, point);
                let of = |constant: Function, x: &[f64]| {
                    add_product(self.run(constant, point), &all, &jacobian, x)
                };
                let rates = of(Function::ConditionDrift, &point.v);
                let second = of(Function::ConditionBias, &point.acceleration);
                let chosen = |values: Vec<f64>| states.iter().map(|at| values[*at]).collect::<Vec<_>>();
                [chosen(rates), chosen(second)].concat()
            }
        }
    }
}

impl Checked<'_> {
    /// Q_f.
    fn friction(&self, point: &Inputs) -> Vec<f64> {
        match self.compiled.complete.equations.friction.is_none() {
            true => vec![0.0; point.v.len()],
            false => self.run(Function::FrictionForces, point),
        }
    }

    /// Values of results, with v̇ and λ as given.
    fn on_graph(&self, results: &[Node], point: &Inputs) -> Vec<f64> {
        let sources = schedule::sources(&self.compiled.complete).into_iter();
        let symbols: Vec<f64> = sources.map(|source| point.get(source)).collect();
        let mut values = Vec::new();
        let graph = self.compiled.complete.equations.graph.read();
        evaluate_reachable(&graph, &self.results, &symbols, &mut values);
        results.iter().map(|node| values[node.index()]).collect()
    }
}

fn stored(matrix: &Matrix) -> usize {
    matrix.iter().map(|row| row.len()).sum()
}

fn places(jets: &[&Jet]) -> Vec<(usize, usize)> {
    let rows = jets.iter().enumerate();
    rows.flat_map(|(row, jet)| jet.columns.keys().map(move |column| (row, *column))).collect()
}

/// y + J x.
fn add_product(mut y: Vec<f64>, jets: &[&Jet], jacobian: &[f64], x: &[f64]) -> Vec<f64> {
    for ((row, column), entry) in places(jets).into_iter().zip(jacobian) {
        y[row] += entry * x[column];
    }
    y
}
