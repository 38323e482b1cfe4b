//! How far something long is, on a terminal.

use std::io::{IsTerminal, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What takes longer says how far it is, so often.
const PATIENCE: Duration = Duration::from_millis(500);

/// How far something is, told by any thread.
pub struct Progress {
    /// When it was last said, at first the beginning; whether it was.
    said: Mutex<(Instant, bool)>,
}

impl Progress {
    pub fn new() -> Self {
        Progress { said: Mutex::new((Instant::now(), false)) }
    }

    /// Says this in place of what was said before, if that is long ago.
    pub fn say(&self, text: impl FnOnce() -> String) {
        // Who finds it locked leaves it to another.
        if let Ok(mut said) = self.said.try_lock()
            && said.0.elapsed() >= PATIENCE
        {
            said.0 = Instant::now();
            if stderr().is_terminal() {
                said.1 = true;
                eprint!("\r{} ", text());
            }
        }
    }

    /// Takes it away.
    pub fn end(&self) {
        if self.said.lock().is_ok_and(|said| said.1) {
            eprint!("\r{:60}\r", "");
        }
    }
}
