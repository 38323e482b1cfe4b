//! Names of data files in sources that are read again where nobody knows which file they stood in: from the root of the file system in place of
//! beside that file.

/// A source whose names of files begin at the root.
pub fn from_the_root(source: &str) -> String {
    source.replace("\"data/", concat!("\"", env!("CARGO_MANIFEST_DIR"), "/src/data/"))
}
