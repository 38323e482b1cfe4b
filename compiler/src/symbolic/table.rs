//! Tables as data of the graph: rows of a base and coefficients, and how they are looked up and evaluated at expansion.
//!
//! A row is of the stretch of the argument from its base on. The first row is of what is below all bases: its own is that of the
//! second one. So n knots are n + 1 rows, of which the outer two say how the table goes on outside.

/// Rows of one table; what they hold follows from their width.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// As formulas call it.
    pub name: String,
    /// Numbers of a row: [`AXIS`], [`PIECES`], [`PATCHES`] or [`BICUBIC`].
    width: usize,
    /// Row by row.
    values: Vec<f64>,
    /// The largest order of a derivative that is not zero everywhere.
    degree: u8,
}

/// A base alone.
pub const AXIS: usize = 1;
/// Base, a, b, c, d of a + b s + c s² + d s³ with s = x − base.
pub const PIECES: usize = 5;
/// Bases in x and y, a, b, c, d of a + b s + c t + d s t with s = x − base, t = y − base.
pub const PATCHES: usize = 6;
/// Bases in x and y, then for each power of s the factors of 1, t, t², t³: Σ c s^k t^l.
pub const BICUBIC: usize = 18;

/// How often a look-up is differentiated, by the first and by the second argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Orders(u8);

impl Orders {
    pub fn new(first: u8, second: u8) -> Self {
        Orders(first.min(15) << 4 | second.min(15))
    }
    pub fn first(self) -> u8 {
        self.0 >> 4
    }
    pub fn second(self) -> u8 {
        self.0 & 15
    }
}

impl Table {
    pub fn new(name: impl Into<String>, width: usize, values: Vec<f64>) -> Self {
        let mut table = Table { name: name.into(), width, values, degree: 3 };
        if width == PIECES {
            let is_used = |column: &usize| table.rows().any(|row| row[*column] != 0.0);
            table.degree = (1..=3).rev().find(|order| is_used(&(order + 1))).unwrap_or(0) as u8;
        }
        table
    }

    pub fn width(&self) -> usize {
        self.width
    }
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> + Clone {
        self.values.chunks_exact(self.width)
    }
    /// Steps of the search for a row: ⌈log₂⌉ of their number.
    pub fn steps(&self) -> usize {
        self.rows().len().next_power_of_two().trailing_zeros() as usize
    }

    /// Whether a derivative of these orders is zero everywhere.
    pub fn vanishes(&self, orders: Orders) -> bool {
        match self.width {
            PATCHES => orders.first() > 1 || orders.second() > 1,
            BICUBIC => orders.first() > 3 || orders.second() > 3,
            _ => orders.first() > self.degree,
        }
    }

    /// The row of an argument: how many bases from the second on are not above it. No number is in the first.
    pub fn cell(&self, x: f64) -> f64 {
        let bases = &self.values[self.width..];
        let (mut low, mut high) = (0, bases.len() / self.width);
        while low < high {
            let middle = low.midpoint(high);
            if bases[middle * self.width] <= x { low = middle + 1 } else { high = middle }
        }
        low as f64
    }

    /// The bases of the rows beside the one of this number: where the next ones begin.
    pub fn ends(&self, cell: f64) -> [f64; 2] {
        let at = cell as usize;
        let base = |row: usize| self.rows().nth(row).map(|row| row[0]);
        [
            if at == 0 { f64::NEG_INFINITY } else { base(at).unwrap_or(f64::NEG_INFINITY) },
            base(at + 1).unwrap_or(f64::INFINITY),
        ]
    }

    fn row(&self, cell: f64) -> &[f64] {
        // What is no number is in the first.
        let at = (cell as usize).min(self.rows().len() - 1);
        &self.values[at * self.width..(at + 1) * self.width]
    }

    /// A cubic piece or one of its derivatives. Rounded as emitted code rounds without fused multiply-add; no number gives none.
    pub fn piece(&self, order: u8, cell: f64, x: f64) -> f64 {
        let &[base, a, b, c, d] = self.row(cell) else { return f64::NAN };
        cubic(order, [a, b, c, d], x - base)
    }

