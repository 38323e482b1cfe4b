//! The factorisations beside the default accelerations: K(c), and D for independent velocities.

use super::Emitter;
use super::function::{SOLUTION, all, function, list, solution_of};
use super::names::Argument;
use crate::schedule::Function;
use std::fmt::Write;

use Argument::{
    BetaSquared, Compliance, Constants, GivenForces, GivenRows, Inputs, Lu, Q, Store, Time, TwoAlpha, V,
};

/// K(c), written out where that is asked for, else by tables.
pub fn factorisation(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let Some(stored) = &emitter.compiled.solved.stored else {
        text.push_str(
            "type Store = tabled::Store<R, Self>;\n\
             fn store() -> Self::Store { tabled::store::<R, Self>() }\n\
             fn factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Self::Store) -> R {\n\
             tabled::factor::<R, Self>(self, time, q, compliance, store)\n}\n\
             fn solve(&self, store: &Self::Store, forces: &V<R>, rows: &Lambda<R>, a: &mut V<R>, lambda: &mut Lambda<R>) {\n\
             tabled::solve::<R, Self>(store, forces, rows, a, lambda)\n}\n",
        );
        return;
    };
    let (kept, velocities) = (stored.kept.len(), emitter.velocities());
    let _ = writeln!(text, "type Store = Store<R>;\nfn store() -> Store<R> {{ [R::ZERO; {kept}] }}");
    function(
        text,
        helpers,
        emitter,
        Function::Factor,
        &[Constants, Time, Q, Compliance],
        "factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Store<R>) -> R",
        |outputs| format!("*store = {};\n{}", list(&outputs[..kept]), outputs[kept]),
    );
    function(
        text,
        helpers,
        emitter,
        Function::Solve,
        &[Constants, Store, GivenForces, GivenRows],
        "solve(&self, store: &Store<R>, forces: &V<R>, rows: &Lambda<R>, a_out: &mut V<R>, lambda_out: &mut Lambda<R>)",
        |outputs| {
            let (a, lambda) = outputs.split_at(velocities);
            format!("*a_out = {};\n*lambda_out = {};", list(a), list(lambda))
        },
    );
    if !emitter.compiled.solved.emits_system {
        return;
    }
    let rows = kept + velocities;
    function(
        text,
        helpers,
        emitter,
        Function::System,
        &[Constants, Time, Q, V, Inputs, TwoAlpha, BetaSquared, Compliance],
        "system(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, two_alpha: R, beta_squared: R, compliance: R, \
         store_out: &mut Store<R>, forces_out: &mut V<R>, rows_out: &mut Lambda<R>) -> R",
        |outputs| {
            let (rest, pivot) = outputs.split_at(outputs.len() - 1);
            format!(
                "*store_out = {};\n*forces_out = {};\n*rows_out = {};\n{}",
                list(&rest[..kept]),
                list(&rest[kept..rows]),
                list(&rest[rows..]),
                pivot[0]
            )
        },
    );
}

/// The equations in independent velocities, where they are asked for; the runtime has them by tables.
pub fn null_space(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let Some(written) = &emitter.compiled.solved.null_space else {
        text.push_str("type Lu = ();\nfn lu() {}\n");
        return;
    };
    let (kept, velocities) = (written.kept.len(), emitter.velocities());
    let _ = writeln!(text, "type Lu = Lu<R>;\nfn lu() -> Lu<R> {{ [R::ZERO; {kept}] }}");
    function(
        text,
        helpers,
        emitter,
        Function::FactorJacobian,
        &[Constants, Time, Q],
        "factor_jacobian(&self, time: R, q: &Q<R>, lu: &mut Lu<R>) -> R",
        |outputs| format!("*lu = {};\n{}", list(&outputs[..kept]), outputs[kept]),
    );
    function(
        text,
        helpers,
        emitter,
        Function::DependentVelocities,
        &[Constants, Lu, GivenRows, V],
        "dependent_velocities(&self, lu: &Lu<R>, rows: &Lambda<R>, v: &V<R>, out: &mut V<R>)",
        all,
    );
    function(
        text,
        helpers,
        emitter,
        Function::NullSpace,
        &SOLUTION,
        "null_space(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a_out: &mut V<R>, \
         lambda_out: &mut Lambda<R>) -> R",
        solution_of(velocities),
    );
}
