//! Bodies: mass, centre, inertia by shape, points and markers.

use super::{Read, Reader};
use crate::beam::{Beam, Made};
use crate::definition::Body;
use crate::error::DefinitionError;
use crate::json::{field, list, name, optional, text};
use crate::vector::*;
use serde_json::Value;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

impl<'t> Reader<'t> {
    pub(super) fn read_bodies(&mut self) -> Read<()> {
        for node in list(self.tree, "bodies", "bodies")? {
            let own = name(node, "bodies")?;
            let body = self.body(node, own)?;
            self.body_by_name.insert(own, self.bodies.len());
            self.bodies.push(body);
        }
        Ok(())
    }

    fn body(&self, node: &'t Value, own: &str) -> Read<Body> {
        let kind = text(node, "kind", own)?;
        if kind == "flexible" {
            return Err(DefinitionError::not_there_yet(own, "bodies with the modes of a file"));
        }
        if !matches!(kind, "body" | "rod" | "disk" | "box" | "sphere" | "cylinder" | "particle" | "beam") {
            return Err(DefinitionError::kind(own, kind));
        }
        let mut shape = Shape { own, kind, scalars: HashMap::new(), size: None };
        for (key, entry) in entries(node, "properties") {
            shape.scalars.insert(key, self.entry(entry, own)?);
        }
        let vector = |key: &str| {
            let tuple = node.get("vectors").and_then(|vectors| optional(vectors, key));
            tuple.map(|tuple| self.tuple(tuple, "value", own)).transpose()
        };
        shape.size = vector("size")?;
        if kind == "beam" {
            return self.beam(node, own, &shape);
        }
        let mass = match shape.scalars.get("mass") {
            Some(mass) => *mass,
            None => shape.scalar("density")? * self.volume(&shape)?,
        };
        let particle = kind == "particle";
        if !(mass >= 0.0 && mass.is_finite()) {
            return Err(DefinitionError::value(
                own,
                &format!("the mass {mass} kg is negative or not finite"),
            ));
        }

        let mut points = HashMap::from([("origin".to_string(), ZERO)]);
        let center = optional(node, "center").map(|center| self.tuple(center, "value", own)).transpose()?;
        let center = center.unwrap_or(ZERO);
        points.insert("center".to_string(), center);
        if matches!(kind, "rod" | "cylinder") {
            let half = 0.5 * shape.scalar("length")?;
            points.insert("start".to_string(), [-half, 0.0, 0.0]);
            points.insert("end".to_string(), [half, 0.0, 0.0]);
        }
        let mut markers = HashMap::new();
        for marker in list(node, "markers", own)? {
            markers.insert(name(marker, own)?.to_string(), self.marker_axes(marker, own)?);
        }
        for point in list(node, "points", own)?.iter().chain(list(node, "markers", own)?) {
            points.insert(name(point, own)?.to_string(), self.tuple(point, "value", own)?);
        }

        let inertia = if particle {
            [ZERO; 3]
        } else if !self.spatial {
            let about = match shape.scalars.get("inertia") {
                Some(inertia) => *inertia,
                None => shape.planar_inertia(mass)?,
            };
            [ZERO, ZERO, [0.0, 0.0, about]]
        } else {
            match vector("inertia")? {
                Some(moments) => {
                    let tensor = tensor(moments, vector("products")?.unwrap_or(ZERO));
                    self.in_marker(node, tensor, &markers, own)?
                }
                None => tensor(shape.moments(mass)?, ZERO),
            }
        };
        if !inertia.as_flattened().iter().all(|x| x.is_finite()) {
            return Err(DefinitionError::value(own, "the inertia is not finite"));
        }
        Ok(Body { name: own.to_string(), particle, mass, inertia, center, points, markers, beam: None })
    }

