//! `linkwright influence`: by how much an output, or what is measured of a run, changes with each parameter. Outputs of the assembled
//! mechanism are differentiated exactly, everything else by differences that say how far they can be off.

mod along;
mod differences;
mod exact;
mod held;
mod table;
#[cfg(test)]
mod tests;

use super::expression::unknown;
use super::measure::{GROUPS, measures, unit, value};
use super::options::Study;
use super::record::{Column, Group, columns};
use super::runs::{on_all_cores, run_with};
use super::{Done, Failure, Loaded, laws, short, start, write};
use crate::with_engine;
use differences::{Slope, Varied, slopes};
use exact::Exact;
use serde_json::{Value, json};
use table::{Line, Table};

/// A parameter whose influence is asked for.
pub struct Parameter {
    /// In the order of declaration.
    pub index: usize,
    pub name: String,
    pub unit: String,
    /// One of the unit in SI.
    pub scale: f64,
    /// In the unit.
    pub value: f64,
    /// By which it is changed where there is no exact derivative, SI.
    pub step: f64,
}

/// The command.
pub fn influence(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    let by = parameters(study, loaded).map_err(Failure::Usage)?;
    if study.along {
        return along::along(study, loaded, &by);
    }
    let wanted = wanted(study, loaded).map_err(Failure::Usage)?;
    let (at_start, held) = at_start(study, loaded, &wanted, &by)?;
    let of_runs = of_runs(study, loaded, &by)?;
    let tables: Vec<Table> = at_start.into_iter().chain(of_runs).collect();
    let failed = tables.iter().flat_map(|table| &table.lines).any(|line| line.slope.is_err());
    if !study.json || study.out.is_some() {
        let text = if study.csv {
            table::csv(&tables, &by)
        } else {
            table::text(study, loaded, &tables, &held, &by)
        };
        write(study.out.as_deref(), &text)?;
    }
    let quantities: Vec<Value> = tables.iter().map(|table| table.for_machines(&by)).collect();
    Ok(Done { value: json!({ "held": held, "quantities": quantities }), failed })
}

/// The parameters of `--by`, else all.
fn parameters(study: &Study, loaded: &Loaded) -> Result<Vec<Parameter>, String> {
    let known = &loaded.compiled.mechanism.parameters;
    if known.is_empty() {
        return Err(format!(
            "{} has no parameters: declare what may change, such as `param crank_length [mm] = 200;`, and write its name in place of the number",
            loaded.name
        ));
    }
    let names = || known.iter().map(|it| it.name.text.as_str());
    if let Some(name) = study.by.iter().find(|name| !names().any(|known| known == *name)) {
        return Err(unknown("--by: no parameter is called", name, names()));
    }
    let values = with_engine!(&loaded.engine, |engine| engine.parameters());
    let all = known.iter().zip(values).enumerate().map(|(index, (it, value))| Parameter {
        index,
        name: it.name.text.clone(),
        unit: it.unit.text.clone(),
        scale: it.unit.scale,
        value: value / it.unit.scale,
        step: differences::step(*value, it.bounds, it.unit.scale),
    });
    Ok(all.filter(|it| study.by.is_empty() || study.by.contains(&it.name)).collect())
}

/// The columns of `--of`; all outputs where neither these nor measures are asked for.
fn wanted(study: &Study, loaded: &Loaded) -> Result<Vec<Column>, String> {
    let known = columns(&loaded.compiled, &GROUPS);
    if study.of.is_empty() && study.measures.is_empty() {
        let outputs: Vec<Column> =
            known.into_iter().filter(|column| column.group == Group::Outputs).collect();
        if outputs.is_empty() {
            return Err(format!(
                "{} has no outputs: say what the influence is on, `--of kinetic_energy`, or `--measure 'max(kinetic_energy)'`",
                loaded.name
            ));
        }
        return Ok(outputs);
    }
    let find = |name: &String| {
        let names = known.iter().map(|column| column.name.as_str());
        let found = known.iter().find(|column| column.name == *name).cloned();
        found.ok_or_else(|| unknown("--of: there is no quantity", name, names))
    };
    study.of.iter().map(find).collect()
}

