//! The factorisations beside the default accelerations: K(c), and D for independent velocities.

use super::Emitter;
use super::function::function;
use crate::functions::{Function, Shape};
use std::fmt::Write;

/// K(c), written out where that is asked for, else by tables.
pub fn factorisation(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let solved = &emitter.compiled.solved;
    if solved.stored.is_none() {
        text.push_str(
            "type Store = tabled::Store<R, Self>;\n\
             fn store() -> Self::Store { tabled::store::<R, Self>() }\n\
             fn factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Self::Store) -> R {\n\
             tabled::factor::<R, Self>(self, time, q, compliance, store)\n}\n\
             fn solve(&self, store: &Self::Store, forces: &V<R>, rows: &Lambda<R>, a: &mut V<R>, lambda: &mut Lambda<R>) {\n\
             tabled::solve::<R, Self>(store, forces, rows, a, lambda)\n}\n",
        );
        return;
    }
    let kept = emitter.entries(Shape::Store);
    let _ = writeln!(text, "type Store = Store<R>;\nfn store() -> Store<R> {{ [R::ZERO; {kept}] }}");
    for which in [Function::Factor, Function::Solve] {
        function(text, helpers, emitter, which);
    }
    if solved.emits_system {
        function(text, helpers, emitter, Function::System);
    }
}

/// The equations in independent velocities, where they are asked for; the runtime has them by tables.
pub fn null_space(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    if emitter.compiled.solved.null_space.is_none() {
        text.push_str("type Lu = ();\nfn lu() {}\n");
        return;
    }
    let kept = emitter.entries(Shape::Lu);
    let _ = writeln!(text, "type Lu = Lu<R>;\nfn lu() -> Lu<R> {{ [R::ZERO; {kept}] }}");
    for which in [Function::FactorJacobian, Function::DependentVelocities, Function::NullSpace] {
        function(text, helpers, emitter, which);
    }
}
