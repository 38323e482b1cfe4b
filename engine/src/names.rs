//! Names that live as long as the program, because errors of the runtime carry them: each is made once.

use std::collections::HashSet;
use std::hash::Hash;
use std::sync::{Mutex, PoisonError};

static NAMES: Mutex<Option<HashSet<&'static str>>> = Mutex::new(None);
static LISTS: Mutex<Option<HashSet<&'static [&'static str]>>> = Mutex::new(None);

/// The known one that equals, else what `make` makes, known from then on.
fn once<T: ?Sized + Eq + Hash + 'static>(
    known: &Mutex<Option<HashSet<&'static T>>>,
    wanted: &T,
    make: impl FnOnce() -> &'static T,
) -> &'static T {
    let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
    let known = known.get_or_insert_default();
    if let Some(found) = known.get(wanted) {
        return found;
    }
    let made = make();
    known.insert(made);
    made
}

/// The name of this text.
pub fn name(text: &str) -> &'static str {
    once(&NAMES, text, || text.to_string().leak())
}

/// The list of these names.
pub fn list<T: AsRef<str>>(texts: impl IntoIterator<Item = T>) -> &'static [&'static str] {
    let names: Vec<&'static str> = texts.into_iter().map(|text| name(text.as_ref())).collect();
    once(&LISTS, names.as_slice(), || names.clone().leak())
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_name_is_made_once() {
        let (first, second) = (super::name("crank"), super::name(&["cra", "nk"].concat()));
        assert!(std::ptr::eq(first, second));
        assert!(std::ptr::eq(super::list(["a", "b"]), super::list(vec!["a".to_string(), "b".to_string()])));
        assert_ne!(super::list(["a"]), super::list(["b"]));
    }
}