    /// A beam, referred to the origin of its frame.
    fn beam(&self, node: &'t Value, own: &str, shape: &Shape<'_, '_>) -> Read<Body> {
        let written = field(node, "beam", own)?;
        let count = |key: &str| {
            let count = field(written, key, own)?.as_u64().and_then(|count| usize::try_from(count).ok());
            count.ok_or_else(|| DefinitionError::malformed(own, key))
        };
        let length = shape.scalar("length")?;
        let torsion = match optional(written, "torsion") {
            Some(_) => count("torsion")?,
            None => 0,
        };
        // Area, second moments about z and about y, Saint-Venant's torsion constant where there is torsion.
        let [area, about_z, about_y, twisted] = match optional(written, "section") {
            None if self.spatial => {
                let twisted = if torsion > 0 { shape.scalar("torsion_constant")? } else { 0.0 };
                let [about_z, about_y] = [shape.scalar("second_moment_z")?, shape.scalar("second_moment_y")?];
                [shape.scalar("area")?, about_z, about_y, twisted]
            }
            None => [shape.scalar("area")?, shape.scalar("second_moment")?, 0.0, 0.0],
            Some(section) => {
                let of = |key: &str| self.entry(field(section, key, own)?, own);
                let round = |diameter: f64| {
                    let about = PI * diameter.powi(4) / 64.0;
                    [PI * diameter.powi(2) / 4.0, about, about, 2.0 * about]
                };
                match text(section, "kind", own)? {
                    "circle" => round(of("diameter")?),
                    "tube" => {
                        let [outer, inner] = [round(of("outer")?), round(of("inner")?)];
                        [0, 1, 2, 3].map(|k| outer[k] - inner[k])
                    }
                    "rectangle" => {
                        let [height, width] = [of("height")?, of("width")?];
                        let twisted = torsion_of_rectangle(height, width);
                        [
                            height * width,
                            width * height.powi(3) / 12.0,
                            height * width.powi(3) / 12.0,
                            twisted,
                        ]
                    }
                    kind => return Err(DefinitionError::kind(own, kind)),
                }
            }
        };
        let mass = match shape.scalars.get("mass") {
            Some(mass) => *mass,
            None => shape.scalar("density")? * area * length,
        };
        let young = shape.scalar("young")?;
        let is = |key: &str| optional(written, key).is_some_and(|it| it.as_bool() == Some(true));
        let made = Made {
            shapes: text(written, "shapes", own)?,
            length,
            axial: count("axial")?,
            bending: if self.spatial {
                [count("bending_y")?, count("bending_z")?]
            } else {
                [count("bending")?, 0]
            },
            spatial: self.spatial,
            mass,
            torsion,
            rigidity: [
                young * area,
                young * about_z,
                young * about_y,
                if torsion > 0 { shape.scalar("shear_modulus")? * twisted } else { 0.0 },
            ],
            polar: (about_z + about_y) / area,
            stiffens: is("stiffening"),
            quadratic: is("quadratic"),
            damping_ratio: shape.scalars.get("damping_ratio").copied().unwrap_or(0.0),
            thick: match optional(written, "theory") {
                Some(_) => {
                    let shear = shape.scalar("shear_modulus")?;
                    let factor = match shape.scalars.get("shear_factor") {
                        Some(factor) => *factor,
                        None => self.shear_factor(written, young / (2.0 * shear) - 1.0, own)?,
                    };
                    Some(([about_z / area, about_y / area], young / (factor * shear)))
                }
                None => None,
            },
        };
        let beam = Beam::new(&made).ok_or_else(|| DefinitionError::kind(own, made.shapes))?;
        let at = |share: f64| [beam.start + share * length, 0.0, 0.0];
        let mut points: HashMap<String, V3> =
            [("origin", ZERO), ("start", at(0.0)), ("center", at(0.5)), ("end", at(1.0))]
                .map(|(name, at)| (name.to_string(), at))
                .into();
        for point in list(node, "points", own)? {
            points.insert(name(point, own)?.to_string(), self.tuple(point, "value", own)?);
        }
        Ok(Body {
            name: own.to_string(),
            particle: false,
            mass,
            inertia: [ZERO; 3],
            center: ZERO,
            points,
            markers: HashMap::new(),
            beam: Some(Arc::new(beam)),
        })
    }

    /// κ of a section, G. R. Cowper, *The Shear Coefficient in Timoshenko's Beam Theory*, table 1.
    fn shear_factor(&self, written: &'t Value, nu: f64, own: &str) -> Read<f64> {
        let section = field(written, "section", own)?;
        let of = |key: &str| self.entry(field(section, key, own)?, own);
        let m = match text(section, "kind", own)? {
            "rectangle" => return Ok(10.0 * (1.0 + nu) / (12.0 + 11.0 * nu)),
            "tube" => of("inner")? / of("outer")?,
            _ => 0.0,
        };
        let square = (1.0 + m * m).powi(2);
        Ok(6.0 * (1.0 + nu) * square / ((7.0 + 6.0 * nu) * square + (20.0 + 12.0 * nu) * m * m))
    }

    /// B I Bᵀ where the tensor is given in the axes of a marker.
    fn in_marker(&self, node: &Value, tensor: M3, markers: &HashMap<String, M3>, own: &str) -> Read<M3> {
        if optional(node, "inertia_axes").is_none() {
            return Ok(tensor);
        }
        let marker = text(node, "inertia_axes", own)?;
        let b = markers.get(marker).ok_or_else(|| DefinitionError::unknown(own, marker))?;
        Ok(product(&product(b, &tensor), &transposed(b)))
    }

    fn volume(&self, shape: &Shape<'_, '_>) -> Read<f64> {
        Ok(match shape.kind {
            "rod" | "cylinder" => PI * shape.square("radius")? * shape.scalar("length")?,
            "disk" => PI * shape.square("radius")? * shape.scalar("thickness")?,
            "sphere" => 4.0 / 3.0 * PI * shape.scalar("radius")?.powi(3),
            "box" if self.spatial => shape.size()?.iter().product(),
            "box" => shape.scalar("width")? * shape.scalar("height")? * shape.scalar("thickness")?,
            _ => return Err(DefinitionError::malformed(shape.own, "mass")),
        })
    }

