//! Results as tables of Apache Arrow, which data frames and files are made of.

use crate::results::{Columns, Recording};
use arrow_array::{ArrayRef, Float32Array, Float64Array, RecordBatch, UInt64Array};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use linkwright::Real;
use std::sync::Arc;

/// Numbers that Arrow has arrays of.
pub trait InArrow: Real {
    /// Their type.
    const TYPE: DataType;
    /// An array of them.
    fn array(values: impl Iterator<Item = Self>) -> ArrayRef;
}

impl InArrow for f64 {
    const TYPE: DataType = DataType::Float64;
    fn array(values: impl Iterator<Item = f64>) -> ArrayRef {
        Arc::new(Float64Array::from_iter_values(values))
    }
}

impl InArrow for f32 {
    const TYPE: DataType = DataType::Float32;
    fn array(values: impl Iterator<Item = f32>) -> ArrayRef {
        Arc::new(Float32Array::from_iter_values(values))
    }
}

impl<R: InArrow> Columns<R> {
    /// The columns, with a row for each member and its index as the column `member`. What could not be prepared is NaN.
    ///
    /// # Errors
    /// Of Arrow, if two columns cannot stand in one table.
    pub fn record_batch(&self) -> Result<RecordBatch, ArrowError> {
        table(&[("member", (0..self.members() as u64).collect())], &[self])
    }
}

impl<R: InArrow> Recording<R> {
    /// All samples below one another: the columns `step` and `member`, and the outputs.
    ///
    /// # Errors
    /// Of Arrow, if two columns cannot stand in one table.
    pub fn record_batch(&self) -> Result<RecordBatch, ArrowError> {
        let samples: Vec<&Columns<R>> = self.samples.iter().collect();
        let members = samples.first().map_or(0, |sample| sample.members()) as u64;
        let steps = self.steps.iter().flat_map(|step| (0..members).map(move |_| *step as u64));
        let of_each = self.steps.iter().flat_map(|_| 0..members);
        table(&[("step", steps.collect()), ("member", of_each.collect())], &samples)
    }
}

/// Indices, and columns of the same names below one another.
fn table<R: InArrow>(
    indices: &[(&str, Vec<u64>)],
    samples: &[&Columns<R>],
) -> Result<RecordBatch, ArrowError> {
    let names = samples.first().map_or(&[][..], |sample| sample.names());
    let fields = indices.iter().map(|(name, _)| Field::new(*name, DataType::UInt64, false));
    let fields: Vec<Field> =
        fields.chain(names.iter().map(|name| Field::new(*name, R::TYPE, false))).collect();
    let indices = indices.iter().map(|(_, values)| Arc::new(UInt64Array::from(values.clone())) as ArrayRef);
    let columns = names.iter().map(|name| {
        R::array(samples.iter().flat_map(|sample| sample.column(name).unwrap_or_default().iter().copied()))
    });
    RecordBatch::try_new(Arc::new(Schema::new(fields)), indices.chain(columns).collect())
}
