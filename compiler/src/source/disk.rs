//! Files by the names that definitions and macros give them: where they are, and what can be wrong with them.

use super::Source;
use crate::messages;
use crate::syntax::OnDisk;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The file of that name as seen from the Rust file that names it, which is not known everywhere.
pub fn read(name: &str, caller: Option<&Path>) -> Result<Source, String> {
    let manifest = manifest();
    let (folder, beside) = match caller {
        Some(file) => {
            (file.parent().unwrap_or(Path::new("")), messages::beside_caller(&file.display().to_string()))
        }
        None => (manifest.as_path(), messages::beside_manifest(&manifest.display().to_string())),
    };
    open_from(&folder.join(name), &beside)
}

/// Where a file that has been read is, and the folder that its name was taken from.
pub(super) fn on_disk(source: &Source, caller: Option<PathBuf>) -> Result<OnDisk, String> {
    let absolute = |path: &Path| std::path::absolute(path).ok()?.to_str().map(str::to_string);
    let path = absolute(Path::new(&source.name)).ok_or_else(|| messages::path_not_unicode(&source.name))?;
    let caller = caller.unwrap_or_else(|| manifest().join("Cargo.toml"));
    let folder = absolute(caller.parent().unwrap_or(&caller)).unwrap_or_default();
    Ok(OnDisk { path, folder })
}

/// The folder of the Cargo.toml that is being built.
fn manifest() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default()
}

/// The file of that path as seen from where the program runs.
pub fn open(path: &Path) -> Result<Source, String> {
    let here = std::env::current_dir().map(|folder| folder.display().to_string()).unwrap_or_default();
    open_from(path, &messages::from_folder(&here))
}

/// `from` says where the path begins.
fn open_from(path: &Path, from: &str) -> Result<Source, String> {
    let shown = path.display().to_string();
    if path.is_dir() {
        return Err(messages::is_directory(&shown));
    }
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => messages::no_file(&shown, from, similar(path).as_deref()),
        _ => messages::unreadable_file(&shown, &error.to_string()),
    })?;
    text(&shown, bytes)
}

/// The bytes of a file as text.
pub fn text(name: &str, bytes: Vec<u8>) -> Result<Source, String> {
    String::from_utf8(bytes).map(|text| Source::new(name, text)).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let valid = Source::new(name, String::from_utf8_lossy(valid));
        let at = valid.position(valid.text.len());
        messages::not_utf8(name, at.line, at.column)
    })
}

/// The file in the same folder whose name is nearest.
fn similar(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let names =
        std::fs::read_dir(folder).ok()?.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names.collect();
    names.sort_unstable();
    messages::closest(name, names.iter().map(String::as_str)).map(str::to_string)
}