    /// The terms of [`Table::piece`] by their magnitudes: what it may be off by in roundings.
    pub fn magnitude(&self, order: u8, cell: f64, x: f64) -> f64 {
        let &[base, a, b, c, d] = self.row(cell) else { return f64::NAN };
        cubic(order, [a, b, c, d].map(f64::abs), (x - base).abs())
    }

    /// A patch or one of its derivatives, likewise.
    pub fn patch(&self, orders: Orders, cell: f64, x: f64, y: f64) -> f64 {
        if let [first, second, factors @ ..] = self.row(cell)
            && self.width == BICUBIC
        {
            return bicubic(orders, |k| factors[k], x - first, y - second);
        }
        let &[first, second, a, b, c, d] = self.row(cell) else { return f64::NAN };
        let (s, t) = (x - first, y - second);
        match (orders.first(), orders.second()) {
            (0, 0) => (d * t + b) * s + (c * t + a),
            (1, 0) => 0.0 * s + (d * t + b),
            (0, 1) => 0.0 * t + (d * s + c),
            (1, 1) => 0.0 * s + (0.0 * t + d),
            _ => 0.0,
        }
    }

    /// The terms of [`Table::patch`] by their magnitudes.
    pub fn patch_magnitude(&self, orders: Orders, cell: f64, x: f64, y: f64) -> f64 {
        if let [first, second, factors @ ..] = self.row(cell)
            && self.width == BICUBIC
        {
            return bicubic(orders, |k| factors[k].abs(), (x - first).abs(), (y - second).abs());
        }
        let &[first, second, a, b, c, d] = self.row(cell) else { return f64::NAN };
        let (s, t, [a, b, c, d]) = ((x - first).abs(), (y - second).abs(), [a, b, c, d].map(f64::abs));
        match (orders.first(), orders.second()) {
            (0, 0) => (d * t + b) * s + (c * t + a),
            (1, 0) => d * t + b,
            (0, 1) => d * s + c,
            _ => d,
        }
    }
}

/// a + b s + c s² + d s³, or one of its derivatives.
fn cubic(order: u8, [a, b, c, d]: [f64; 4], s: f64) -> f64 {
    match order {
        0 => ((d * s + c) * s + b) * s + a,
        1 => (3.0 * d * s + 2.0 * c) * s + b,
        2 => 6.0 * d * s + 2.0 * c,
        // Zero times the argument, so that what is no number gives none.
        3 => 0.0 * s + 6.0 * d,
        _ => 0.0,
    }
}

/// Σ c s^k t^l, or one of its derivatives, by its 16 factors.
fn bicubic(orders: Orders, factor: impl Fn(usize) -> f64, s: f64, t: f64) -> f64 {
    let along = |k: usize| cubic(orders.second(), [0, 1, 2, 3].map(|l| factor(4 * k + l)), t);
    cubic(orders.first(), [0, 1, 2, 3].map(along), s)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp() -> Table {
        let rows = [[1.0, 0.0, 0.0], [1.0, 0.0, 2.0], [2.0, 2.0, 1.0], [5.0, 5.0, 0.0]];
        Table::new("ramp", PIECES, rows.iter().flat_map(|[x, a, b]| [*x, *a, *b, 0.0, 0.0]).collect())
    }

    #[test]
    fn a_row_begins_at_its_base() {
        let ramp = ramp();
        let cells: Vec<f64> = [0.9, 1.0, 1.5, 2.0, 4.9, 5.0, 9.0, f64::NAN].map(|x| ramp.cell(x)).into();
        assert_eq!(cells, [0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 0.0]);
        assert_eq!(
            [0.0, 1.0, 3.0].map(|cell| ramp.ends(cell)),
            [[f64::NEG_INFINITY, 1.0], [1.0, 2.0], [5.0, f64::INFINITY]]
        );
        let at = |x: f64| ramp.piece(0, ramp.cell(x), x);
        assert_eq!([-4.0, 1.5, 3.0, 7.0].map(at), [0.0, 1.0, 3.0, 5.0]);
        assert!(at(f64::NAN).is_nan());
        assert_eq!(ramp.steps(), 2);
        assert!(ramp.vanishes(Orders::new(2, 0)) && !ramp.vanishes(Orders::new(1, 0)));
    }

    #[test]
    fn orders_are_kept_apart() {
        let orders = Orders::new(3, 2);
        assert_eq!((orders.first(), orders.second()), (3, 2));
    }
}
