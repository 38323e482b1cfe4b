//! The process that judges: one line before each case, one after it, so that whoever reads them knows where it stopped.

use crate::{cases, judge, seeds};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Command, ExitCode, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// What a thread of rustc has at least.
const STACK: usize = 2 << 20;

/// What a worker says.
pub enum Report {
    Verdict(u64, String, Duration),
    Fault(u64, String),
    /// It hung or died in this case.
    Stopped(u64, String),
    Done,
}

pub struct Worker {
    child: Child,
    lines: Receiver<String>,
    case: u64,
}

impl Worker {
    pub fn start(seed: u64, from: u64, cases: u64) -> Self {
        let mut child = itself(&["--worker"])
            .args(["--seed", &seed.to_string(), "--from", &from.to_string(), "--cases", &cases.to_string()])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("a process");
        let lines = lines(child.stdout.take().expect("it is piped"));
        Worker { child, lines, case: from }
    }

    pub fn report(&mut self, bound: Duration) -> Report {
        loop {
            let line = match self.lines.recv_timeout(bound) {
                Ok(line) => line,
                Err(RecvTimeoutError::Timeout) => return self.stop(format!("it takes more than {bound:?}")),
                Err(RecvTimeoutError::Disconnected) => {
                    return self.stop("the process died: the stack overflows?".to_string());
                }
            };
            let mut words = line.splitn(3, ' ');
            let mut word = || words.next().unwrap_or_default().to_string();
            match word().as_str() {
                "begin" => self.case = word().parse().unwrap_or(self.case),
                "end" => {
                    let (verdict, time) = (word(), word().parse().unwrap_or(0));
                    return Report::Verdict(self.case, verdict, Duration::from_micros(time));
                }
                "fault" => return Report::Fault(self.case, [word(), word()].join(" ")),
                "done" => return Report::Done,
                _ => {}
            }
        }
    }

    fn stop(&mut self, fault: String) -> Report {
        let _ = self.child.kill();
        Report::Stopped(self.case, fault)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn itself(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::current_exe().expect("this program has a path"));
    command.args(arguments);
    command
}

fn lines(from: impl Read + Send + 'static) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(from).lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
    });
    receive
}

/// What is wrong with a text, found in a process of its own.
pub fn judged(text: &str, bound: Duration) -> Option<String> {
    let mut child = itself(&["--judge"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("a process");
    let lines = lines(child.stdout.take().expect("it is piped"));
    child.stdin.take().expect("it is piped").write_all(text.as_bytes()).unwrap_or_default();
    let fault = match lines.recv_timeout(bound) {
        Ok(line) => line.strip_prefix("fault ").map(str::to_string),
        Err(RecvTimeoutError::Timeout) => Some(format!("it takes more than {bound:?}")),
        Err(RecvTimeoutError::Disconnected) => Some("the process died: the stack overflows?".to_string()),
    };
    let _ = child.kill();
    let _ = child.wait();
    fault
}

/// Judges the text on standard input.
pub fn judge_one() -> ExitCode {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).expect("text");
    judge::keep_panics();
    let judged = on_small_stack(move || {
        let start = Instant::now();
        (judge::judge(&text), start.elapsed())
    });
    match judged {
        (Ok(verdict), time) => {
            println!("{verdict:?} in {time:.1?}");
            ExitCode::SUCCESS
        }
        (Err(fault), _) => {
            println!("fault {fault}");
            ExitCode::FAILURE
        }
    }
}

/// Judges the cases of a run.
pub fn work(seed: u64, from: u64, count: u64) {
    judge::keep_panics();
    on_small_stack(move || {
        let seeds = seeds::all();
        for case in from..from + count {
            println!("begin {case}");
            let text = cases::case(&seeds, seed, case);
            let start = Instant::now();
            match judge::judge(&text) {
                Ok(verdict) => println!("end {verdict:?} {}", start.elapsed().as_micros()),
                Err(fault) => println!("fault {}", fault.replace('\n', " ")),
            }
        }
        println!("done");
    });
}

fn on_small_stack<T: Send + 'static>(run: impl FnOnce() -> T + Send + 'static) -> T {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(run).expect("a thread");
    thread.join().expect("faults are caught")
}
