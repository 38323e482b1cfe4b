//! Matrices in Matrix Market's format, real ones, `coordinate` or `array`, `general` or `symmetric` (Boisvert, Pozo, Remington, NISTIR 5935, 1996).

/// Entries that are not zero, row, column, value.
#[derive(Clone, Debug)]
pub struct Matrix {
    pub name: String,
    pub rows: usize,
    pub entries: Vec<(usize, usize, f64)>,
}

pub fn read(name: &str, text: &str) -> Result<Matrix, String> {
    let at = |line: usize, what: &str| format!("`{name}`, line {line}: {what}");
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let (_, header) = lines.next().unwrap_or((1, ""));
    let words: Vec<String> = header.split_whitespace().map(str::to_lowercase).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (is_array, is_symmetric) = match words.as_slice() {
        [
            "%%matrixmarket",
            "matrix",
            form @ ("coordinate" | "array"),
            "real" | "integer",
            kind @ ("general" | "symmetric"),
        ] => (*form == "array", *kind == "symmetric"),
        _ => {
            let what = "a matrix begins with `%%MatrixMarket matrix coordinate real symmetric`, or `array`, `general`";
            return Err(at(1, what));
        }
    };
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('%'));
    let numbers = |next: Option<(usize, &str)>, count: usize| -> Result<Option<(usize, Vec<f64>)>, String> {
        let Some((number, line)) = next else { return Ok(None) };
        let values: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse).collect();
        let finite = |values: &Vec<f64>| values.len() == count && values.iter().all(|it| it.is_finite());
        match values.ok().filter(finite) {
            Some(values) => Ok(Some((number, values))),
            None => Err(at(number, &format!("{count} numbers stand here, found `{line}`"))),
        }
    };
    let sizes = numbers(lines.next(), if is_array { 2 } else { 3 })?;
    let Some((line, sizes)) = sizes else { return Err(at(1, "the file ends before the size of the matrix")) };
    if let Some(size) = sizes.iter().find(|size| size.fract() != 0.0 || **size < 0.0) {
        return Err(at(line, &format!("sizes are whole numbers, found {size}")));
    }
    let (rows, columns) = (sizes[0] as usize, sizes[1] as usize);
    if rows != columns {
        return Err(at(line, &format!("the matrix is square, found {rows} rows and {columns} columns")));
    }
    let mut entries = Vec::new();
    let mut enter = |i: usize, k: usize, value: f64| {
        entries.push((i, k, value));
        if is_symmetric && i != k {
            entries.push((k, i, value));
        }
    };
    let ended = |found: usize, count: usize| {
        format!("`{name}` has {count} entries by its size, and ends behind {found}")
    };
    if is_array {
        for k in 0..columns {
            for i in if is_symmetric { k } else { 0 }..rows {
                let Some((_, value)) = numbers(lines.next(), 1)? else {
                    return Err(ended(k * rows + i, rows * columns));
                };
                enter(i, k, value[0]);
            }
        }
    } else {
        let count = sizes[2] as usize;
        for found in 0..count {
            let Some((line, entry)) = numbers(lines.next(), 3)? else { return Err(ended(found, count)) };
            let is_index = |it: &f64| it.fract() == 0.0 && *it >= 1.0 && *it <= rows as f64;
            let (row, column) = (entry[0], entry[1]);
            if !is_index(&row) || !is_index(&column) {
                return Err(at(line, &format!("row {row} and column {column} are not within 1 to {rows}")));
            }
            let (i, k) = (row as usize, column as usize);
            if is_symmetric && k > i {
                return Err(at(
                    line,
                    "a symmetric matrix has its lower half alone: leave entries above the diagonal out",
                ));
            }
            enter(i - 1, k - 1, entry[2]);
        }
    }
    if let Some((line, more)) = lines.next() {
        return Err(at(line, &format!("all entries of the matrix stand before this line, found `{more}`")));
    }
    entries.retain(|(_, _, value)| *value != 0.0);
    Ok(Matrix { name: name.to_string(), rows, entries })
}
