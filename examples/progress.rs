//! Progress of work that takes longer than a second, on the terminal's last line.

use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Says how far something is, once it has taken a second.
pub struct Progress {
    what: String,
    total: usize,
    next: Instant,
    shown: bool,
}

impl Progress {
    /// Begins work of `total` parts.
    pub fn new(what: &str, total: usize) -> Progress {
        Progress {
            what: what.to_string(),
            total,
            next: Instant::now() + Duration::from_secs(1),
            shown: false,
        }
    }

    /// `done` parts are finished.
    pub fn at(&mut self, done: usize) {
        if Instant::now() < self.next {
            return;
        }
        let share = 100.0 * done as f64 / self.total as f64;
        if stderr().is_terminal() {
            eprint!("\r\x1b[K  {}: {share:.0} %", self.what);
            let _ = stderr().flush();
            self.next += Duration::from_millis(200);
        } else {
            eprintln!("  {}: {share:.0} %", self.what);
            self.next += Duration::from_secs(5);
        }
        self.shown = true;
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown && stderr().is_terminal() {
            eprint!("\r\x1b[K");
        }
    }
}
