//! From the tree of a definition to [`Definition`], in SI, with numbers for constants and parameters.
//!
//! What is named must be declared, so the order is: parameters, bodies, joints, then everything that names them. Every error names
//! the part at fault.

mod bodies;
mod bristles;
mod contacts;
mod couplings;
mod friction;
mod gears;
mod hysteresis;
mod joints;
mod laws;
mod loads;
mod meshes;
mod pairs;
mod penalties;
mod places;
mod rubbing;
mod states;
mod tables;
mod touching;
mod values;
mod vectors;

use crate::definition::{Body, Definition, Parameter};
use crate::energy::Energies;
use crate::error::DefinitionError;
use crate::json::{list, name, optional, text};
use crate::load::Load;
use crate::quantity::Quantity;
use crate::table::Table;
use crate::vector::ZERO;
use joints::Joint;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;

pub(crate) type Read<T> = Result<T, DefinitionError>;

/// What is known of the definition so far.
pub(crate) struct Reader<'t> {
    tree: &'t Value,
    spatial: bool,
    /// Values of parameters in SI.
    parameters: HashMap<&'t str, f64>,
    constants: HashMap<&'t str, &'t Value>,
    signals: HashMap<&'t str, &'t Value>,
    inputs: HashMap<&'t str, usize>,
    states: HashMap<String, usize>,
    loads: HashMap<String, Load>,
    /// Of joints that yield.
    penalties: Vec<Load>,
    /// Rows of equations and drivers, whose efforts have names.
    efforts: HashMap<String, usize>,
    energies: Option<Arc<Energies>>,
    bodies: Vec<Body>,
    body_by_name: HashMap<&'t str, usize>,
    joints: Vec<Joint>,
    joint_by_name: HashMap<&'t str, usize>,
    counted: Vec<Quantity>,
    tables: HashMap<&'t str, Arc<Table>>,
}

/// The definition with some of its parameters at other values than their defaults.
pub(crate) fn read(tree: &Value, given: &HashMap<String, f64>) -> Read<Definition> {
    if tree.get("linkwright").and_then(Value::as_u64) != Some(1) {
        return Err(DefinitionError::malformed("definition", "the version, \"linkwright\": 1,"));
    }
    let title = text(tree, "name", "definition")?;
    let spatial = match text(tree, "kind", title)? {
        "planar" => false,
        "spatial" => true,
        kind => return Err(DefinitionError::kind(title, kind)),
    };
    let mut reader = Reader {
        tree,
        spatial,
        parameters: HashMap::new(),
        constants: by_name(tree, "constants")?,
        signals: by_name(tree, "signals")?,
        inputs: HashMap::new(),
        states: HashMap::new(),
        loads: HashMap::new(),
        penalties: Vec::new(),
        efforts: HashMap::new(),
        energies: None,
        bodies: Vec::new(),
        body_by_name: HashMap::new(),
        joints: Vec::new(),
        joint_by_name: HashMap::new(),
        counted: Vec::new(),
        tables: HashMap::new(),
    };
    for held in ["memories", "events"] {
        if let Some(first) = list(tree, held, held)?.first() {
            return Err(DefinitionError::not_there_yet(name(first, held)?, "memories and events"));
        }
    }
    let inputs = list(tree, "inputs", "inputs")?;
    let inputs = inputs.iter().map(|input| name(input, "inputs")).collect::<Read<Vec<_>>>()?;
    reader.inputs = inputs.iter().enumerate().map(|(at, name)| (*name, at)).collect();
    reader.read_tables()?;
    let parameters = reader.read_parameters(given)?;
    reader.read_bodies()?;
    let gravity = match optional(tree, "gravity") {
        Some(tuple) => reader.tuple(tuple, "value", "gravity")?,
        None => ZERO,
    };
    let mut rows = reader.read_joints()?;
    rows.extend(reader.read_couplings()?);
    rows.extend(reader.read_drivers()?);
    reader.name_states()?;
    let mut loads = reader.read_loads(&rows)?;
    loads.extend(reader.read_contacts()?);
    loads.append(&mut reader.penalties);
    reader.loads = loads.iter().map(|load| (load.name.clone(), load.clone())).collect();
    let efforts = rows.iter().enumerate().filter(|(_, row)| matches!(row.what, "equation" | "driver"));
    reader.efforts = efforts.map(|(at, row)| (row.of.clone(), at)).collect();
    let energies = Energies { bodies: reader.bodies.clone(), loads: loads.clone(), gravity };
    reader.energies = Some(Arc::new(energies));
    let states = reader.read_states()?;
    let options = tree.get("options").and_then(|options| options.get("redundant")).and_then(Value::as_str);
    Ok(Definition {
        name: title.to_string(),
        spatial,
        gravity,
        parameters,
        inputs: inputs.into_iter().map(str::to_string).collect(),
        bodies: reader.bodies,
        rows,
        loads,
        states,
        counted: reader.counted,
        redundant: matches!(options, Some("drop" | "keep")),
    })
}

fn by_name<'t>(tree: &'t Value, what: &str) -> Read<HashMap<&'t str, &'t Value>> {
    list(tree, what, what)?.iter().map(|node| Ok((name(node, what)?, node))).collect()
}

impl<'t> Reader<'t> {
    /// In the order of the definition, because a default may name those before it.
    fn read_parameters(&mut self, given: &HashMap<String, f64>) -> Read<Vec<Parameter>> {
        let mut parameters = Vec::new();
        for node in list(self.tree, "parameters", "parameters")? {
            let own = name(node, "parameters")?;
            let value = match given.get(own) {
                Some(value) => *value,
                None => self.entry(node, own)?,
            };
            let unit = node.get("unit").and_then(Value::as_str);
            let bound =
                |field: &str| optional(node, field).map(|bound| self.in_unit(bound, unit, own)).transpose();
            let bounds = [bound("min")?, bound("max")?];
            let within = bounds[0].is_none_or(|least| value >= least)
                && bounds[1].is_none_or(|most| value <= most)
                && value.is_finite();
            if !within {
                return Err(DefinitionError::value(own, &format!("{value} is out of its bounds")));
            }
            self.parameters.insert(own, value);
            parameters.push(Parameter { name: own.to_string(), value });
        }
        Ok(parameters)
    }
}
