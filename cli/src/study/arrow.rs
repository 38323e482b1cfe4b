//! A run as a file of Apache Arrow: a column of numbers for the time and each column of `linkwright run`, with its unit as metadata.

use super::record::Trajectory;

/// What a run was, for the metadata of the file.
pub type About = [(&'static str, String)];

/// The file, in the format of Arrow's interprocess communication (Feather, version 2).
#[cfg(feature = "arrow")]
pub fn file(trajectory: &Trajectory, about: &About) -> Result<Vec<u8>, String> {
    use arrow_array::{ArrayRef, Float64Array, RecordBatch};
    use arrow_ipc::writer::FileWriter;
    use arrow_schema::{DataType, Field, Schema};
    use std::sync::Arc;

    let field = |name: &str, unit: &str| {
        let unit = [("unit".to_string(), unit.to_string())];
        Field::new(name, DataType::Float64, false).with_metadata(unit)
    };
    let columns = &trajectory.columns;
    let fields: Vec<Field> = std::iter::once(field("time", "s"))
        .chain(columns.iter().map(|column| field(&column.name, &column.unit)))
        .collect();
    let about = about.iter().map(|(name, value)| (name.to_string(), value.clone()));
    let schema =
        Arc::new(Schema::new_with_metadata(fields, about.collect::<std::collections::HashMap<_, _>>()));
    let column = |index: usize| {
        let values = trajectory.rows().map(|row| row[index]);
        Arc::new(Float64Array::from_iter_values(values)) as ArrayRef
    };
    let times: ArrayRef = Arc::new(Float64Array::from(trajectory.times.clone()));
    let arrays = std::iter::once(times).chain((0..columns.len()).map(column)).collect();
    let written = || {
        let rows = RecordBatch::try_new(schema.clone(), arrays)?;
        let mut writer = FileWriter::try_new(Vec::new(), &schema)?;
        writer.write(&rows)?;
        writer.into_inner()
    };
    written().map_err(|error| error.to_string())
}

/// There is nothing to make it, which has been said before.
#[cfg(not(feature = "arrow"))]
pub fn file(_: &Trajectory, _: &About) -> Result<Vec<u8>, String> {
    Err("this program has been built without it".to_string())
}
