//! Texts about tables: how they are written, what they hold, and where they may stand.

use super::closest;

// ---- How a table is written ------------------------------------------------------------------------------------------

pub(crate) fn table_without_arguments(name: &str) -> String {
    format!(
        "the head of a table is written as its call, with units: `table {name}(angle [deg]) [mm] = …` is called by `{name}(crank.angle)`"
    )
}

pub(crate) fn table_of_arguments(name: &str, count: usize) -> String {
    format!("a table has one argument, or two if it is a grid; `{name}` is written with {count}")
}

pub(crate) fn table_file_without_name() -> String {
    "the file of a table is named by a string: write `file(\"cam.csv\")`".to_string()
}

pub(crate) fn negative_skip(lines: i64) -> String {
    format!("{lines} lines cannot be skipped: `skip` is how many stand before the first one of the table")
}

pub(crate) fn table_word_twice(name: &str) -> String {
    format!("this is said of `{name}` already: leave one of the two out")
}

pub(crate) fn unknown_outside(word: &str) -> String {
    format!(
        "a table goes on outside of its knots as `linear`, with value and slope at the end, or as `hold`, with the value alone; \
         \"{word}\" is neither"
    )
}

pub(crate) fn unknown_interpolation(word: &str, known: &[&str]) -> String {
    let hint = match closest(word, known.iter().copied()) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None => format!("there are {}, and `outside = …`, `columns = …`", known.join(", ")),
    };
    format!("a table goes on between its knots in no way called \"{word}\"; {hint}")
}

pub(crate) fn columns_without_file() -> String {
    "`columns` are those of a file: leave it out, the points are written here".to_string()
}

pub(crate) fn interpolation_of(word: &str, arguments: usize, found: usize) -> String {
    let count = |count| if count == 1 { "one argument" } else { "two arguments" };
    format!("`{word}` is for tables of {}, and this one has {}", count(arguments), count(found))
}

pub(crate) fn table_data_of(name: &str, arguments: usize) -> String {
    match arguments {
        1 => format!("`{name}` has one argument: write its points as `[(x, y), …]` or name a `file(\"…\")`"),
        _ => format!(
            "`{name}` has two arguments: write it as `grid((x, …), (y, …), [(z, …), …])`, a row for each y, or name a `file(\"…\")`"
        ),
    }
}

pub(crate) fn outside_of_periodic() -> String {
    "what is periodic has no outside: leave `outside` out".to_string()
}

// ---- What it holds ---------------------------------------------------------------------------------------------------

pub(crate) fn knot_of(name: &str) -> String {
    format!("a knot of `{name}`")
}

pub(crate) fn value_of(name: &str) -> String {
    format!("a value of `{name}`")
}

/// Behind a message on a number that was read from a file.
pub(crate) fn in_line(file: &str, line: Option<usize>) -> String {
    match line {
        Some(line) => format!(" (line {line} of `{file}`)"),
        None => String::new(),
    }
}

pub(crate) fn few_knots(name: &str, count: usize, kind: &str, least: usize) -> String {
    let or = match kind {
        _ if count < 2 => "",
        "bicubic" => ", or write `bilinear`",
        _ => ", or write `linear`",
    };
    format!("`{name}` has {count} knots along an argument, and `{kind}` takes at least {least}: add some{or}")
}

pub(crate) fn many_knots(name: &str, count: usize, most: usize) -> String {
    format!("`{name}` has {count} values and may have {most}: leave out those that its neighbours tell")
}

/// `place`: where it was read, if it was.
pub(crate) fn knots_descend(name: &str, before: &str, own: &str, place: &str) -> String {
    let relation = if before == own { "stands there twice".to_string() } else { format!("follows {before}") };
    format!("the knots of `{name}` ascend, but {own} {relation}{place}: sort them, each once")
}

/// First and last value, and their difference.
pub(crate) fn period_does_not_close(name: &str, [first, last, gap]: &[String; 3]) -> String {
    format!(
        "`{name}` is periodic and ends on another value than it begins with, {last} in place of {first}: they differ by {gap}. Write \
         the same value at both ends"
    )
}

pub(crate) fn grid_rows(name: &str, found: usize, argument: &str, expected: usize) -> String {
    format!(
        "`{name}` has {found} rows of values for {expected} of `{argument}`: a grid has one row for each value of the second argument"
    )
}

pub(crate) fn grid_columns(name: &str, found: usize, argument: &str, expected: usize) -> String {
    format!(
        "this row of `{name}` has {found} values for {expected} of `{argument}`: it has one for each value of the first argument"
    )
}

// ---- Files -----------------------------------------------------------------------------------------------------------

/// Before what is wrong there.
pub(crate) fn place_in_file(file: &str, line: usize, column: usize) -> String {
    format!("`{file}`, line {line}, column {column}: ")
}

pub(crate) fn columns_of_grid(name: &str) -> String {
    format!(
        "`{name}` has two arguments, and is read from all columns: the first line has the values of the first argument behind a field \
         that is left out, each line behind it one of the second argument and the values there"
    )
}

pub(crate) fn csv_empty(file: &str) -> String {
    format!("`{file}` has no line of numbers behind those that are skipped")
}

pub(crate) fn csv_ragged(found: usize, expected: usize) -> String {
    format!(
        "this line has {found} fields, and the first one that is read has {expected}: lines before the table are left out by `skip`"
    )
}

pub(crate) fn csv_no_number(field: &str) -> String {
    format!("\"{field}\" is no number: numbers have a decimal point, and comments begin with `#`")
}

pub(crate) fn csv_no_such_column(number: usize, count: usize) -> String {
    format!("there is no column {number}: the file has {count}, counted from 1")
}

pub(crate) fn csv_no_column(name: &str, names: &[&str]) -> String {
    let hint = match (closest(name, names.iter().copied()), names) {
        (_, []) => "its columns have no names, and are told by their numbers, `columns = (1, 2)`".to_string(),
        (Some(similar), _) => format!("did you mean \"{similar}\"?"),
        (None, names) => format!("there are {}", names.join(", ")),
    };
    format!("the file has no column called \"{name}\"; {hint}")
}

// ---- Where it stands -------------------------------------------------------------------------------------------------

pub(crate) fn argument_of_table(argument: &str, table: &str) -> String {
    format!("the argument `{argument}` of `{table}`")
}

pub(crate) fn table_in_constant(name: &str) -> String {
    format!(
        "`{name}` is not known here: tables are made of constants, so that constants and tables name none; write the number"
    )
}

pub(crate) fn table_without_call(name: &str) -> String {
    format!("`{name}` is a table: its argument stands in parentheses behind it, as in `{name}(x)`")
}

pub(crate) fn slope_of_grid(name: &str) -> String {
    format!("`{name}` has two arguments and a slope along each: `slope` is of tables of one argument")
}

pub(crate) fn table_with_corners(name: &str, text: &str, what: &str) -> String {
    let of = if name == text { String::new() } else { format!(" (in `{text}`)") };
    format!(
        "the slope of `{name}`{of} jumps at its knots, but {what} is differentiated twice: write `cubic`, `natural` or `periodic` behind \
         the table"
    )
}

pub(crate) fn accelerations_jump(name: &str) -> String {
    format!(
        "accelerations jump at the knots of `{name}`: write `cubic`, `natural` or `periodic` behind the table, or `#[allow(kinks)]` \
         before this"
    )
}
