//! What the factorisations beside the default accelerations are kept in: K(c), and D for independent velocities. Where they are
//! not written out the runtime has them by tables.

use super::Emitter;
use crate::functions::Shape;
use std::fmt::Write;

/// K(c).
pub fn factorisation(text: &mut String, emitter: &Emitter) {
    if emitter.compiled.complete.further.stored.is_none() {
        text.push_str(
            "type Store = tabled::Store<R, Self>;\n\
             fn store(&self) -> Self::Store { tabled::store::<R, Self>(self) }\n\
             fn factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Self::Store) -> R {\n\
             tabled::factor::<R, Self>(self, time, q, compliance, store)\n}\n\
             fn solve(&self, store: &Self::Store, forces: &V<R>, rows: &Lambda<R>, a: &mut V<R>, lambda: &mut Lambda<R>) {\n\
             tabled::solve::<R, Self>(self, store, forces, rows, a, lambda)\n}\n",
        );
        return;
    }
    let kept = emitter.compiled.entries(Shape::Store);
    let _ = writeln!(text, "type Store = Store<R>;\nfn store(&self) -> Store<R> {{ [R::ZERO; {kept}] }}");
}

/// D for independent velocities.
pub fn jacobian(text: &mut String, emitter: &Emitter) {
    if !emitter.compiled.complete.further.emits_factors {
        text.push_str("type Lu = ();\nfn lu(&self) {}\n");
        return;
    }
    let kept = emitter.compiled.entries(Shape::Lu);
    let _ = writeln!(text, "type Lu = Lu<R>;\nfn lu(&self) -> Lu<R> {{ [R::ZERO; {kept}] }}");
}
