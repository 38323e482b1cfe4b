//! Texts of the messages about the assembled mechanism: what is wrong, why, with numbers, and what to write instead.

use super::assemble::Mobility;
use super::assemble::loose::{Loose, Way};
use crate::messages::closest;
use crate::model::{JointWord, Space};

pub fn wrong_freedoms(
    expected: usize,
    mobility: &Mobility,
    loose: &[Loose],
    independent: &[String],
) -> String {
    let found = mobility.generic;
    let mut text = format!("expected {}, found {found}", freedoms(expected));
    if found < expected {
        text += &format!(": {}", counted(mobility));
        return text
            + &format!(
                "; write `degrees_of_freedom = {found};` if that is meant, or let the joints leave more"
            );
    }
    let known: usize = loose.iter().map(|loose| loose.freedoms).sum();
    let mut parts: Vec<String> = loose.iter().map(loose_sentence).collect();
    if known < found - expected && !independent.is_empty() {
        parts
            .push(format!("`independent = ({})` are coordinates that can be chosen", independent.join(", ")));
    }
    if !parts.is_empty() {
        text += &format!(": {}", parts.join("; "));
    }
    if mobility.counted() != found as isize {
        text += &format!(". {}", capital(&counted(mobility)));
    }
    text + &format!("; write `degrees_of_freedom = {found};` if that is meant, or change the joints")
}

/// The freedoms in sentences, for those who ask.
pub fn mobility(mobility: &Mobility) -> String {
    let mut text = format!("{}; {}.", freedoms(mobility.generic), counted(mobility));
    for (of, what) in &mobility.redundant {
        text += &format!(" \"{of}\" repeats what others fix: {}.", direction(what));
    }
    for reason in &mobility.reasons {
        text += &format!(" {}.", capital(reason));
    }
    text
}

fn freedoms(count: usize) -> String {
    format!("{count} {}", if count == 1 { "degree of freedom" } else { "degrees of freedom" })
}

/// `Grübler's count is 6 freedoms of 2 bodies less 4 equations of 2 joints, 2`
fn counted(mobility: &Mobility) -> String {
    let plural =
        |count: usize, one: &str, more: &str| format!("{count} {}", if count == 1 { one } else { more });
    let mut joints = plural(mobility.joints, "joint", "joints");
    if mobility.couplings > 0 {
        joints += &format!(" and {}", plural(mobility.couplings, "coupling", "couplings"));
    }
    format!(
        "Grübler's count is {} of {} less {} of {joints}, {}",
        plural(mobility.apart, "freedom", "freedoms"),
        plural(mobility.bodies, "body", "bodies"),
        plural(mobility.equations, "equation", "equations"),
        mobility.counted()
    )
}

pub fn loose(loose: &Loose) -> String {
    loose_sentence(loose)
}

fn loose_sentence(loose: &Loose) -> String {
    let several = if loose.freedoms > 1 { format!(" ({} freedoms)", loose.freedoms) } else { String::new() };
    format!("{}{several}", how(loose))
}

fn how(loose: &Loose) -> String {
    let bodies: Vec<String> = loose.bodies.iter().map(|body| format!("\"{body}\"")).collect();
    let who = list(&bodies);
    let joints: Vec<String> = loose.joints.iter().map(|joint| format!("\"{joint}\"")).collect();
    let at = list(&joints);
    let own = if loose.bodies.len() == 1 { "its" } else { "their" };
    match loose.way {
        Way::Floating => {
            format!("{who} can move freely: no joint holds {}", if own == "its" { "it" } else { "them" })
        }
        Way::Hanging(JointWord::Revolute | JointWord::Spherical | JointWord::Universal) => {
            format!("{who} can turn freely about {at}")
        }
        Way::Hanging(JointWord::Prismatic) => format!("{who} can slide freely along {at}"),
        Way::Hanging(JointWord::Cylindrical) => format!("{who} can turn about and slide along {at}"),
        Way::Hanging(_) => format!("{who} can move freely at {at}"),
        Way::Spinning { spherical: true } => {
            format!("{who} can spin about {own} own axis between {own} two spherical joints {at}")
        }
        Way::Spinning { spherical: false } => format!("{who} can spin about {own} own axis between {at}"),
        Way::Turning => format!("{who} can turn about {at} while all else stands still"),
        Way::Sliding => format!("{who} can slide between {at} while all else stands still"),
        Way::Otherwise => format!("{who} can move between {at} while all else stands still"),
    }
}