/// Tables of columns at the start, and the coordinates that are held.
fn at_start(
    study: &Study,
    loaded: &Loaded,
    wanted: &[Column],
    by: &[Parameter],
) -> Result<(Vec<Table>, Vec<String>), Failure> {
    if wanted.is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let inputs = laws(loaded, study)?.at(0.0);
    let state = with_engine!(&loaded.engine, |engine| start(engine)?);
    let mut exact = Exact::of(loaded)?;
    let held = exact.held();
    let assembled = held::Assembled::of(loaded, &state, &inputs);
    let all = columns(&loaded.compiled, &GROUPS);
    let values = assembled.base(&loaded.engine);
    let place = |column: &Column| all.iter().position(|known| known.name == column.name).unwrap_or(0);
    // Outputs are the first columns.
    let is_exact = |column: &Column| column.group == Group::Outputs;
    let derivatives =
        if wanted.iter().any(is_exact) { exact.at(0.0, &state, &inputs, by) } else { Vec::new() };
    // What cannot be linearised, as a rigid contact, may be assembled anew all the same.
    let by_differences: Vec<Result<Vec<Slope>, String>> =
        if wanted.iter().all(is_exact) && derivatives.iter().all(Result::is_ok) {
            Vec::new()
        } else {
            let varied: Vec<Varied> = by.iter().map(Varied::of).collect();
            slopes(&loaded.engine, &varied, &values, &|engine, parameters| assembled.with(engine, parameters))
        };
    let tables = wanted.iter().map(|column| {
        let index = place(column);
        let lines = by.iter().enumerate().map(|(k, parameter)| {
            let differences = || by_differences[k].as_ref().map(|all| all[index]);
            let slope = if is_exact(column) {
                let exact = derivatives[k].as_ref().map(|all| Slope::exact(all[index] / column.scale));
                exact.or_else(|message| differences().map_err(|_| message))
            } else {
                differences()
            };
            Line {
                parameter: k,
                slope: slope.map(|slope| slope.times(parameter.scale)).map_err(String::clone),
            }
        });
        Table {
            of: column.name.clone(),
            unit: Some(column.unit.clone()),
            value: values[index],
            of_run: false,
            lines: lines.collect(),
        }
    });
    Ok((tables.collect(), held))
}

/// Tables of measures of runs.
fn of_runs(study: &Study, loaded: &Loaded, by: &[Parameter]) -> Result<Vec<Table>, Failure> {
    if study.measures.is_empty() {
        return Ok(Vec::new());
    }
    let measures = measures(&study.measures, &loaded.compiled).map_err(Failure::Usage)?;
    let laws = laws(loaded, study)?;
    let columns = columns(&loaded.compiled, &GROUPS);
    let measured = |engine: &_, parameters: &[f64]| {
        let run = run_with(engine, parameters, &laws, &study.course, &columns)?;
        Ok(measures.iter().map(|measure| value(measure, &run)).collect::<Vec<f64>>())
    };
    let given = with_engine!(&loaded.engine, |engine| engine.parameters().to_vec());
    let base = on_all_cores(&loaded.engine, 1, &|engine, _| measured(engine, &given));
    let base = base.into_iter().next().unwrap_or_else(|| Ok(Vec::new())).map_err(Failure::Motion)?;
    let varied: Vec<Varied> = by.iter().map(Varied::of).collect();
    let found = slopes(&loaded.engine, &varied, &base, &measured);
    let tables = study.measures.iter().zip(&measures).enumerate().map(|(index, (text, measure))| {
        let lines = by.iter().zip(&found).enumerate().map(|(k, (parameter, slopes))| {
            let slope = slopes.as_ref().map(|slopes| slopes[index].times(parameter.scale));
            Line { parameter: k, slope: slope.map_err(String::clone) }
        });
        let unit = unit(measure, &columns);
        Table { of: text.clone(), unit, value: base[index], of_run: true, lines: lines.collect() }
    });
    Ok(tables.collect())
}
