//! What a mechanism looks like, read from its `DEFINITION`: points, lines and outlines of bodies, joints, ground places.
//!
//! Works for any planar mechanism; only what a drawing needs is evaluated (numbers, constants and parameters with their
//! units, at time zero). Where the bodies are is said by `motions`; how they are drawn, by `drawing.rs`.

use serde_json::Value;
use std::collections::HashMap;

/// The shapes and joints of a mechanism.
pub struct Geometry {
    /// In the order of `BODIES`, and so of `motions`.
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
}

/// One body; points in its own axes from its centre of mass, m.
pub struct Body {
    pub name: String,
    pub points: Vec<(String, [f64; 2])>,
    /// Lines that a joint or a definition names: slots and rails.
    pub lines: Vec<[[f64; 2]; 2]>,
    pub outline: Outline,
}

/// The outline that a body's kind gives it, centred at `origin`.
pub enum Outline {
    None,
    Disk { origin: [f64; 2], radius: f64 },
    Box { origin: [f64; 2], width: f64, height: f64 },
    Particle,
}

/// A point of a body (its index) or of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub body: Option<usize>,
    pub at: [f64; 2],
}

/// A joint between two places.
pub struct Joint {
    pub kind: Kind,
    pub first: Place,
    pub second: Place,
}

/// Joints, as far as they are drawn differently. Directions are unit vectors in the first body's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Revolute,
    Prismatic { axis: [f64; 2] },
    PointOnLine { axis: [f64; 2] },
    Distance,
    Fixed,
}

impl Geometry {
    /// Reads `definition`, the `DEFINITION` of a mechanism.
    pub fn of(definition: &str) -> Result<Geometry, String> {
        let json: Value = serde_json::from_str(definition).map_err(|error| error.to_string())?;
        let names = Names::of(&json);
        let bodies = list(&json, "bodies").iter().map(|body| names.body(body)).collect::<Option<Vec<_>>>();
        let mut geometry = Geometry {
            bodies: bodies.ok_or("a body of the definition could not be read")?,
            joints: Vec::new(),
        };
        for body in list(&json, "bodies") {
            geometry.add_lines(body, &names);
        }
        for joint in list(&json, "joints") {
            let read = geometry.joint(joint, &json, &names);
            geometry.joints.push(read.ok_or_else(|| format!("joint {} could not be read", joint["name"]))?);
        }
        Ok(geometry)
    }

    /// The point called `body.point`.
    pub fn place(&self, path: &str) -> Option<Place> {
        let (body, point) = path.rsplit_once('.')?;
        let body = self.bodies.iter().position(|candidate| candidate.name == body)?;
        let (_, at) = self.bodies[body].points.iter().find(|(name, _)| name == point)?;
        Some(Place { body: Some(body), at: *at })
    }

    fn add_lines(&mut self, json: &Value, names: &Names) {
        for line in list(json, "lines") {
            let ends = (self.read_place(&line["from"], names), self.read_place(&line["to"], names));
            if let (Some(from), Some(to)) = ends
                && let Some(body) = from.body
            {
                self.bodies[body].lines.push([from.at, to.at]);
            }
        }
    }

    fn joint(&self, joint: &Value, json: &Value, names: &Names) -> Option<Joint> {
        let second = self.read_place(&joint["second"], names)?;
        let line = |line: &Value| -> Option<(Place, [f64; 2])> {
            let from = self.read_place(&line["from"], names)?;
            let to = self.read_place(&line["to"], names)?;
            Some((from, direction([to.at[0] - from.at[0], to.at[1] - from.at[1]])?))
        };
        let (first, kind) = match joint["kind"].as_str()? {
            "point_on_line" => {
                let (from, axis) = match joint["first"]["line"].as_str() {
                    Some(path) => line(find_line(json, path)?)?,
                    None => line(&joint["first"])?,
                };
                (from, Kind::PointOnLine { axis })
            }
            "prismatic" => {
                let axis = &joint["axis"]["value"];
                let axis = direction([names.value(&axis[0], "1")?, names.value(&axis[1], "1")?])?;
                (self.read_place(&joint["first"], names)?, Kind::Prismatic { axis })
            }
            "distance" => (self.read_place(&joint["first"], names)?, Kind::Distance),
            "fixed" => (self.read_place(&joint["first"], names)?, Kind::Fixed),
            _ => (self.read_place(&joint["first"], names)?, Kind::Revolute),
        };
        Some(Joint { kind, first, second })
    }

    fn read_place(&self, place: &Value, names: &Names) -> Option<Place> {
        if let Some(path) = place["place"].as_str() {
            return self.place(path);
        }
        let unit = place["unit"].as_str().unwrap_or("m");
        Some(Place { body: None, at: names.pair(&place["ground"], unit)? })
    }
}

fn list<'j>(json: &'j Value, key: &str) -> &'j [Value] {
    json[key].as_array().map_or(&[], Vec::as_slice)
}

fn find_line<'j>(json: &'j Value, path: &str) -> Option<&'j Value> {
    let (body, line) = path.rsplit_once('.')?;
    let body = list(json, "bodies").iter().find(|candidate| candidate["name"] == body)?;
    list(body, "lines").iter().find(|candidate| candidate["name"] == line)
}

