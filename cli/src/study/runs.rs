//! Runs with other parameters, on all cores.

use super::inputs::Laws;
use super::methods::{self, AnyEngine, Course, EngineState};
use super::progress::Progress;
use super::record::{Column, Trajectory};
use super::{Failure, start};
use crate::with_engine;
use linkwright_engine::Numbers;
use linkwright_runtime::SettingError;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The engine with these parameters, SI.
pub fn prepared(engine: &AnyEngine, parameters: &[f64]) -> Result<AnyEngine, String> {
    let said = |error: SettingError| error.to_string();
    Ok(match engine {
        AnyEngine::Plain(engine) => AnyEngine::Plain(engine.prepared(parameters).map_err(said)?),
        AnyEngine::Implicit(engine) => AnyEngine::Implicit(engine.prepared(parameters).map_err(said)?),
    })
}

/// A run with these parameters, SI, from the start that they are assembled to.
pub fn run_with(
    engine: &AnyEngine,
    parameters: &[f64],
    laws: &Laws,
    course: &Course,
    columns: &[Column],
) -> Result<Trajectory, String> {
    let engine = prepared(engine, parameters)?;
    let begin = with_engine!(&engine, |engine| start(engine)).map_err(Failure::text)?;
    let mut groups = Vec::new();
    columns.iter().for_each(|column| {
        if !groups.contains(&column.group) {
            groups.push(column.group);
        }
    });
    let mut trajectory = Trajectory::new(columns.to_vec());
    let mut show = |time: f64, state: &EngineState, inputs: &Numbers, outputs: &Numbers| {
        with_engine!(&engine, |engine| trajectory.add(engine, &groups, time, state, inputs, outputs));
    };
    methods::run(&engine, &begin, laws, course, &mut show).map_err(|error| error.to_string())?;
    Ok(trajectory)
}

/// What `one` makes of each index, in their order, as many at a time as there are cores, each with an engine of its own.
pub fn on_all_cores<T: Send>(
    engine: &AnyEngine,
    count: usize,
    one: &(dyn Fn(&AnyEngine, usize) -> Result<T, String> + Sync),
) -> Vec<Result<T, String>> {
    let (next, done, progress) = (AtomicUsize::new(0), AtomicUsize::new(0), Progress::new());
    let cores = std::thread::available_parallelism().map_or(1, usize::from).min(count.max(1));
    let mut found: Vec<(usize, Result<T, String>)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..cores)
            .map(|_| {
                let (engine, next, done, progress) = (engine.clone(), &next, &done, &progress);
                scope.spawn(move || {
                    let mut own = Vec::new();
                    loop {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        if index >= count {
                            return own;
                        }
                        own.push((index, one(&engine, index)));
                        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                        progress.say(|| format!("{done} of {count} runs"));
                    }
                })
            })
            .collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap_or_default()).collect()
    });
    progress.end();
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, result)| result).collect()
}
