//! Mechanisms that close by construction: the joints are placed first, and lengths and places follow from where they are.
//! Then the guesses are turned away by up to 60 degrees.

use crate::random::Random;
use crate::{cases, put_together};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fmt::Write;

/// The largest error of a guess.
const ROUGH: f64 = PI / 3.0;

pub type Vec3 = [f64; 3];

pub struct Closable {
    pub kind: &'static str,
    pub source: String,
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Bodies and the points at which they meet, in the plane; body 0 is the ground.
struct Chain {
    names: &'static [&'static str],
    joints: &'static [(usize, usize)],
}

const FOUR_BAR: Chain =
    Chain { names: &["ground", "crank", "coupler", "rocker"], joints: &[(0, 1), (1, 2), (2, 3), (0, 3)] };
/// Two ternary links that meet.
const WATT: Chain = Chain {
    names: &["t1", "t2", "a", "b", "c", "d"],
    joints: &[(0, 1), (0, 2), (2, 3), (3, 1), (0, 4), (4, 5), (5, 1)],
};
/// Two ternary links that do not.
const STEPHENSON: Chain = Chain {
    names: &["t1", "t2", "a", "b", "c", "d"],
    joints: &[(0, 2), (2, 1), (0, 3), (3, 1), (0, 4), (4, 5), (5, 1)],
};

/// The definition of a chain whose joints stand at random places; body `ground` stands still. What `start` says of each
/// moving body: nothing, a rough guess of its angle, or its angle.
fn planar(chain: &Chain, ground: usize, said: impl Fn(usize) -> Said, random: &mut Random) -> String {
    let places: Vec<[f64; 2]> = loop {
        let places: Vec<[f64; 2]> =
            chain.joints.iter().map(|_| [random.between(-1.5, 1.5), random.between(-1.5, 1.5)]).collect();
        let apart = |(i, a): (usize, &(usize, usize))| {
            chain.joints.iter().enumerate().all(|(j, b)| {
                let share = [b.0, b.1].iter().any(|body| *body == a.0 || *body == a.1);
                i == j || !share || distance(places[i], places[j]) > 0.3
            })
        };
        if chain.joints.iter().enumerate().all(apart) {
            break places;
        }
    };
    let angles: Vec<f64> = chain.names.iter().map(|_| random.between(-PI, PI)).collect();
    let mut text = String::from("planar Closable {\n    gravity [m/s^2] = (0, -9.81);\n");
    let mut joints = String::new();
    let mut start = String::new();
    for (body, name) in chain.names.iter().enumerate().filter(|(body, _)| *body != ground) {
        let own: Vec<usize> =
            (0..places.len()).filter(|j| chain.joints[*j].0 == body || chain.joints[*j].1 == body).collect();
        let origin = places[own[0]];
        let _ = write!(text, "    body {name} {{ mass [kg] = 1; inertia [kg*m^2] = 0.1;");
        for joint in own {
            let [x, y] = [places[joint][0] - origin[0], places[joint][1] - origin[1]];
            let (c, s) = (angles[body].cos(), angles[body].sin());
            let _ = write!(text, " point p{joint} [m] = ({:.17}, {:.17});", c * x + s * y, c * y - s * x);
        }
        text += " }\n";
        match said(body) {
            Said::Nothing => {}
            Said::Guess => {
                let guess = angles[body] + random.between(-ROUGH, ROUGH);
                let _ = write!(start, " {name}.angle [rad] ~ {guess:.17};");
            }
            Said::Exactly => {
                let _ = write!(start, " {name}.angle [rad] = {:.17};", angles[body]);
            }
        }
    }
    for (joint, (a, b)) in chain.joints.iter().enumerate() {
        let place = |body: usize| match body == ground {
            true => format!("ground({:.17}, {:.17}) [m]", places[joint][0], places[joint][1]),
            false => format!("{}.p{joint}", chain.names[body]),
        };
        let _ = writeln!(joints, "    joint j{joint}: revolute({}, {});", place(*a), place(*b));
    }
    text + &joints + &format!("    start {{{start} }}\n}}")
}

#[derive(Clone, Copy, PartialEq)]
enum Said {
    Nothing,
    Guess,
    Exactly,
}

fn four_bar(case: usize, random: &mut Random) -> Closable {
    let (kind, said): (_, fn(usize) -> Said) = match case % 4 {
        0 => ("four-bar, rocker guessed", |body| if body == 3 { Said::Guess } else { Said::Nothing }),
        1 => ("four-bar, all guessed", |_| Said::Guess),
        2 => ("four-bar, crank guessed", |body| if body == 1 { Said::Guess } else { Said::Nothing }),
        _ => ("four-bar, crank stated", |body| if body == 1 { Said::Exactly } else { Said::Guess }),
    };
    Closable { kind, source: planar(&FOUR_BAR, 0, said, random) }
}

