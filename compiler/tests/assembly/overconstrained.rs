//! Overconstrained linkages with a stated angle and guesses up to ten degrees off: the rows that repeat others near the start, but
//! not where the guesses are, must not be in the way.

use crate::put_together;
use crate::random::Random;
use linkwright_compiler::Start;

/// The largest error of a guess, degrees.
const OFF: f64 = 10.0;

struct Linkage {
    name: &'static str,
    /// All but `start`.
    parts: String,
    stated: (&'static str, f64),
    /// Angles where it closes, degrees.
    guessed: Vec<(&'static str, f64)>,
}

/// Of Bennett: opposite links alike, sin α / a = sin β / b; closes with tan(θ₁/2) tan(θ₂/2) = sin((β + α)/2) / sin((β − α)/2).
fn bennett(stated: f64) -> Linkage {
    let (alpha, beta, a) = (30.0_f64.to_radians(), 50.0_f64.to_radians(), 0.5);
    let b = a * beta.sin() / alpha.sin();
    let link = |name: &str, length: f64, twist: f64| {
        format!(
            "body {name} {{ mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.1, 0.1);
                 marker near [m] = (0, 0, 0), axis = (0, 0, 1), reference = (1, 0, 0);
                 marker far [m] = ({length:.17}, 0, 0), axis = (0, {:.17}, {:.17}), reference = (1, 0, 0); }}\n",
            -twist.sin(),
            twist.cos()
        )
    };
    let parts = link("base", a, alpha)
        + &link("second", b, beta)
        + &link("third", a, alpha)
        + &link("fourth", b, beta);
    let joints = "joint held: fixed(ground(0, 0, 0) [m], base.origin);
        joint j1: revolute(base.far, second.near);
        joint j2: revolute(second.far, third.near);
        joint j3: revolute(third.far, fourth.near);
        joint j4: revolute(fourth.far, base.near);
        options { redundant = drop; }";
    let ratio = (0.5 * (beta + alpha)).sin() / (0.5 * (beta - alpha)).sin();
    let other = 2.0 * (ratio / (0.5 * stated.to_radians()).tan()).atan().to_degrees();
    let guessed = vec![("j2.angle", -other), ("j3.angle", -stated), ("j4.angle", other)];
    Linkage {
        name: "Bennett",
        parts: format!("spatial Bennett {{ {parts} {joints}"),
        stated: ("j1.angle", stated),
        guessed,
    }
}

/// Of Bricard: a cube's edges.
fn bricard() -> Linkage {
    let parts = "spatial Bricard {
        box rod_1 { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point from [m] = (-0.5, 0, 0); point to [m] = (0.5, 0, 0); }
        box rod_2 { mass [kg] = 1; size [m] = (0.1, 1, 0.1); point from [m] = (0, 0.5, 0);  point to [m] = (0, -0.5, 0); }
        box rod_3 { mass [kg] = 1; size [m] = (0.1, 0.1, 1); point from [m] = (0, 0, -0.5); point to [m] = (0, 0, 0.5); }
        box rod_4 { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point from [m] = (0.5, 0, 0);  point to [m] = (-0.5, 0, 0); }
        box rod_5 { mass [kg] = 1; size [m] = (0.1, 1, 0.1); point from [m] = (0, -0.5, 0); point to [m] = (0, 0.5, 0); }
        joint hinge_1: revolute(ground(0, 0, 0) [m], rod_1.from, axis = (0, 1, 0));
        joint hinge_2: revolute(rod_1.to, rod_2.from, axis = (0, 0, 1));
        joint hinge_3: revolute(rod_2.to, rod_3.from, axis = (1, 0, 0));
        joint hinge_4: revolute(rod_3.to, rod_4.from, axis = (0, 1, 0));
        joint hinge_5: revolute(rod_4.to, rod_5.from, axis = (0, 0, 1));
        joint hinge_6: revolute(rod_5.to, ground(0, 0, 1) [m], axis = (1, 0, 0));
        options { redundant = drop; }";
    let others = ["hinge_2.angle", "hinge_3.angle", "hinge_4.angle", "hinge_5.angle", "hinge_6.angle"];
    Linkage {
        name: "Bricard",
        parts: parts.into(),
        stated: ("hinge_1.angle", 0.0),
        guessed: others.into_iter().map(|of| (of, 0.0)).collect(),
    }
}

/// Of Sarrus: two legs at a right angle.
fn sarrus(stated: f64) -> Linkage {
    let parts = "spatial Sarrus {
        rod lower_a { mass [kg] = 0.4; length [m] = 0.5; }
        rod upper_a { mass [kg] = 0.4; length [m] = 0.5; }
        rod lower_b { mass [kg] = 0.4; length [m] = 0.5; }
        rod upper_b { mass [kg] = 0.4; length [m] = 0.5; }
        box platform { mass [kg] = 1; size [m] = (0.6, 0.6, 0.02);
                       point a [m] = (0.3, 0, 0); marker b [m] = (0, 0.3, 0), about_z [deg] = 90; }
        marker base_b [m] = (0, 0.3, 0), about_z [deg] = 90;
        joint foot_a: revolute(ground(0.3, 0, 0) [m], lower_a.start, axis = (0, -1, 0));
        joint knee_a: revolute(lower_a.end, upper_a.start, axis = (0, -1, 0));
        joint head_a: revolute(upper_a.end, platform.a, axis = (0, -1, 0));
        joint foot_b: revolute(base_b, lower_b.start, axis = (0, -1, 0));
        joint knee_b: revolute(lower_b.end, upper_b.start, axis = (0, -1, 0));
        joint head_b: revolute(upper_b.end, platform.b, axis = (0, -1, 0));
        options { redundant = drop; }";
    let (knee, head) = (180.0 - 2.0 * stated, stated - 180.0);
    let guessed = vec![
        ("knee_a.angle", knee),
        ("head_a.angle", head),
        ("foot_b.angle", stated),
        ("knee_b.angle", knee),
        ("head_b.angle", head),
    ];
    Linkage { name: "Sarrus", parts: parts.into(), stated: ("foot_a.angle", stated), guessed }
}