/// Rank that is lost at the start alone. `rank`: there, and a little further on.
pub fn singular_start(
    rank: (usize, usize),
    of: &[String],
    in_line: &[String],
    elsewhere: Option<String>,
) -> String {
    let why = if in_line.is_empty() {
        let of: Vec<String> = of.iter().map(|of| format!("\"{of}\"")).collect();
        format!("singular position: {} {} what the others fix", list(&of), repeats(of.len()))
    } else {
        format!("change point: {} in line", list(in_line))
    };
    let mut text = format!(
        "at the start position the constraints lose rank ({why}): it is {} there and {} a little further on. Several motions \
         meet there and none is determined; start elsewhere",
        rank.0, rank.1
    );
    if let Some(elsewhere) = elsewhere {
        text += &format!(", for example at `{elsewhere}`");
    }
    text
}

/// A structure whose velocities lead nowhere.
pub fn shaky(of: &str, in_line: &[String]) -> String {
    let why = if in_line.is_empty() { String::new() } else { format!(" ({} in line)", list(in_line)) };
    format!(
        "the joints leave no motion but an infinitesimal one{why}: \"{of}\" repeats what the others fix at the start position, \
         the only one there is. Change a length, so that the mechanism can move or is rigid"
    )
}

pub fn repeated_coupling(of: &str) -> String {
    format!(
        "\"{of}\" repeats what the joints and the couplings before it already fix, all along the motion: remove it"
    )
}

/// `quantity`: what the driver moves.
pub fn stuck_driver(of: &str, quantity: &str) -> String {
    format!(
        "the driver \"{of}\" cannot move the mechanism from its start position: {quantity} is at a dead centre there, where \
         its rate is zero whatever else moves, or others hold it. Start elsewhere, or drive another coordinate"
    )
}

/// Rows of one joint that repeat, wherever the mechanism stands.
pub struct Repeated<'a> {
    pub joint: &'a str,
    pub kind: JointWord,
    pub what: &'a [&'a str],
    /// Whether these are all rows of the joint.
    pub whole: bool,
}

pub fn redundant(repeated: &Repeated, mobility: &Mobility, space: Space) -> String {
    let Repeated { joint, kind, what, whole } = *repeated;
    let held: Vec<String> = what.iter().map(|what| direction(what).to_string()).collect();
    let (equations, rank) = (mobility.equations, mobility.equations - mobility.redundant.len());
    let joints = if mobility.joints == 1 {
        "1 joint gives".to_string()
    } else {
        format!("{} joints give", mobility.joints)
    };
    let why = match mobility.reasons.as_slice() {
        [] => String::new(),
        reasons => format!(", because {}", reasons.join("; ")),
    };
    let instead = match freer(space, kind, what) {
        _ if whole => format!("or leave \"{joint}\" out"),
        Some(freer) => format!("or make \"{joint}\" a joint that leaves more freedom: {freer}"),
        None => format!("or let the joints of its loop leave {} more freedoms", what.len()),
    };
    format!(
        "{joints} {equations} constraint equations of rank {rank}, all along the motion: \"{joint}\" ({}) repeats what the \
         others already fix{why}. Grübler's count is {}, the mechanism has {}. Write `options {{ redundant = drop; }}` to \
         leave such equations out (some reactions are then not unique) or `keep` to keep them without a part, {instead}",
        list(&held),
        mobility.counted(),
        freedoms(mobility.generic)
    )
}

fn repeats(count: usize) -> &'static str {
    if count == 1 { "repeats" } else { "repeat" }
}

/// `a`, `a and b`, `a, b and c`.
pub(in crate::check) fn list(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or(String::new(), |first| first.to_uppercase().chain(characters).collect())
}

/// What a row holds, in words.
fn direction(what: &str) -> &str {
    match what {
        "x" => "shifts along x",
        "y" => "shifts along y",
        "z" => "shifts along z",
        "normal_1" => "shifts along x of its axes",
        "normal_2" => "shifts along y of its axes",
        "normal" => "shifts along its normal",
        "axis_1" => "turns about y of its axes",
        "axis_2" => "turns about x of its axes",
        "angle" => "turns about its axis",
        "cross" => "turns across both its axes",
        "twist" => "turns along the shafts",
        other => other,
    }
}