fn direction([x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let length = x.hypot(y);
    (length > 0.0).then(|| [x / length, y / length])
}

/// The values of constants and parameters, SI.
struct Names(HashMap<String, f64>);

impl Names {
    fn of(json: &Value) -> Names {
        let mut names = Names(HashMap::from([("time".to_string(), 0.0)]));
        for declared in list(json, "constants").iter().chain(list(json, "parameters")) {
            let unit = declared["unit"].as_str().unwrap_or("1");
            if let (Some(name), Some(value)) =
                (declared["name"].as_str(), names.value(&declared["value"], unit))
            {
                names.0.insert(name.to_string(), value);
            }
        }
        names
    }

    fn body(&self, json: &Value) -> Option<Body> {
        let property = |name: &str| {
            let entry = &json["properties"][name];
            self.value(&entry["value"], entry["unit"].as_str()?)
        };
        let written = |entry: &Value| self.pair(&entry["value"], entry["unit"].as_str().unwrap_or("m"));
        let center = if json["center"].is_null() { [0.0, 0.0] } else { written(&json["center"])? };
        let mut points = vec![("center".to_string(), center), ("origin".to_string(), [0.0, 0.0])];
        for point in list(json, "points") {
            points.push((point["name"].as_str()?.to_string(), written(point)?));
        }
        let mut outline = Outline::None;
        let origin = [-center[0], -center[1]];
        match json["kind"].as_str()? {
            "rod" => {
                let half = 0.5 * property("length")?;
                points.extend([("start".to_string(), [-half, 0.0]), ("end".to_string(), [half, 0.0])]);
            }
            "disk" => outline = Outline::Disk { origin, radius: property("radius")? },
            "box" => {
                outline = Outline::Box { origin, width: property("width")?, height: property("height")? }
            }
            "particle" => outline = Outline::Particle,
            _ => {}
        }
        for (_, at) in &mut points {
            *at = [at[0] - center[0], at[1] - center[1]];
        }
        Some(Body { name: json["name"].as_str()?.to_string(), points, lines: Vec::new(), outline })
    }

    fn pair(&self, json: &Value, unit: &str) -> Option<[f64; 2]> {
        Some([self.value(&json[0], unit)?, self.value(&json[1], unit)?])
    }

    /// An entry's value in SI: a value that names nothing is in the entry's unit, any other is in SI already.
    fn value(&self, json: &Value, unit: &str) -> Option<f64> {
        let value = self.expression(json)?;
        Some(if names_nothing(json) { value * scale(unit)? } else { value })
    }

    fn expression(&self, json: &Value) -> Option<f64> {
        let unit = || json["unit"].as_str().map_or(Some(1.0), scale);
        if let Some(number) = json["number"].as_str() {
            return Some(number.replace('_', "").parse::<f64>().ok()? * unit()?);
        }
        if let Some(name) = json["name"].as_str() {
            return if name == "pi" { Some(std::f64::consts::PI) } else { self.0.get(name).copied() };
        }
        if !json["value"].is_null() {
            return Some(self.expression(&json["value"])? * unit()?);
        }
        let argument = |index: usize| self.expression(&json["args"][index]);
        let operation = json["op"].as_str().or(json["call"].as_str())?;
        Some(match operation {
            "+" => argument(0)? + argument(1)?,
            "-" => argument(0)? - argument(1)?,
            "*" => argument(0)? * argument(1)?,
            "/" => argument(0)? / argument(1)?,
            "^" => argument(0)?.powf(argument(1)?),
            "neg" => -argument(0)?,
            "sqrt" => argument(0)?.sqrt(),
            "abs" => argument(0)?.abs(),
            "sin" => argument(0)?.sin(),
            "cos" => argument(0)?.cos(),
            "tan" => argument(0)?.tan(),
            "asin" => argument(0)?.asin(),
            "acos" => argument(0)?.acos(),
            "atan2" => argument(0)?.atan2(argument(1)?),
            "min" => argument(0)?.min(argument(1)?),
            "max" => argument(0)?.max(argument(1)?),
            _ => return None,
        })
    }
}

/// Whether an expression has neither names nor units, `pi` aside.
fn names_nothing(json: &Value) -> bool {
    let name = json["name"].as_str().is_some_and(|name| name != "pi");
    let unit = json["unit"].as_str().is_some();
    !name && !unit && list(json, "args").iter().all(names_nothing)
}

/// The factor from a unit to SI; `None` for a unit that no length, angle or number has.
fn scale(unit: &str) -> Option<f64> {
    Some(match unit {
        "1" | "m" | "rad" | "kg" => 1.0,
        "dm" => 1e-1,
        "cm" => 1e-2,
        "mm" => 1e-3,
        "um" | "µm" | "μm" => 1e-6,
        "km" => 1e3,
        "deg" => std::f64::consts::PI / 180.0,
        "rev" => 2.0 * std::f64::consts::PI,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkwright_examples::quick_return::QuickReturn;

    #[test]
    fn reads_points_relative_to_the_centre_of_mass() {
        let geometry = Geometry::of(QuickReturn::DEFINITION).unwrap();
        assert_eq!(geometry.bodies.len(), QuickReturn::BODIES.len());
        assert_eq!(geometry.joints.len(), QuickReturn::JOINTS.len());
        assert_eq!(geometry.place("crank.tip"), Some(Place { body: Some(0), at: [0.075, 0.0] }));
        assert_eq!(geometry.place("crank.elbow"), None);
    }

    #[test]
    fn bare_numbers_are_in_the_unit_of_their_entry_and_names_are_in_si() {
        let names = Names(HashMap::from([("guide".to_string(), 0.4)]));
        let value = |text: &str, unit| names.value(&serde_json::from_str(text).unwrap(), unit);
        assert_eq!(value(r#"{"number":"200"}"#, "mm"), Some(0.2));
        assert_eq!(value(r#"{"number":"20","unit":"cm"}"#, "mm"), Some(0.2));
        let half = r#"{"op":"/","args":[{"name":"guide"},{"number":"2"}]}"#;
        assert_eq!(value(half, "mm"), Some(0.2));
    }
}
