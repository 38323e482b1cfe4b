//! A pair of toothings in words and numbers, for the page and `explain`.

use super::super::{Load, Mechanism, fold};
use super::holding::Orientations;
use super::{Meeting, Mesh, Pair, Toothing, meshes};
use crate::forms::Rim;
use crate::numbers::{coordinate, significant};

/// What is told of a pair.
#[derive(Clone, Debug)]
pub struct Told {
    pub name: String,
    /// `sun.rim` and `planet.rim`.
    pub of: [String; 2],
    /// `40 and 20 teeth of 2 mm`.
    pub teeth: String,
    /// How the axes stand to each other, in words.
    pub axes: String,
    /// m; of cones their length.
    pub distance: f64,
    /// α_w, degrees.
    pub working_angle: f64,
    pub contact_ratio: f64,
    /// ε_β, zero of straight teeth.
    pub overlap: f64,
    /// After so many turns of the first wheel the same teeth meet again; of a rack never.
    pub hunting: Option<f64>,
    /// Of a worm, the coefficient of friction from which on its wheel cannot turn it, tan γ cos α.
    pub locking: Option<f64>,
}

impl Told {
    pub fn of(mechanism: &Mechanism, pair: &Pair) -> Told {
        let ([first, second], mesh) = mechanism.mesh_of(pair);
        let of = |toothing: &Toothing| toothing.text.clone();
        Told {
            name: pair.name.text.clone(),
            of: [of(first), of(second)],
            teeth: teeth([first, second]),
            axes: axes([first, second], pair, &mesh),
            distance: pair.distance(),
            working_angle: mesh.working_angle.map_or(0.0, f64::to_degrees),
            contact_ratio: mesh.contact_ratio,
            overlap: mesh.overlap,
            hunting: (pair.meeting != Meeting::Rack)
                .then(|| second.teeth / common(first.teeth, second.teeth)),
            locking: (pair.meeting == Meeting::Worm).then(|| {
                let screw = if pair.wheel == 0 { second } else { first };
                libm::tan(screw.lead_angle()) * libm::cos(screw.pressure_angle)
            }),
        }
    }

    /// As cells of a table, with names as they are set there.
    pub fn cells(&self, set: fn(&str) -> String) -> Vec<String> {
        let overlap = if self.overlap > 0.0 {
            format!(" and overlap {}", coordinate(self.overlap, 4))
        } else {
            String::new()
        };
        let locking = match self.locking {
            Some(locking) => format!(", self-locking from a friction of {} on", coordinate(locking, 4)),
            None => String::new(),
        };
        let turns = match self.hunting {
            Some(1.0) => "the same teeth meet every turn".to_string(),
            Some(turns) => format!("the same teeth meet every {turns} turns"),
            None => String::new(),
        };
        vec![
            set(&self.name),
            self.of.each_ref().map(|of| set(of)).join(" and "),
            self.teeth.clone(),
            self.axes.clone(),
            format!("contact ratio {}{overlap}{locking}", coordinate(self.contact_ratio, 4)),
            turns,
        ]
    }
}

/// What is told of teeth that give.
#[derive(Clone, Debug)]
pub struct Gives {
    pub name: String,
    /// k̄, N/m; none where a law changes it.
    pub stiffness: Option<f64>,
    /// m_e, kg; none where nothing that the teeth drive is free.
    pub mass: Option<f64>,
    /// The gap along the line of action, m, and along the pitch circle.
    pub backlash: [f64; 2],
}

impl Gives {
    /// Of all loads between teeth.
    pub fn all(mechanism: &Mechanism) -> Vec<Gives> {
        let orientations = Orientations::of(mechanism);
        let told = |load: &Load| {
            let pair = &mechanism.pairs[load.teeth.as_ref()?.pair];
            let (_, mesh) = mechanism.mesh_of(pair);
            let number =
                |which: usize| fold::evaluate(load.components(which).first()?, &mechanism.defaults());
            let backlash = number(meshes::BACKLASH).unwrap_or(0.0);
            Some(Gives {
                name: load.name.text.clone(),
                stiffness: number(meshes::STIFFNESS),
                mass: meshes::reduced_mass(mechanism, &orientations, pair, &mesh),
                backlash: [backlash, backlash / cosine(mechanism, pair, &mesh)],
            })
        };
        mechanism.loads.iter().filter_map(told).collect()
    }

