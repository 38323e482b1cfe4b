//! What the examples share: the mechanism of the first command, plots, progress, where files go.

use std::path::{Path, PathBuf};

pub mod plots;
pub mod progress;
/// The model that ships, from its own file: all others would be built with the package of the models.
#[path = "../models/src/quick_return.rs"]
pub mod quick_return;

/// `name` in the target directory, which need not be the workspace's own.
pub fn in_target(name: &str) -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    target.unwrap_or_else(|| here.parent().unwrap_or(here).join("target")).join(name)
}
