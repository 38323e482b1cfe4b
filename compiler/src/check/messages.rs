//! Texts of the messages about the assembled mechanism: what is wrong, why, with numbers, and what to write instead.

use super::expenses::Expense;
use crate::functions::Function;
use crate::messages::closest;
use crate::model::Space;

pub fn wrong_freedoms(expected: usize, found: usize, free: Vec<String>) -> String {
    let plural = |n: usize| if n == 1 { "degree of freedom" } else { "degrees of freedom" };
    let mut text = format!("expected {expected} {}, found {found}", plural(expected));
    if found > expected && !free.is_empty() {
        text += &format!(": {} can still move", free.join(", "));
    }
    text + &format!("; write `degrees_of_freedom = {found};` if that is meant, or change the joints")
}

/// `what`: the rows of one joint or constraint that add nothing.
pub fn dependent_rows(of: &str, what: &[&str], rows: usize, rank: usize) -> String {
    let what = what.join(", ");
    if rows == 1 {
        return format!(
            "the constraint equation of \"{of}\" ({what}) holds nothing at the start position: it is singular there \
             (a dead centre), and the motion is undetermined. Start elsewhere"
        );
    }
    format!(
        "{rows} constraint equations close the loops, and at the start position their rank is {rank}: \"{of}\" ({what}) \
         repeats what the others already fix. Either the joint is redundant: make it one that leaves more freedom; or \
         the start is a singular position (links in line), where the motion is undetermined: start elsewhere"
    )
}

/// Rows of one joint that repeat, wherever the mechanism stands.
pub fn redundant(of: &str, what: &[&str], rows: usize, rank: usize, space: Space) -> String {
    let held: Vec<&str> = what.iter().map(|what| direction(what)).collect();
    let repeats = if what.len() == 1 { "repeats" } else { "repeat" };
    let freer = match space {
        Space::Planar => "point_on_line",
        Space::Spatial => freer(what),
    };
    format!(
        "the joints that close the loops give {rows} constraint equations of rank {rank}, all along the motion: those of \
         \"{of}\" against {} {repeats} what the others already fix. Write `options {{ redundant = drop; }}` to leave such \
         equations out (some reactions are then not unique), or make \"{of}\" a joint that leaves more freedom, such as \
         {freer}",
        held.join(", ")
    )
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

/// Joints that do not hold what these rows hold.
fn freer(what: &[&str]) -> &'static str {
    let turns = what.iter().any(|what| matches!(*what, "axis_1" | "axis_2" | "angle" | "cross" | "twist"));
    let shifts = what.iter().any(|what| !matches!(*what, "axis_1" | "axis_2" | "angle" | "cross" | "twist"));
    match (turns, shifts) {
        (true, false) => "universal or spherical",
        (false, _) => "cylindrical or planar",
        (true, true) => "spherical, point_on_line or point_on_plane",
    }
}

pub fn not_independent(of: &str) -> String {
    format!(
        "\"{of}\" cannot be independent: the constraints and the coordinates before it already fix it at the start \
         position; leave it out of `independent`"
    )
}

pub fn cannot_close(of: &str, what: &str, path: &[String], residual: f64) -> String {
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
    format!(
        "{chain}: at the nearest position found \"{of}\" is still {amount} {apart}. Check the lengths and the places \
         of its joints, or the conditions in `start`"
    )
}

pub fn cannot_meet_start(residual: f64, drivers: Vec<(String, String, f64)>) -> String {
    let mut text = format!(
        "no position meets all conditions of `start`: the nearest one found misses by {} (m or rad)",
        number(residual)
    );
    for (driver, quantity, value) in drivers {
        text += &format!("; the driver \"{driver}\" holds {quantity} at {value:.4} at time zero");
    }
    text + ". Turn a condition into a guess (`~` instead of `=`), or correct its value"
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

/// What takes less than is taken now.
pub enum Remedy {
    /// `absolute` or `tree`.
    Coordinates(&'static str),
    WithoutBaumgarte,
    Constants,
    NullSpace,
}

pub fn too_many_operations(
    function: &str,
    limit: usize,
    found: usize,
    table: &[Expense],
    remedies: &[(Remedy, usize)],
) -> String {
    let mut text = format!("`{function}` takes {found} operations, more than the {limit} expected:");
    for Expense { purpose, operations, most } in table {
        text += &format!("\n{operations:>7}  {purpose}");
        let most: Vec<String> =
            most.iter().map(|(of, operations)| format!("\"{of}\" {operations}")).collect();
        if !most.is_empty() {
            text += &format!(" (for itself alone {})", most.join(", "));
        }
    }
    text + &instead(function, found, "operations", remedies)
}

pub fn too_many_live_values(
    function: &str,
    limit: usize,
    found: usize,
    results: usize,
    remedies: &[(Remedy, usize)],
) -> String {
    format!(
        "`{function}` has up to {found} values alive at once, more than the {limit} expected (it gives {results} \
         results, and each is alive until the end)"
    ) + &instead(function, found, "live_values", remedies)
}

/// The end of a message about a budget.
fn instead(function: &str, found: usize, what: &str, remedies: &[(Remedy, usize)]) -> String {
    let unit = if what == "operations" { "operations" } else { "live values" };
    let of = if function == Function::AccelerationBaumgarte.name() {
        String::new()
    } else {
        format!("({function})")
    };
    let otherwise =
        if remedies.is_empty() { "let the mechanism do less" } else { "take one of these that need less:" };
    let mut text = format!("\nwrite `{what}{of} <= {found};` if that may be, or {otherwise}");
    for (remedy, count) in remedies {
        text += &match remedy {
            Remedy::Coordinates(word) => {
                format!("\n{count:>7}  {unit} with `options {{ coordinates = {word}; }}`")
            }
            Remedy::WithoutBaumgarte => {
                format!("\n{count:>7}  {unit} by `acceleration`, without Baumgarte's terms")
            }
            Remedy::Constants => {
                format!(
                    "\n{count:>7}  {unit} with `const` in place of every `param`, in the same order of elimination"
                )
            }
            Remedy::NullSpace => format!(
                "\n{count:>7}  {unit} by `null_space`, the accelerations in independent velocities, with `options {{ emit = \
                 (null_space); }}`"
            ),
        };
    }
    text
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
