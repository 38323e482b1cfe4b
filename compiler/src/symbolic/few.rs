//! Up to three things, one after the other: the operands of an operation. Iterators of the standard library that are put together of parts cost
//! a call for each part, where nothing is optimised, and this is asked for at every turn.

#[derive(Clone, Copy, Debug)]
pub struct Few<T> {
    all: [T; 3],
    at: usize,
    count: usize,
}

impl<T: Copy> Few<T> {
    /// The first so many of these.
    pub fn new(all: [T; 3], count: usize) -> Self {
        Few { all, at: 0, count }
    }
}

impl<T: Copy> Iterator for Few<T> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        if self.at == self.count {
            return None;
        }
        self.at += 1;
        Some(self.all[self.at - 1])
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.count - self.at, Some(self.count - self.at))
    }
}

impl<T: Copy> ExactSizeIterator for Few<T> {}
