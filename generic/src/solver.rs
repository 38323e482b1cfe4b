//! The linear systems, by `faer`: dense LU with partial pivoting, or sparse LU whose symbolic analysis is made once.
//!
//! The pattern is given once; each factorisation takes the values of its entries in the same order.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::lu::partial_pivoting;
use faer::perm::PermRef;
use faer::sparse::linalg::lu::{LuRef, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, MatRef, Par};

/// How the augmented system is factorised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Algebra {
    /// Dense up to [`Algebra::DENSE`] unknowns, sparse beyond.
    #[default]
    Auto,
    /// A dense LU with partial pivoting.
    Dense,
    /// A sparse LU with partial pivoting and a column order by COLAMD.
    Sparse,
}

impl Algebra {
    /// Unknowns, accelerations and multipliers together, up to which `Auto` is dense.
    pub const DENSE: usize = 32;
}

pub(crate) struct Solver {
    size: usize,
    /// Where each entry of the pattern goes among the stored values.
    places: Vec<usize>,
    memory: MemBuffer,
    storage: Storage,
}

enum Storage {
    Dense { values: Vec<f64>, rows: Vec<usize>, rows_inverse: Vec<usize> },
    Sparse(Box<Sparse>),
}

struct Sparse {
    matrix: SymbolicSparseColMat<usize>,
    values: Vec<f64>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
}

impl std::fmt::Debug for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let kind = if matches!(self.storage, Storage::Dense { .. }) { "dense" } else { "sparse" };
        write!(f, "{kind} LU of {} unknowns, {} entries", self.size, self.places.len())
    }
}

/// The matrix has no factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NoFactors;

impl Solver {
    /// For a square matrix with these entries (row, column), each once.
    pub fn new(size: usize, pattern: &[(usize, usize)], algebra: Algebra) -> Result<Self, NoFactors> {
        match algebra {
            Algebra::Dense => Ok(Self::dense(size, pattern)),
            Algebra::Auto if size <= Algebra::DENSE => Ok(Self::dense(size, pattern)),
            Algebra::Auto | Algebra::Sparse => Self::sparse(size, pattern),
        }
    }

    fn dense(size: usize, pattern: &[(usize, usize)]) -> Self {
        let places = pattern.iter().map(|(row, column)| column * size + row).collect();
        let factor = partial_pivoting::factor::lu_in_place_scratch::<usize, f64>(
            size,
            size,
            Par::Seq,
            Default::default(),
        );
        let solve = partial_pivoting::solve::solve_in_place_scratch::<usize, f64>(size, 1, Par::Seq);
        let storage = Storage::Dense {
            values: vec![0.0; size * size],
            rows: vec![0; size],
            rows_inverse: vec![0; size],
        };
        Solver { size, places, memory: MemBuffer::new(StackReq::any_of(&[factor, solve])), storage }
    }

    fn sparse(size: usize, pattern: &[(usize, usize)]) -> Result<Self, NoFactors> {
        // Compressed columns.
        let mut order: Vec<usize> = (0..pattern.len()).collect();
        order.sort_by_key(|at| (pattern[*at].1, pattern[*at].0));
        let mut starts = vec![0; size + 1];
        let mut rows = Vec::with_capacity(pattern.len());
        let mut places = vec![0; pattern.len()];
        for (place, at) in order.into_iter().enumerate() {
            let (row, column) = pattern[at];
            places[at] = place;
            rows.push(row);
            starts[column + 1] += 1;
        }
        for column in 0..size {
            starts[column + 1] += starts[column];
        }
        let matrix = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
        let symbolic = factorize_symbolic_lu(matrix.as_ref(), Default::default()).map_err(|_| NoFactors)?;
        let factor = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
        let solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        Ok(Solver {
            size,
            places,
            memory: MemBuffer::new(StackReq::any_of(&[factor, solve])),
            storage: Storage::Sparse(Box::new(Sparse {
                matrix,
                values: vec![0.0; pattern.len()],
                symbolic,
                numeric: NumericLu::new(),
            })),
        })
    }

    /// Factorises the matrix with these values of its pattern.
    pub fn factor(&mut self, entries: impl Iterator<Item = f64>) -> Result<(), NoFactors> {
        let stack = MemStack::new(&mut self.memory);
        match &mut self.storage {
            Storage::Dense { values, rows, rows_inverse } => {
                values.fill(0.0);
                for (place, entry) in self.places.iter().zip(entries) {
                    values[*place] = entry;
                }
                let matrix = MatMut::from_column_major_slice_mut(values, self.size, self.size);
                partial_pivoting::factor::lu_in_place(
                    matrix,
                    rows,
                    rows_inverse,
                    Par::Seq,
                    stack,
                    Default::default(),
                );
            }
            Storage::Sparse(sparse) => {
                let Sparse { matrix, values, symbolic, numeric } = &mut **sparse;
                for (place, entry) in self.places.iter().zip(entries) {
                    values[*place] = entry;
                }
                let matrix = SparseColMatRef::new(matrix.as_ref(), values);
                let factors =
                    symbolic.factorize_numeric_lu(numeric, matrix, Par::Seq, stack, Default::default());
                factors.map_err(|_| NoFactors)?;
            }
        }
        Ok(())
    }

    /// Replaces the right-hand side by the solution; needs `factor` before it.
    pub fn solve(&mut self, right: &mut [f64]) {
        let stack = MemStack::new(&mut self.memory);
        let right = MatMut::from_column_major_slice_mut(right, self.size, 1);
        match &self.storage {
            Storage::Dense { values, rows, rows_inverse } => {
                let factors = MatRef::from_column_major_slice(values, self.size, self.size);
                let rows = PermRef::new_checked(rows, rows_inverse, self.size);
                partial_pivoting::solve::solve_in_place_with_conj(
                    factors,
                    factors,
                    rows,
                    Conj::No,
                    right,
                    Par::Seq,
                    stack,
                );
            }
            Storage::Sparse(sparse) => {
                let factors = LuRef::new_unchecked(&sparse.symbolic, &sparse.numeric);
                factors.solve_in_place_with_conj(Conj::No, right, Par::Seq, stack);
            }
        }
    }
}
