//! Many definitions that nobody would write, looking for what the compiler may not do.
//!
//! ```text
//! cargo run --profile fuzz -p linkwright-compiler --example fuzz -- [--cases 100000] [--seed 1] [--from 0]
//! cargo run --profile fuzz -p linkwright-compiler --example fuzz -- --judge < FILE
//! cargo run --profile fuzz -p linkwright-compiler --example fuzz -- --print [--seed 1] [--from 0]
//! ```
//! The first generates and judges cases in a process of its own, on a thread with 2 MB of stack, so that overflows and
//! endless loops are found too. A fault is cut down and printed, to be kept in `compiler/tests/fuzz/corpus`. The second
//! judges one text, the third prints one case. The profile `fuzz` is optimised and checks overflows as a macro in a debug build does.

#[path = "../../tests/fuzz/cases.rs"]
mod cases;
#[path = "../../tests/fuzz/judge.rs"]
mod judge;
#[path = "../../tests/fuzz/minimise.rs"]
mod minimise;
#[path = "../../tests/fuzz/mutate.rs"]
mod mutate;
#[path = "../../tests/fuzz/random.rs"]
mod random;
#[path = "../../tests/fuzz/seeds.rs"]
mod seeds;
#[path = "../../tests/fuzz/soup.rs"]
mod soup;
#[path = "../../tests/fuzz/tokens.rs"]
mod tokens;
mod worker;

use std::collections::BTreeMap;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use worker::{Report, Worker};

/// One case may take this long; the largest mechanisms that are admitted take most of it.
const BOUND: Duration = Duration::from_secs(10);

/// Faults of one kind are counted, but only the first is cut down; beyond so many kinds the run ends.
const MOST_KINDS: usize = 20;

fn main() -> ExitCode {
    let flag = |name: &str| std::env::args().any(|argument| argument == name);
    if flag("--judge") {
        return worker::judge_one();
    }
    let (seed, from, cases) = (number("--seed", 1), number("--from", 0), number("--cases", 100_000));
    if flag("--worker") {
        worker::work(seed, from, cases);
        return ExitCode::SUCCESS;
    }
    if flag("--print") {
        println!("{}", cases::case(&seeds::all(), seed, from));
        return ExitCode::SUCCESS;
    }
    let mut run = Run {
        seed,
        total: cases,
        seeds: seeds::all(),
        begin: Instant::now(),
        counts: BTreeMap::new(),
        slowest: (Duration::ZERO, 0),
        faults: BTreeMap::new(),
    };
    run.all(from, from + cases);
    run.end()
}

fn number(name: &str, default: u64) -> u64 {
    let value = std::env::args().skip_while(|argument| argument != name).nth(1);
    value.map_or(default, |value| value.parse().unwrap_or_else(|_| panic!("{name} takes a number")))
}

struct Run {
    seed: u64,
    total: u64,
    /// As they were when the run began.
    seeds: Vec<seeds::Seed>,
    begin: Instant,
    counts: BTreeMap<String, u64>,
    slowest: (Duration, u64),
    /// Faults by what they say, with the numbers of their cases.
    faults: BTreeMap<String, Vec<u64>>,
}

impl Run {
    /// Starts a worker; after one that overflowed or hung, another behind the case.
    fn all(&mut self, mut next: u64, end: u64) {
        while next < end && self.faults.len() < MOST_KINDS {
            let mut worker = Worker::start(self.seed, next, end - next);
            next = loop {
                match worker.report(BOUND) {
                    Report::Done => break end,
                    Report::Verdict(case, word, time) => self.count(case, word, time),
                    Report::Fault(case, fault) => self.fault(case, fault),
                    Report::Stopped(case, fault) => {
                        self.fault(case, fault);
                        break case + 1;
                    }
                }
                if self.faults.len() >= MOST_KINDS {
                    break end;
                }
            };
        }
    }

    fn count(&mut self, case: u64, word: String, time: Duration) {
        self.slowest = self.slowest.max((time, case));
        *self.counts.entry(word).or_default() += 1;
        self.progress();
    }

    fn progress(&self) {
        let done: u64 = self.counts.values().sum();
        if done.is_multiple_of(1000) {
            let seconds = self.begin.elapsed().as_secs_f64();
            eprint!(
                "\r{done} of {} cases, {} kinds of faults, {seconds:.0} s ",
                self.total,
                self.faults.len()
            );
        }
    }

    fn fault(&mut self, case: u64, fault: String) {
        *self.counts.entry("fault".to_string()).or_default() += 1;
        let kind: String = fault.chars().filter(|c| !c.is_ascii_digit()).take(120).collect();
        let cases = self.faults.entry(kind).or_default();
        cases.push(case);
        if cases.len() == 1 {
            println!("\ncase {case}: {fault}");
            let text = cases::case(&self.seeds, self.seed, case);
            let signature: String = fault.chars().take(60).collect();
            let least = minimise::minimise(&text, |text| {
                worker::judged(text, BOUND).is_some_and(|other| other.starts_with(&signature))
            });
            println!("{least}");
        }
    }

    fn end(&self) -> ExitCode {
        let (time, case) = self.slowest;
        println!("\nseed {}: {:?}, slowest case {case} in {time:.1?}", self.seed, self.counts);
        for (kind, cases) in &self.faults {
            println!("{} times, first case {}: {kind}", cases.len(), cases[0]);
        }
        if self.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