/// A joint that holds what another holds but for these rows, if there is one.
fn freer(space: Space, kind: JointWord, what: &[&str]) -> Option<&'static str> {
    let is_turn = |what: &&&str| matches!(**what, "axis_1" | "axis_2" | "angle" | "cross" | "twist");
    let turns = what.iter().filter(is_turn).count();
    Some(match (space, kind, turns, what.len() - turns) {
        (Space::Planar, JointWord::Fixed, 1, 0) => "revolute",
        (Space::Planar, JointWord::Revolute, 0, 1) | (Space::Planar, JointWord::Prismatic, 1, 0) => {
            "point_on_line"
        }
        (Space::Planar, ..) => return None,
        (_, JointWord::Fixed, 1, 0) => "revolute",
        (_, JointWord::Fixed, 2, 0) | (_, JointWord::Revolute, 1, 0) => "universal",
        (_, JointWord::Fixed, 3, 0) | (_, JointWord::Revolute, 2, 0) | (_, JointWord::Universal, 1, 0) => {
            "spherical"
        }
        (_, JointWord::Revolute, 0, 1) | (_, JointWord::Prismatic, 1, 0) => "cylindrical",
        (_, JointWord::Revolute, 2, 1) => "point_on_line along its axis",
        (_, JointWord::Prismatic, 3, 0) | (_, JointWord::Cylindrical, 2, 0) => "point_on_line",
        (_, JointWord::Planar, 2, 0) => "point_on_plane",
        _ => return None,
    })
}

/// `others`: those that are.
pub fn not_independent(of: &str, others: &[&str]) -> String {
    let instead = match others {
        [] => "leave it out of `independent`".to_string(),
        [only] => format!("write `options {{ independent = {only}; }}`"),
        several => format!("write `options {{ independent = ({}); }}`", several.join(", ")),
    };
    format!(
        "\"{of}\" cannot be independent: the constraints and the coordinates before it already fix it at the start \
         position; {instead}"
    )
}

/// `start` gives more coordinates than there are freedoms: those to keep, and those that could be guesses.
pub struct Overgiven {
    pub freedoms: usize,
    pub keep: Vec<String>,
    pub guess: Vec<String>,
}

fn overgiven(overgiven: Option<Overgiven>) -> Option<String> {
    let Overgiven { freedoms: count, keep, guess } = overgiven?;
    let quoted = |names: &[String]| list(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>());
    let kept = if keep.is_empty() { String::new() } else { format!("keep {} and ", quoted(&keep)) };
    Some(format!(
        "`start` gives {} coordinates of a mechanism with {}: {kept}make {} a guess (`~` instead of `=`)",
        keep.len() + guess.len(),
        freedoms(count),
        quoted(&guess)
    ))
}

pub fn cannot_close(
    of: &str,
    what: &str,
    path: &[String],
    residual: f64,
    start: Option<Overgiven>,
) -> String {
    let (amount, apart) = match what {
        "x" | "y" | "normal" => (format!("{residual:.3} m"), "apart"),
        "angle" => (format!("{:.3} rad", residual.min(1.0).asin()), "off its direction"),
        _ => (format!("{} (SI)", number(residual)), "off"),
    };
    let chain = if path.is_empty() {
        "the mechanism cannot be assembled".to_string()
    } else {
        format!("the loop {} cannot close", path.join(" - "))
    };
    let advice = match overgiven(start) {
        Some(start) => start,
        None => "Check the lengths and the places of its joints, or the conditions in `start`".to_string(),
    };
    format!("{chain}: at the nearest position found \"{of}\" is still {amount} {apart}. {advice}")
}

pub fn cannot_meet_start(
    residual: f64,
    drivers: Vec<(String, String, f64)>,
    start: Option<Overgiven>,
) -> String {
    let mut text = format!(
        "no position meets all conditions of `start`: the nearest one found misses by {} (m or rad)",
        number(residual)
    );
    for (driver, quantity, value) in drivers {
        text += &format!("; the driver \"{driver}\" holds {quantity} at {value:.4} at time zero");
    }
    match overgiven(start) {
        Some(start) => format!("{text}. {start}"),
        None => text + ". Turn a condition into a guess (`~` instead of `=`), or correct its value",
    }
}