/// A parallelogram whose coupler hangs on a third crank.
fn third_crank(stated: f64) -> Linkage {
    let parts = "planar ThirdCrank {
        rod one   { mass [kg] = 1; length [m] = 1; }
        rod two   { mass [kg] = 1; length [m] = 1; }
        rod three { mass [kg] = 1; length [m] = 1; }
        body coupler { mass [kg] = 1; inertia [kg*m^2] = 1; point a [m] = (-1, 0); point b [m] = (0.2, 0); point c [m] = (1, 0); }
        joint foot_1: revolute(ground(-1, 0) [m], one.start);
        joint foot_2: revolute(ground(0.2, 0) [m], two.start);
        joint foot_3: revolute(ground(1, 0) [m], three.start);
        joint head_1: revolute(one.end, coupler.a);
        joint head_2: revolute(two.end, coupler.b);
        joint head_3: revolute(three.end, coupler.c);
        options { redundant = drop; }";
    let guessed = vec![("foot_2.angle", stated), ("foot_3.angle", stated), ("coupler.angle", 0.0)];
    Linkage { name: "third crank", parts: parts.into(), stated: ("foot_1.angle", stated), guessed }
}

/// A planar four-bar of revolutes in space: three rows are superfluous.
fn four_bar_in_space(stated: f64) -> Linkage {
    let (crank, coupler, rocker, ground) = (1.0_f64, 2.0_f64, 1.5_f64, 2.0);
    let parts = format!(
        "spatial FourBar {{
        rod crank   {{ mass [kg] = 1; length [m] = {crank}; }}
        rod coupler {{ mass [kg] = 1; length [m] = {coupler}; }}
        rod rocker  {{ mass [kg] = 1; length [m] = {rocker}; }}
        joint pin:   revolute(ground(0, 0, 0) [m], crank.start, axis = (0, 0, 1));
        joint knee:  revolute(crank.end, coupler.start, axis = (0, 0, 1));
        joint wrist: revolute(coupler.end, rocker.end, axis = (0, 0, 1));
        joint foot:  revolute(ground({ground}, 0, 0) [m], rocker.start, axis = (0, 0, 1));
        options {{ redundant = drop; }}"
    );
    let angle = stated.to_radians();
    let [x, y] = [crank * angle.cos() - ground, crank * angle.sin()];
    let diagonal = x.hypot(y);
    let foot = y.atan2(x)
        - ((diagonal * diagonal + rocker * rocker - coupler * coupler) / (2.0 * diagonal * rocker)).acos();
    let end = [ground + rocker * foot.cos(), rocker * foot.sin()];
    let along = (end[1] - crank * angle.sin()).atan2(end[0] - crank * angle.cos());
    let guessed = vec![
        ("knee.angle", (along - angle).to_degrees()),
        ("foot.angle", foot.to_degrees()),
        ("wrist.angle", (foot - along).to_degrees()),
    ];
    Linkage { name: "four-bar in space", parts, stated: ("pin.angle", stated), guessed }
}

fn taken(linkage: &Linkage, errors: &[f64]) -> Result<Start, String> {
    let (of, stated) = linkage.stated;
    let mut source = format!("{} start {{ {of} [deg] = {stated};", linkage.parts);
    for ((of, angle), error) in linkage.guessed.iter().zip(errors) {
        source += &format!(" {of} [deg] ~ {:.6};", angle + error);
    }
    source += " } }";
    put_together(&source).map_err(|message| format!("{}: {message}\n{source}", linkage.name))
}

#[test]
fn a_stated_angle_is_no_contradiction() {
    let mut random = Random::of_case(77);
    let mut linkages = vec![bricard()];
    for stated in [25.0, 70.0, 130.0] {
        linkages.extend([bennett(stated), four_bar_in_space(stated)]);
    }
    for stated in [20.0, 60.0, 75.0] {
        linkages.extend([sarrus(stated), third_crank(stated)]);
    }
    let mut wrong = Vec::new();
    for linkage in &linkages {
        for number in 0..8 {
            // From guesses that are right to those that are far off.
            let off = OFF * f64::from(number) / 7.0;
            let errors: Vec<f64> = linkage.guessed.iter().map(|_| random.between(-off, off)).collect();
            match taken(linkage, &errors) {
                Err(message) => wrong.push(message),
                Ok(start) => {
                    let mobility = &start.assembly.mobility;
                    if mobility.generic != 1 || mobility.redundant.is_empty() {
                        wrong.push(format!(
                            "{} at {}: {errors:?}: {mobility}",
                            linkage.name, linkage.stated.1
                        ));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(6)].join("\n"));
}
