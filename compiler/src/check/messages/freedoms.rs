//! Texts about degrees of freedom: counted and true, redundant equations, singular starts, bodies that move alone.

use super::{freedoms, list};
use crate::check::assemble::Mobility;
use crate::check::assemble::loose::{Loose, Way};
use crate::forms::RowForm;
use crate::forms::row::Measures;
use crate::forms::{Alone, Freer, JointForm};

pub fn wrong_freedoms(
    expected: usize,
    mobility: &Mobility,
    loose: &[Loose],
    independent: &[String],
    drivers: usize,
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
    let mut parts: Vec<String> = loose.iter().map(self::loose).collect();
    if known < found - expected && !independent.is_empty() {
        parts
            .push(format!("`independent = ({})` are coordinates that can be chosen", independent.join(", ")));
    }
    if !parts.is_empty() {
        text += &format!(": {}", parts.join("; "));
    }
    if mobility.counted() != found as isize {
        let reasons: String = mobility.reasons.iter().map(|reason| format!("; {reason}")).collect();
        text += &format!(". {}{reasons}", capital(&counted(mobility)));
    }
    if drivers > 0 && expected + drivers == found {
        text += ". Drivers are not counted: these are the freedoms that they move";
    }
    if !mobility.yielding.is_empty() {
        text += &format!(". {}", yielding(mobility));
    }
    let hangs = |loose: &Loose| matches!(loose.way, Way::Floating | Way::Hanging(_));
    let missing = match loose.iter().any(hangs) {
        true => "or add the joint or gear that is missing",
        false => "or change the joints",
    };
    text + &format!("; write `degrees_of_freedom = {found};` if that is meant, {missing}")
}

/// The freedoms in sentences, for those who ask.
pub fn mobility(mobility: &Mobility) -> String {
    let mut text = format!("{}; {}.", freedoms(mobility.generic), counted(mobility));
    if !mobility.yielding.is_empty() {
        text += &format!(" {}.", yielding(mobility));
    }
    for (of, row) in &mobility.redundant {
        text += &format!(" \"{of}\" repeats what others fix: {}.", row.prevents);
    }
    for reason in &mobility.reasons {
        text += &format!(" {}.", capital(reason));
    }
    text
}

