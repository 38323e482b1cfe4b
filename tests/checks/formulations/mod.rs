//! Formulations: each against the equations it stands for, on every model; all of them on published runs.

mod beside;
mod equations;
mod leading;
mod runs;
mod settings;
mod singular;
