//! Inputs of a run: each a function of time, or a column of a file of comma-separated values; zero where nothing is said.

use super::expression::{Expression, unknown};
use linkwright_compiler::model::Mechanism;
use linkwright_engine::Numbers;
use std::path::Path;

/// The names of time in expressions.
const TIME: [&str; 2] = ["t", "time"];

/// All inputs, in the order of their declaration.
#[derive(Clone, Debug, Default)]
pub struct Laws(Vec<Law>);

#[derive(Clone, Debug)]
enum Law {
    Constant(f64),
    /// Of time, and one of its unit in SI.
    Expression(Expression, f64),
    /// Times ascending, with values in SI between which there are straight lines; outside of them the first and the last.
    Samples(Vec<[f64; 2]>),
}

impl Laws {
    /// From what stands behind each `--input`: `name=expression`, `name=file.csv` or `file.csv`.
    pub fn read(mechanism: &Mechanism, given: &[String]) -> Result<Laws, String> {
        let inputs = &mechanism.inputs;
        let names = || inputs.iter().map(|input| input.name.text.as_str());
        let mut laws: Vec<Option<Law>> = vec![None; inputs.len()];
        let mut set = |name: &str, make: &dyn Fn(f64) -> Result<Law, String>| {
            let Some(index) = names().position(|known| known == name) else {
                return Err(unknown("--input: no input is called", name, names()));
            };
            if laws[index].is_some() {
                return Err(format!("--input: `{name}` is given twice"));
            }
            laws[index] = Some(make(inputs[index].unit.scale)?);
            Ok(())
        };
        for text in given {
            match text.split_once('=') {
                Some((name, file)) if file.ends_with(".csv") => {
                    let columns = columns(file)?;
                    let of_name = columns.iter().find(|column| column.name == name).or(columns.first());
                    let column =
                        of_name.ok_or_else(|| format!("--input: `{file}` has no column but time"))?;
                    set(name, &|scale| Ok(column.law(scale)))?;
                }
                Some((name, text)) => {
                    let expression = Expression::parse(text);
                    let checked = expression.and_then(|it| it.check(&TIME, &[]).map(|()| it));
                    let checked = checked.map_err(|error| format!("--input {name}: {error}"));
                    set(name, &|scale| Ok(Law::Expression(checked.clone()?, scale)))?;
                }
                None if text.ends_with(".csv") => {
                    for column in columns(text)? {
                        set(&column.name, &|scale| Ok(column.law(scale)))?;
                    }
                }
                None => {
                    return Err(format!(
                        "--input \"{text}\" says neither `name=expression` nor a file that ends in `.csv`"
                    ));
                }
            }
        }
        Ok(Laws(laws.into_iter().map(|law| law.unwrap_or(Law::Constant(0.0))).collect()))
    }

    /// The values at a time, SI.
    pub fn at(&self, time: f64) -> Numbers {
        let mut values = [0.0; 16];
        match values.get_mut(..self.0.len()) {
            Some(values) => {
                values.iter_mut().zip(&self.0).for_each(|(value, law)| *value = law.at(time));
                Numbers::of(values)
            }
            None => Numbers::of(&self.0.iter().map(|law| law.at(time)).collect::<Vec<_>>()),
        }
    }
}

impl Law {
    fn at(&self, time: f64) -> f64 {
        match self {
            Law::Constant(value) => *value,
            Law::Expression(expression, scale) => {
                scale * expression.value(&|name| TIME.contains(&name).then_some(time))
            }
            Law::Samples(samples) => {
                let next = samples.partition_point(|[at, _]| *at <= time);
                match (next.checked_sub(1).map(|before| samples[before]), samples.get(next)) {
                    (Some([from, a]), Some([to, b])) => a + (b - a) * (time - from) / (to - from),
                    (Some([_, last]), None) => last,
                    (None, Some([_, first])) => *first,
                    (None, None) => 0.0,
                }
            }
        }
    }
}

/// A column of a file beside that of time.
struct Column {
    name: String,
    samples: Vec<[f64; 2]>,
}

impl Column {
    fn law(&self, scale: f64) -> Law {
        Law::Samples(self.samples.iter().map(|[time, value]| [*time, scale * value]).collect())
    }
}

/// A table whose first line has names and whose first column is time in s.
fn columns(file: &str) -> Result<Vec<Column>, String> {
    let text = std::fs::read_to_string(Path::new(file))
        .map_err(|error| format!("--input: `{file}` cannot be read: {error}"))?;
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let Some((_, head)) = lines.next() else { return Err(format!("--input: `{file}` is empty")) };
    // The unit behind a name, as `run` writes it, is that of the declaration.
    let name = |cell: &str| cell.split('[').next().unwrap_or_default().trim().trim_matches('"').to_string();
    let mut names = head.split(',').map(name);
    let first = names.next().unwrap_or_default();
    if !TIME.contains(&first.as_str()) {
        return Err(format!(
            "--input: the first column of `{file}` is called \"{first}\", and it has to be `time`, in s"
        ));
    }
    let mut columns: Vec<Column> = names.map(|name| Column { name, samples: Vec::new() }).collect();
    let mut last = f64::NEG_INFINITY;
    for (number, line) in lines {
        let place = || format!("--input: `{file}`, line {}", number + 1);
        let values = line.split(',').map(|cell| {
            let parsed = cell.trim().parse::<f64>().ok().filter(|value| value.is_finite());
            parsed.ok_or_else(|| format!("{}: \"{}\" is no number", place(), cell.trim()))
        });
        let values = values.collect::<Result<Vec<f64>, String>>()?;
        if values.len() != columns.len() + 1 {
            return Err(format!("{}: {} values for {} columns", place(), values.len(), columns.len() + 1));
        }
        if values[0] <= last {
            return Err(format!("{}: the time {} s is not after {last} s", place(), values[0]));
        }
        last = values[0];
        for (column, value) in columns.iter_mut().zip(&values[1..]) {
            column.samples.push([last, *value]);
        }
    }
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines_between_samples() {
        let law = Law::Samples(vec![[0.0, 1.0], [2.0, 5.0], [3.0, 5.0]]);
        for (time, value) in [(-1.0, 1.0), (0.0, 1.0), (0.5, 2.0), (2.0, 5.0), (9.0, 5.0)] {
            assert_eq!(law.at(time), value);
        }
        let time = Law::Expression(Expression::parse("2 * t + time").expect("it is one"), 0.001);
        assert_eq!(time.at(2.0), 0.006);
    }
}