    /// The axes of a marker: by axis and reference, by an axis alone, then turned about its own axes in the order written.
    pub(super) fn marker_axes(&self, marker: &Value, part: &str) -> Read<M3> {
        let turns = list(marker, "axes", part)?;
        let mut given: HashMap<&str, V3> = HashMap::new();
        for turn in turns {
            let key = text(turn, "key", part)?;
            if matches!(key, "axis" | "reference") {
                given.insert(key, self.tuple(turn, "value", part)?);
            }
        }
        let axis = given.get("axis").copied().unwrap_or(unit_axis(2));
        let axes = match (given.get("reference"), given.contains_key("axis")) {
            (Some(reference), _) => frame_about(axis, *reference),
            (None, true) => canonical_frame(axis),
            (None, false) => Some(IDENTITY),
        };
        let mut axes = axes.ok_or_else(|| DefinitionError::value(part, "an axis has no direction"))?;
        for turn in turns {
            let k = match text(turn, "key", part)? {
                "about_x" => 0,
                "about_y" => 1,
                "about_z" => 2,
                "axis" | "reference" => continue,
                key => return Err(DefinitionError::kind(part, key)),
            };
            axes = product(&axes, &turn_about(k, self.entry(turn, part)?));
        }
        Ok(axes)
    }
}

/// a b³ (1/3 − (64/π⁵) (b/a) Σ tanh(nπa/2b)/n⁵) over odd n, of Prandtl's stress function (Timoshenko, Goodier, *Theory of Elasticity*, 109), which
/// holds whichever side is a: here the shorter one, term by term until none counts.
fn torsion_of_rectangle(one: f64, other: f64) -> f64 {
    let (a, b) = (one.min(other), one.max(other));
    let term = |n: f64| (0.5 * n * PI * a / b).tanh() / n.powi(5);
    let sum: f64 = (0..2000).rev().map(|k| term(2.0 * f64::from(k) + 1.0)).sum();
    a * b.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * b / a * sum)
}

/// The fields of an object.
fn entries<'t>(node: &'t Value, of: &str) -> impl Iterator<Item = (&'t str, &'t Value)> {
    let fields = node.get(of).and_then(Value::as_object);
    fields.into_iter().flatten().map(|(key, value)| (key.as_str(), value))
}

/// What inertia follows from.
struct Shape<'t, 'p> {
    own: &'p str,
    kind: &'t str,
    scalars: HashMap<&'t str, f64>,
    size: Option<V3>,
}

impl Shape<'_, '_> {
    fn scalar(&self, key: &str) -> Read<f64> {
        self.scalars.get(key).copied().ok_or_else(|| DefinitionError::malformed(self.own, key))
    }

    fn square(&self, key: &str) -> Read<f64> {
        Ok(self.scalar(key)?.powi(2))
    }

    fn size(&self) -> Read<V3> {
        self.size.ok_or_else(|| DefinitionError::malformed(self.own, "size"))
    }

    /// Zero where it is not written.
    fn square_or_zero(&self, key: &str) -> f64 {
        self.scalars.get(key).copied().unwrap_or(0.0).powi(2)
    }

    fn planar_inertia(&self, mass: f64) -> Read<f64> {
        Ok(match self.kind {
            "rod" => mass * (self.square("length")? + 3.0 * self.square_or_zero("radius")) / 12.0,
            "disk" => mass * self.square("radius")? / 2.0,
            "box" => mass * (self.square("width")? + self.square("height")?) / 12.0,
            _ => return Err(DefinitionError::malformed(self.own, "inertia")),
        })
    }

    fn moments(&self, mass: f64) -> Read<V3> {
        Ok(match self.kind {
            "rod" | "cylinder" => {
                let square = self.square_or_zero("radius");
                let across = mass * (3.0 * square + self.square("length")?) / 12.0;
                [mass * square / 2.0, across, across]
            }
            "sphere" => [0.4 * mass * self.square("radius")?; 3],
            "box" => {
                let [a, b, c] = self.size()?.map(|x| x * x);
                times(mass / 12.0, [b + c, a + c, a + b])
            }
            "disk" => {
                let square = mass * self.square("radius")?;
                let across = square / 4.0 + mass * self.square_or_zero("thickness") / 12.0;
                [across, across, square / 2.0]
            }
            _ => return Err(DefinitionError::malformed(self.own, "inertia")),
        })
    }
}

/// Products are entries of the tensor: Ixy = −Σ m x y.
fn tensor([x, y, z]: V3, [xy, xz, yz]: V3) -> M3 {
    [[x, xy, xz], [xy, y, yz], [xz, yz, z]]
}