fn six_bar(case: usize, random: &mut Random) -> Closable {
    let ground = random.index(6);
    match case % 2 {
        0 => Closable { kind: "Watt", source: planar(&WATT, ground, |_| Said::Guess, random) },
        _ => Closable { kind: "Stephenson", source: planar(&STEPHENSON, ground, |_| Said::Guess, random) },
    }
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn direction(random: &mut Random) -> Vec3 {
    loop {
        let v = [0, 1, 2].map(|_| random.between(-1.0, 1.0));
        let length = dot(v, v).sqrt();
        if (0.2..1.0).contains(&length) {
            return v.map(|x| x / length);
        }
    }
}

/// `v` turned about the unit vector `axis` (Rodrigues).
pub fn turned(axis: Vec3, angle: f64, v: Vec3) -> Vec3 {
    let (c, s) = (angle.cos(), angle.sin());
    let (along, across) = (dot(axis, v) * (1.0 - c), cross(axis, v));
    [0, 1, 2].map(|k| c * v[k] + s * across[k] + along * axis[k])
}

/// A crank on a revolute, a rod between two balls or a ball and a universal joint, and a slider.
pub struct SliderCrank {
    pub bearing: Vec3,
    pub axis: Vec3,
    pub arm: Vec3,
    pub rail: Vec3,
    pub along: Vec3,
}

impl SliderCrank {
    pub fn random(random: &mut Random) -> Self {
        let place = |random: &mut Random| [0, 1, 2].map(|_| random.between(-0.5, 0.5));
        let (bearing, rail) = (place(random), place(random));
        let (axis, along) = (direction(random), direction(random));
        let arm = cross(axis, direction(random)).map(|x| x * 0.4);
        SliderCrank { bearing, axis, arm, rail, along }
    }

    pub fn tip(&self, angle: f64) -> Vec3 {
        let arm = turned(self.axis, angle, self.arm);
        [0, 1, 2].map(|k| self.bearing[k] + arm[k])
    }

    /// Length of the rod with the crank at `angle` and the slider at `travel`.
    pub fn rod(&self, angle: f64, travel: f64) -> f64 {
        let tip = self.tip(angle);
        let rod = [0, 1, 2].map(|k| self.rail[k] + travel * self.along[k] - tip[k]);
        dot(rod, rod).sqrt()
    }

    pub fn source(&self, rod: f64, universal: bool, start: &str) -> String {
        let vector = |v: Vec3| format!("({:.17}, {:.17}, {:.17})", v[0], v[1], v[2]);
        let cross = match universal {
            true => "universal(slider.center, rod.start, axis = (0, 1, 0), second_axis = (0, 0, 1))",
            false => "spherical(slider.center, rod.start)",
        };
        format!(
            "spatial Closable {{
    body crank  {{ mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.01); point tip [m] = {}; }}
    rod rod     {{ mass [kg] = 1; length [m] = {rod:.17}; radius [m] = 0.02; }}
    body slider {{ mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.01); }}
    joint bearing: revolute(ground{} [m], crank.origin, axis = {});
    joint ball:    spherical(crank.tip, rod.end);
    joint cross:   {cross};
    joint rail:    prismatic(ground{} [m], slider.center, axis = {});
    start {{ {start} }}
}}",
            vector(self.arm),
            vector(self.bearing),
            vector(self.axis),
            vector(self.rail),
            vector(self.along)
        )
    }
}

fn slider_crank(case: usize, random: &mut Random) -> Closable {
    let parts = SliderCrank::random(random);
    let (angle, travel) = (random.between(-PI, PI), random.between(-0.8, 0.8));
    let rod = parts.rod(angle, travel);
    let mut guess = |value: f64, off: f64| value + random.between(-off, off);
    let (kind, start) = match case % 3 {
        0 => ("slider-crank, crank guessed", format!("bearing.angle [rad] ~ {:.17};", guess(angle, ROUGH))),
        1 => (
            "slider-crank, both guessed",
            format!(
                "bearing.angle [rad] ~ {:.17}; rail.travel [m] ~ {:.17};",
                guess(angle, ROUGH),
                guess(travel, 0.3)
            ),
        ),
        _ => (
            "slider-crank, crank stated",
            format!("bearing.angle [rad] = {angle:.17}; rail.travel [m] ~ {:.17};", guess(travel, 0.3)),
        ),
    };
    Closable { kind, source: parts.source(rod, case % 2 == 0, &start) }
}

#[test]
fn what_closes_is_put_together() {
    let mut refused: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut tried: BTreeMap<&str, usize> = BTreeMap::new();
    let clock = std::time::Instant::now();
    for case in 0..cases() {
        let mut random = Random::of_case(case);
        let closable = match case % 3 {
            0 => four_bar(case / 3, &mut random),
            1 => six_bar(case / 3, &mut random),
            _ => slider_crank(case / 3, &mut random),
        };
        *tried.entry(closable.kind).or_default() += 1;
        if let Err(message) = put_together(&closable.source) {
            refused.entry(closable.kind).or_default().push(format!("{case}: {message}"));
            if std::env::var("SHOW").is_ok_and(|show| show == case.to_string()) {
                println!("{}\n{message}", closable.source);
            }
        }
    }
    for (kind, count) in &tried {
        let of = refused.get(kind).map_or(0, Vec::len);
        println!("{kind}: {of} of {count} refused");
        let mut sorts: BTreeMap<String, usize> = BTreeMap::new();
        for message in refused.get(kind).into_iter().flatten() {
            let sort = if message.contains("two ways") { "two ways" } else { &message[..] };
            let sort = if sort.contains("cannot close") { "cannot close" } else { sort };
            *sorts.entry(sort.into()).or_default() += 1;
        }
        println!("{sorts:?}");
    }
    println!("{:?}", clock.elapsed());
}

#[test]
#[ignore]
fn show() {
    for case in std::env::var("CASE").map_or(0..60, |c| {
        let c: usize = c.parse().unwrap();
        c..c + 1
    }) {
        let mut random = Random::of_case(case);
        let closable = match case % 3 {
            0 => four_bar(case / 3, &mut random),
            1 => six_bar(case / 3, &mut random),
            _ => slider_crank(case / 3, &mut random),
        };
        if let Err(message) = put_together(&closable.source) {
            println!(
                "{case} {}\n   {}\n   {message}",
                closable.kind,
                closable.source.lines().find(|l| l.contains("start {")).unwrap()
            );
        }
    }
}