/// `Joints that yield or have play take no freedoms away: "knee"`
fn yielding(mobility: &Mobility) -> String {
    let names: Vec<String> = mobility.yielding.iter().map(|name| format!("\"{name}\"")).collect();
    format!("Joints that yield or have play take no freedoms away: {}", names.join(", "))
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

/// The bodies that move alone, and how.
pub fn loose(loose: &Loose) -> String {
    let several = if loose.freedoms > 1 { format!(" ({} freedoms)", loose.freedoms) } else { String::new() };
    format!("{}{several}", how(loose))
}

fn how(loose: &Loose) -> String {
    let bodies: Vec<String> = loose.bodies.iter().map(|body| format!("\"{}\"", body.text)).collect();
    let who = list(&bodies);
    let joints: Vec<String> = loose.joints.iter().map(|joint| format!("\"{}\"", joint.text)).collect();
    let at = list(&joints);
    let own = if loose.bodies.len() == 1 { "its" } else { "their" };
    match loose.way {
        Way::Floating => {
            format!("{who} can move freely: no joint holds {}", if own == "its" { "it" } else { "them" })
        }
        Way::Hanging(Alone::Turns) => {
            format!("{who} can turn freely about {at}")
        }
        Way::Hanging(Alone::Slides) => format!("{who} can slide freely along {at}"),
        Way::Hanging(Alone::TurnsAndSlides) => format!("{who} can turn about and slide along {at}"),
        Way::Hanging(Alone::Otherwise) => format!("{who} can move freely at {at}"),
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

/// Rows of a joint repeat others, but nowhere the same ones.
pub fn no_choice(of: &str) -> String {
    format!(
        "\"{of}\" repeats what the others fix, but which of its equations do so changes along the motion, and no few choices of \
         them hold everywhere. Give a joint of the loop more freedom (`spherical`, `cylindrical`, `universal`), so that nothing repeats"
    )
}

/// `quantity`: what the driver moves.
pub fn stuck_driver(of: &str, quantity: &str) -> String {
    format!(
        "the driver \"{of}\" cannot move the mechanism from its start position: {quantity} is at a dead centre there, where \
         its rate is zero whatever else moves. Start elsewhere, or drive another coordinate"
    )
}

/// A coordinate that never moves.
pub fn held_driver(of: &str, quantity: &str) -> String {
    format!(
        "the driver \"{of}\" cannot move {quantity}: the joints hold it wherever the mechanism stands. Drive a coordinate that \
         they leave free, or change the joints"
    )
}

/// No freedom at all.
pub fn nothing_to_drive(of: &str) -> String {
    format!(
        "the driver \"{of}\" has nothing to move: the joints leave the mechanism no degree of freedom, so that it is a rigid \
         structure. Remove the driver, or let the joints leave a freedom"
    )
}

/// Drivers by their names and what they move: the first follows from the others.
pub fn drives_the_same((of, quantity): (&str, &str), others: &[(&str, &str)]) -> String {
    let names: Vec<String> = others.iter().map(|(of, _)| format!("\"{of}\"")).collect();
    let quantities: Vec<String> = others.iter().map(|(_, quantity)| quantity.to_string()).collect();
    let (moves, why) = match others {
        [(_, other)] if *other == quantity => (repeated_verb(1), format!("both drive {quantity}")),
        _ => (repeated_verb(others.len()), format!("{quantity} follows from {}", list(&quantities))),
    };
    format!(
        "the driver \"{of}\" moves what {} {moves} already: {why}. Remove one of the {} drivers, or give the mechanism another \
         freedom",
        list(&names),
        others.len() + 1
    )
}

fn repeated_verb(count: usize) -> &'static str {
    if count == 1 { "moves" } else { "together move" }
}

/// The note at one of the others.
pub fn drives_too((of, quantity): (&str, &str), (rival, _): (&str, &str)) -> String {
    format!("the driver \"{of}\" is here: it moves {quantity}, and so what \"{rival}\" moves")
}

/// The note at `expect`.
pub fn freedoms_expected(expected: usize, found: usize) -> String {
    format!("{} expected here, and {found} found", freedoms_are(expected))
}

fn freedoms_are(count: usize) -> String {
    format!("{} {}", freedoms(count), if count == 1 { "is" } else { "are" })
}

/// Rows of one joint that repeat, wherever the mechanism stands.
pub struct Repeated<'a> {
    pub joint: &'a str,
    pub form: &'static JointForm,
    pub rows: &'a [&'static RowForm],
    /// Whether these are all rows of the joint.
    pub whole: bool,
}

pub fn redundant(repeated: &Repeated, mobility: &Mobility) -> String {
    let Repeated { joint, form, rows, whole } = *repeated;
    let held: Vec<String> = rows.iter().map(|row| row.prevents.to_string()).collect();
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
    let instead = match freer(form, rows) {
        _ if whole => format!("or leave \"{joint}\" out"),
        Some(freer) => format!("or make \"{joint}\" a joint that leaves more freedom: {freer}"),
        None => format!("or let the joints of its loop leave {} more freedoms", rows.len()),
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

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or(String::new(), |first| first.to_uppercase().chain(characters).collect())
}

/// A joint that holds what another holds but for these rows, if there is one.
fn freer(form: &JointForm, rows: &[&RowForm]) -> Option<&'static str> {
    let turns = rows.iter().filter(|row| row.measures == Measures::Direction).count();
    let fits = |freer: &&Freer| freer.turns == turns && freer.shifts == rows.len() - turns;
    form.freer.iter().find(fits).map(|freer| freer.joint)
}

/// A body that spins without inertia about the axis of its spin.
pub fn massless_spin(loose: &Loose) -> String {
    format!(
        "{}, and nothing has inertia about that axis, so its acceleration is undetermined. Make one of these joints universal, \
         or give it a radius or an inertia about its axis",
        self::loose(loose)
    )
}
