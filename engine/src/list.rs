//! The vectors of mechanisms that are read while the program runs: as many entries as the definition says. Short ones are kept in
//! place, so that a step of a small mechanism allocates nothing.

use linkwright_runtime::{Fields, Vector};
use std::fmt;

/// So many entries are kept in place.
const FEW: usize = 14;

/// Numbers, as many as were asked for.
#[derive(Clone)]
pub struct List(Entries);

#[derive(Clone)]
enum Entries {
    Few(u8, [f64; FEW]),
    Many(Box<[f64]>),
}

impl List {
    /// The entries of a slice.
    pub fn of(values: &[f64]) -> Self {
        let mut list = List::zeros(values.len());
        list.as_mut_slice().copy_from_slice(values);
        list
    }
}

impl Vector<f64> for List {
    #[inline]
    fn zeros(len: usize) -> Self {
        match u8::try_from(len) {
            Ok(few) if len <= FEW => List(Entries::Few(few, [0.0; FEW])),
            _ => List(Entries::Many(vec![0.0; len].into())),
        }
    }
    #[inline]
    fn as_slice(&self) -> &[f64] {
        match &self.0 {
            Entries::Few(len, entries) => &entries[..usize::from(*len)],
            Entries::Many(entries) => entries,
        }
    }
    #[inline]
    fn as_mut_slice(&mut self) -> &mut [f64] {
        match &mut self.0 {
            Entries::Few(len, entries) => &mut entries[..usize::from(*len)],
            Entries::Many(entries) => entries,
        }
    }
}

impl PartialEq for List {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl fmt::Debug for List {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(f)
    }
}

/// Inputs, outputs or parameters in the order of their declaration, in SI units. The mechanism knows their names.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers(pub List);

impl Numbers {
    /// The entries of a slice.
    pub fn of(values: &[f64]) -> Self {
        Numbers(List::of(values))
    }

    /// The entries, first to last.
    pub fn as_slice(&self) -> &[f64] {
        self.0.as_slice()
    }
}

impl Fields<f64> for Numbers {
    const NAMES: &'static [&'static str] = &[];
    type Array = List;

    fn from_array(values: List) -> Self {
        Numbers(values)
    }
    fn to_array(&self) -> List {
        self.0.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_and_long_lists_are_alike() {
        for len in [0, 1, FEW, FEW + 1, 300] {
            let mut list = List::zeros(len);
            assert_eq!(list.as_slice(), vec![0.0; len]);
            list.as_mut_slice().iter_mut().enumerate().for_each(|(i, entry)| *entry = i as f64);
            assert_eq!(list, List::of(list.clone().as_slice()));
            assert!(len == 0 || list != List::zeros(len) || len == 1);
        }
    }
}
