//! Texts of the messages about budgets.

use super::expenses::Expense;
use crate::functions::Function;
use crate::messages::closest;

/// A change that takes less than is taken now.
pub enum Remedy {
    /// `absolute` or `tree`.
    Coordinates(&'static str),
    /// The function without them.
    WithoutBaumgarte(Function),
    Constants,
    /// The function in independent velocities.
    Independent(Function),
}

pub fn too_many_operations(
    (function, is_default): (&str, bool),
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
    text + &instead((function, is_default), found, "operations", remedies)
}

pub fn too_many_live_values(
    (function, is_default): (&str, bool),
    limit: usize,
    found: usize,
    results: usize,
    remedies: &[(Remedy, usize)],
) -> String {
    format!(
        "`{function}` has up to {found} values alive at once, more than the {limit} expected (it gives {results} \
         results, and each is alive until the end)"
    ) + &instead((function, is_default), found, "live_values", remedies)
}

/// The end of a message about a budget.
fn instead(
    (function, is_default): (&str, bool),
    found: usize,
    what: &str,
    remedies: &[(Remedy, usize)],
) -> String {
    let unit = if what == "operations" { "operations" } else { "live values" };
    let of = if is_default { String::new() } else { format!("({function})") };
    let otherwise =
        if remedies.is_empty() { "let the mechanism do less" } else { "take one of these that need less:" };
    let mut text = format!("\nwrite `{what}{of} <= {found};` if that may be, or {otherwise}");
    for (remedy, count) in remedies {
        text += &match remedy {
            Remedy::Coordinates(word) => {
                format!("\n{count:>7}  {unit} with `options {{ coordinates = {word}; }}`")
            }
            Remedy::WithoutBaumgarte(function) => {
                format!("\n{count:>7}  {unit} by `{}`, without Baumgarte's terms", function.name())
            }
            Remedy::Constants => {
                format!(
                    "\n{count:>7}  {unit} with `const` in place of every `param`, in the same order of elimination"
                )
            }
            Remedy::Independent(function) => format!(
                "\n{count:>7}  {unit} by `{}`, in independent velocities, with `options {{ solution = independent; }}`",
                function.name()
            ),
        };
    }
    text
}

pub fn not_emitted(function: &str) -> String {
    format!(
        "`{function}` is not emitted for this definition, so that there is nothing to count; what is emitted follows from `options {{ emit = …; solution = …; }}`"
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
