//! What the benches share: medians of samples, and what is said about the machine.

#[allow(dead_code)]
pub mod library;

use std::process::Command;
use std::time::Instant;

/// The middle one.
#[allow(dead_code)]
pub fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}

/// The least of the samples.
#[allow(dead_code)]
pub fn least(samples: &[f64]) -> f64 {
    samples.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The largest of values that are not negative; NaN if one is.
#[allow(dead_code)]
pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most, value| if value > most || value.is_nan() { value } else { most })
}

/// Seconds that a call takes.
#[allow(dead_code)]
pub fn seconds<T>(call: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = call();
    (result, start.elapsed().as_secs_f64())
}

/// Processor and compiler, for the head of a report.
pub fn machine() -> String {
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = processor.lines().find(|line| line.starts_with(name))?;
        Some(line.split_once(':')?.1.trim().to_string())
    };
    let model = field("model name").unwrap_or(format!("unknown {}", std::env::consts::ARCH));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let version = Command::new("rustc").arg("--version").output();
    let version = version.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_string());
    format!("{model}, {cores} cores, {}", version.unwrap_or("rustc unknown".to_string()))
}