pub fn driver_against_rest(driver: &str, quantity: &str, value: f64, residual: f64) -> String {
    format!(
        "the driver \"{driver}\" wants {quantity} at {value:.4} at time zero, which the joints and the conditions of \
         `start` do not allow: the nearest position found misses by {}. Let the law begin where `start` is, or make the \
         condition in `start` a guess (`~` instead of `=`)",
        number(residual)
    )
}

pub fn too_many_drivers(drivers: Vec<String>, freedoms: usize) -> String {
    let plural = if freedoms == 1 { "degree of freedom" } else { "degrees of freedom" };
    format!(
        "{} drivers ({}) act on {freedoms} {plural}, so they cannot all be followed: remove one, or give the mechanism \
         another freedom",
        drivers.len(),
        drivers.join(", ")
    )
}

pub fn counted_and_cut(joint: &str) -> String {
    format!(
        "the turns of \"{joint}\" are counted, because a law, driver, coupling or screw uses its angle, and in space only the \
         angle of a joint that carries a body can be; name another joint in `options {{ cut = … }}`, or use an angle of \
         a joint outside of this loop"
    )
}

pub fn not_counted_in_absolute(joint: &str) -> String {
    format!(
        "the turns of \"{joint}\" are counted, which absolute coordinates in space can do only for one axis that is known at \
         expansion; write `coordinates = tree`"
    )
}

pub fn cannot_start() -> String {
    "no position was found that meets the constraints: check the lengths and places of the joints".to_string()
}

pub fn flipped(of: &str) -> String {
    format!(
        "\"{of}\" can only be assembled the wrong way round (turned by 180 degrees): guess the angles of its bodies in \
         `start`, or state its `angle`"
    )
}

pub fn second_assembly(joint: &str, angle: &str, nearest: f64, next: f64) -> String {
    format!(
        "there are two ways to assemble this mechanism, and `start` does not say which: \"{joint}\" can be at \
         {nearest:.4} rad or at {next:.4} rad. Write one of these in `start`: `{angle} [rad] ~ {nearest:.4};` or \
         `{angle} [rad] ~ {next:.4};`"
    )
}

pub fn second_assembly_unnamed() -> String {
    "there are two ways to assemble this mechanism, and `start` does not say which: guess a travel or a place with `~`"
        .to_string()
}

pub fn rates_conflict(asked: Option<String>, miss: f64) -> String {
    let what = asked.map_or("the constraints".to_string(), |asked| format!("the rate asked of \"{asked}\""));
    format!(
        "no velocities meet all rates of `start`: {what} is missed by {} (SI). The constraints already tie \
         these rates together: state fewer",
        number(miss)
    )
}

pub fn massless(body: &str, velocity: &str) -> String {
    format!(
        "\"{body}\" has no mass or inertia where it needs one: {velocity} is neither carried by any mass nor held by \
         the constraints, so its acceleration is undetermined. Give \"{body}\" a positive mass and inertia, or a joint \
         that holds it"
    )
}

/// A body that spins without inertia about the axis of its spin.
pub fn massless_spin(loose: &Loose) -> String {
    format!(
        "{}, and nothing has inertia about that axis, so its acceleration is undetermined. Make one of these joints universal, \
         or give it a radius or an inertia about its axis",
        loose_sentence(loose)
    )
}

pub fn too_many_operations(function: &str, limit: usize, found: usize) -> String {
    format!(
        "`{function}` takes {found} operations, more than the {limit} expected; raise the limit, or simplify the \
         mechanism"
    )
}

pub fn unknown_function(function: &str, known: &[&str]) -> String {
    match closest(function, known.iter().copied()) {
        Some(similar) => format!("there is no function \"{function}\" to count; did you mean `{similar}`?"),
        None => {
            format!("there is no function \"{function}\" to count; the functions are {}", known.join(", "))
        }
    }
}

/// Three digits behind the point, or powers of ten where those would say nothing.
fn number(value: f64) -> String {
    if (1e-2..1e5).contains(&value.abs()) { format!("{value:.3}") } else { format!("{value:.2e}") }
}