    /// √(k̄/m_e)/2π, Hz: of the teeth alone, as if nothing else gave.
    pub fn hertz(&self) -> Option<f64> {
        Some(libm::sqrt(self.stiffness? / self.mass?) / std::f64::consts::TAU)
    }

    /// As cells of a table, with names as they are set there.
    pub fn cells(&self, set: fn(&str) -> String) -> Vec<String> {
        let short = |value: f64| significant(value, 6);
        let mean = self.stiffness.map_or("by a law".to_string(), |k| format!("mean {} N/m", short(k)));
        let mass = self.mass.map_or(String::new(), |mass| format!("{} kg reduced", short(mass)));
        let hertz = self.hertz().map_or(String::new(), |hertz| format!("{} Hz by itself", short(hertz)));
        let [along, around] = self.backlash.map(|gap| coordinate(1e6 * gap, 6));
        let gap = match self.backlash {
            [0.0, _] => "no backlash".to_string(),
            _ => format!("backlash {along} um along the line of action, {around} um along the pitch circle"),
        };
        vec![set(&self.name), mean, mass, hertz, gap]
    }
}

/// How much of a way along the pitch circles is one along the line of action.
fn cosine(mechanism: &Mechanism, pair: &Pair, mesh: &Mesh) -> f64 {
    match (pair.meeting, &pair.touch) {
        (Meeting::Worm, Some(touch)) => {
            let screw = mechanism.toothing(pair.on[1 - pair.wheel]);
            2.0 * touch.radius / screw.module
        }
        _ => libm::cos(mesh.working_angle.unwrap_or(0.0)),
    }
}

fn teeth(of: [&Toothing; 2]) -> String {
    let counted = |toothing: &Toothing| match (toothing.form.rim, toothing.teeth) {
        (Rim::Rack, _) => "a rack".to_string(),
        (Rim::Worm, 1.0) => "1 thread".to_string(),
        (Rim::Worm, threads) => format!("{threads} threads"),
        (Rim::External | Rim::Internal | Rim::Bevel, teeth) => format!("{teeth} teeth"),
    };
    let mm = |toothing: &Toothing| coordinate(1e3 * toothing.module, 6);
    let [first, second] = of;
    match of.map(|toothing| toothing.form.rim) {
        [Rim::Rack | Rim::Worm, _] => {
            format!("{} of {} mm and {}", counted(first), mm(first), counted(second))
        }
        [_, Rim::Rack | Rim::Worm] => {
            format!("{} and {} of {} mm", counted(first), counted(second), mm(second))
        }
        _ => format!("{} and {} of {} mm", first.teeth, counted(second), mm(first)),
    }
}

fn axes([first, second]: [&Toothing; 2], pair: &Pair, mesh: &Mesh) -> String {
    let apart = coordinate(1e3 * pair.distance(), 6);
    let working = coordinate(mesh.working_angle.map_or(0.0, f64::to_degrees), 5);
    match pair.meeting {
        Meeting::Cylinders if pair.axes_move => {
            format!("axes that move, {apart} mm apart without play, at {working} deg")
        }
        Meeting::Cylinders => format!("axes {apart} mm apart at {working} deg"),
        Meeting::Rack => format!("axis {apart} mm from the line at {working} deg"),
        Meeting::Cones(between) => {
            let cones = [first, second].map(|toothing| coordinate(toothing.cone.to_degrees(), 5));
            let between = coordinate(between.to_degrees(), 6);
            format!("axes at {between} deg, cones of {} and {} deg, {apart} mm long", cones[0], cones[1])
        }
        Meeting::Worm => {
            let screw = if pair.wheel == 0 { second } else { first };
            format!(
                "crossed axes {apart} mm apart, lead {} deg",
                coordinate(screw.lead_angle().to_degrees(), 5)
            )
        }
    }
}

/// The greatest common divisor of whole numbers.
fn common(a: f64, b: f64) -> f64 {
    let (mut a, mut b) = (a, b);
    while b != 0.0 {
        (a, b) = (b, a % b);
    }
    a
}
