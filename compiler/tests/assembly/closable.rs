//! Mechanisms that close by construction: the joints are placed first, and lengths and places follow from where they are.
//! Then the guesses are turned away by up to 60 degrees.

use crate::random::Random;
use crate::{cases, put_together};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fmt::Write;
use std::ops::Range;

/// The largest error of a guess.
const ROUGH: f64 = PI / 3.0;

pub type Vec3 = [f64; 3];

struct Closable {
    kind: &'static str,
    source: String,
    /// No more is guessed than there are freedoms, so that one position is the nearest; more guesses may be about as far from
    /// one assembly as from another.
    decided: bool,
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
    Closable { kind, source: planar(&FOUR_BAR, 0, said, random), decided: case.is_multiple_of(2) }
}

fn six_bar(case: usize, random: &mut Random) -> Closable {
    let ground = random.index(6);
    let guessed = (ground + 1 + random.index(5)) % 6;
    let one = |body: usize| if body == guessed { Said::Guess } else { Said::Nothing };
    let (kind, source) = match case % 4 {
        0 => ("Watt, one guessed", planar(&WATT, ground, one, random)),
        1 => ("Stephenson, one guessed", planar(&STEPHENSON, ground, one, random)),
        2 => ("Watt, all guessed", planar(&WATT, ground, |_| Said::Guess, random)),
        _ => ("Stephenson, all guessed", planar(&STEPHENSON, ground, |_| Said::Guess, random)),
    };
    Closable { kind, source, decided: case % 4 < 2 }
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
    // The rod lies along x, turned by R_y(angle_1) R_z(angle_2).
    let tip = parts.tip(angle);
    let [x, y, z] = [0, 1, 2].map(|k| (tip[k] - parts.rail[k] - travel * parts.along[k]) / rod);
    let universal = case.is_multiple_of(2);
    let cross = match universal {
        true => format!(
            " cross.angle_1 [rad] ~ {:.17}; cross.angle_2 [rad] ~ {:.17};",
            guess((-z).atan2(x), ROUGH),
            guess(y.asin(), ROUGH)
        ),
        false => String::new(),
    };
    let (rough, near) = (guess(angle, ROUGH), guess(travel, 0.3));
    let (kind, start) = match case % 3 {
        0 => ("slider-crank, crank guessed", format!("bearing.angle [rad] ~ {rough:.17};")),
        1 => (
            "slider-crank, all guessed",
            format!("bearing.angle [rad] ~ {rough:.17}; rail.travel [m] ~ {near:.17};{cross}"),
        ),
        _ => (
            "slider-crank, crank stated",
            format!("bearing.angle [rad] = {angle:.17}; rail.travel [m] ~ {near:.17};{cross}"),
        ),
    };
    Closable { kind, source: parts.source(rod, universal, &start), decided: case.is_multiple_of(3) }
}

/// What a definition that closes was answered.
enum Answer {
    Taken,
    /// Two positions of which the guesses prefer neither clearly.
    TwoWays,
    Refused(String),
}

/// A second assembly is a true answer where both positions that it names are taken when they are guessed.
fn answer(source: &str) -> Answer {
    let Err(message) = put_together(source) else { return Answer::Taken };
    let proposed: Vec<&str> =
        message.split('`').filter(|part| part.contains(" [rad] ~ ") && part.ends_with(';')).collect();
    let [one, other] = proposed[..] else { return Answer::Refused(message) };
    let both =
        one != other && [one, other].into_iter().all(|guess| put_together(&guessing(source, guess)).is_ok());
    if both { Answer::TwoWays } else { Answer::Refused(message) }
}

/// The definition with one guess in place of all others.
fn guessing(source: &str, guess: &str) -> String {
    let (before, start) = source.split_once("start {").expect("a start");
    let (start, behind) = start.split_once('}').expect("its end");
    let stated = start.split_inclusive(';').filter(|line| !line.contains('~')).collect::<String>();
    format!("{before}start {{ {stated} {guess} }}{behind}")
}

fn closable(case: usize) -> Closable {
    let mut random = Random::of_case(case);
    match case % 3 {
        0 => four_bar(case / 3, &mut random),
        1 => six_bar(case / 3, &mut random),
        _ => slider_crank(case / 3, &mut random),
    }
}

/// All cases in their order, answered by two threads, because this test is the longest of its program.
fn answers() -> Vec<(Closable, Answer)> {
    let half = cases() / 2;
    let answered = |numbers: Range<usize>| -> Vec<(Closable, Answer)> {
        numbers
            .map(closable)
            .map(|case| {
                let answer = answer(&case.source);
                (case, answer)
            })
            .collect()
    };
    std::thread::scope(|scope| {
        let second = scope.spawn(|| answered(half..cases()));
        let mut all = answered(0..half);
        all.extend(second.join().expect("no case panics"));
        all
    })
}

#[test]
fn what_closes_is_put_together() {
    let (mut tried, mut two_ways) = (BTreeMap::<_, usize>::new(), BTreeMap::<_, usize>::new());
    let mut refused = Vec::new();
    for (case, (closable, answer)) in answers().into_iter().enumerate() {
        *tried.entry(closable.kind).or_default() += 1;
        match answer {
            Answer::Taken => {}
            Answer::TwoWays if closable.decided => {
                refused.push(format!("{case}, two ways\n{}", closable.source))
            }
            Answer::TwoWays => *two_ways.entry(closable.kind).or_default() += 1,
            Answer::Refused(message) => {
                assert!(!message.contains("cannot close"), "{message}\n{}", closable.source);
                refused.push(format!("{case}, {}: {message}\n{}", closable.kind, closable.source));
            }
        }
    }
    println!("refused {}, tried {tried:?}, not decided by their guesses {two_ways:?}", refused.len());
    let shown = refused[..refused.len().min(5)].join("\n");
    assert!(refused.len() * 200 <= cases(), "{} of {} refused:\n{shown}", refused.len(), cases());
}
