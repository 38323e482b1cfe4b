//! The pages of the commands and the tutorial: every block that begins with `$ linkwright …` shows what the program writes.
//!
//! `UPDATE_GOLDEN=1 cargo test -p linkwright-cli --test documents` writes the blocks anew. Numbers may differ by rounding.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// Words of a command line, quoted ones without their quotes.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quoted) = (Vec::new(), String::new(), false);
    for c in line.chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => words.extend(Some(std::mem::take(&mut word)).filter(|word| !word.is_empty())),
            c => word.push(c),
        }
    }
    words.extend(Some(word).filter(|word| !word.is_empty()));
    words
}

/// What it writes, the error stream behind the other, and the exit code if it is not 0. How long it took is no matter.
fn written(line: &str) -> String {
    let words = words(line);
    assert_eq!(words[..2], ["$", "linkwright"], "{line}");
    let output = Command::new(env!("CARGO_BIN_EXE_linkwright"))
        .args(&words[2..])
        .current_dir(docs())
        .output()
        .expect("the program is built");
    let mut text = String::from_utf8(output.stdout).expect("text");
    text += &String::from_utf8(output.stderr).expect("text");
    if let Some(code) = output.status.code().filter(|code| *code != 0) {
        text += &format!("exit code {code}\n");
    }
    text.lines().map(|line| timeless(line) + "\n").collect()
}

/// Without the time of computing.
fn timeless(line: &str) -> String {
    let Some(end) = line.find(" s of computing") else { return line.to_string() };
    let begin = line[..end].rfind(' ').map_or(0, |at| at + 1);
    format!("{}…{}", &line[..begin], &line[end..])
}

/// Whether two texts differ by nothing but the last digits of numbers.
fn alike(one: &str, other: &str) -> bool {
    fn parts(text: &str) -> Vec<&str> {
        text.split_inclusive([' ', ',', '\n', '(', ')', ':', ';']).collect()
    }
    let (one, other) = (parts(one), parts(other));
    one.len() == other.len()
        && one.iter().zip(&other).enumerate().all(|(at, (a, b))| {
            let number =
                |text: &str| text.trim_end_matches([' ', ',', '\n', '(', ')', ':', ';']).parse::<f64>();
            match (number(a), number(b)) {
                // How far a number may be off is made of rounding.
                (Ok(a), Ok(b)) if at > 0 && one[at - 1] == "± " => a.max(b) < 1e-5,
                (Ok(a), Ok(b)) => (a - b).abs() <= 1e-6 * a.abs().max(1e-6),
                _ => a == b,
            }
        })
}

#[test]
fn pages_show_what_the_program_writes() {
    let mut blocks = 0;
    // Where pages write to.
    fs::create_dir_all(docs().join("../target")).expect("it can be made");
    for page in ["run", "plot", "animate", "sweep", "influence", "draw", "watch", "tutorial"] {
        let path = docs().join(format!("{page}.md"));
        let text = fs::read_to_string(&path).expect("the page");
        let mut new = String::new();
        let mut rest = text.as_str();
        while let Some(at) = rest.find("```text\n$ linkwright ") {
            let (before, block) = rest.split_at(at + "```text\n".len());
            let (block, after) = block.split_at(block.find("```").expect("the block ends"));
            let (line, shown) = block.split_once('\n').expect("the command is a line");
            let found = written(line);
            if std::env::var_os("UPDATE_GOLDEN").is_none() {
                assert!(alike(shown, &found), "{page}.md: {line}\nshown:\n{shown}\nwritten:\n{found}");
            }
            new += before;
            new += &format!("{line}\n{found}");
            rest = after;
            blocks += 1;
        }
        new += rest;
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            fs::write(&path, new).expect("the page can be written");
        }
    }
    assert!(blocks >= 4, "{blocks}");
}

/// `UPDATE_GOLDEN=1` writes it anew, as it does the pages.
#[test]
fn the_picture_with_dimensions_is_what_the_program_draws() {
    let picture = docs().join("crank_rocker_dimensions.svg");
    let output = Command::new(env!("CARGO_BIN_EXE_linkwright"))
        .args(["draw", "mechanisms/crank_rocker.mech", "--dimensions"])
        .current_dir(docs())
        .output()
        .expect("the program is built");
    let drawn = String::from_utf8(output.stdout).expect("text");
    assert!(output.status.success() && output.stderr.is_empty(), "{drawn}");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&picture, &drawn).expect("the picture can be written");
    }
    let kept = fs::read_to_string(&picture).expect("the picture");
    assert!(kept == drawn, "{} is not what is drawn", picture.display());
    for text in [">crank_length = 200 mm<", ">600 mm<", ">0.4 m<", ">0.5 m<"] {
        assert!(kept.contains(text), "{text}");
    }
}
