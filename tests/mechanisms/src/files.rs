//! Names of data files in sources that are read again where nobody knows which file they stood in: from the root of the file system in place of
//! beside that file.

/// How names of files begin here, and where they are.
const BESIDE: &[u8] = b"\"data/";
const FOLDER: &[u8] = concat!("\"", env!("CARGO_MANIFEST_DIR"), "/src/data/").as_bytes();

/// Of the text that [`from_the_root`] makes.
pub const fn length(source: &str) -> usize {
    let (bytes, mut at, mut length) = (source.as_bytes(), 0, source.len());
    while at < bytes.len() {
        if begins(bytes, at) {
            length += FOLDER.len() - BESIDE.len();
        }
        at += 1;
    }
    length
}

pub const fn from_the_root<const LENGTH: usize>(source: &str) -> [u8; LENGTH] {
    let (bytes, mut found) = (source.as_bytes(), [0; LENGTH]);
    let (mut from, mut to) = (0, 0);
    while from < bytes.len() {
        if begins(bytes, from) {
            let mut k = 0;
            while k < FOLDER.len() {
                found[to + k] = FOLDER[k];
                k += 1;
            }
            to += FOLDER.len();
            from += BESIDE.len();
        } else {
            found[to] = bytes[from];
            to += 1;
            from += 1;
        }
    }
    found
}

pub const fn text(bytes: &[u8]) -> &str {
    match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(_) => panic!("a text stays one"),
    }
}

const fn begins(bytes: &[u8], at: usize) -> bool {
    let mut k = 0;
    while k < BESIDE.len() {
        if at + k >= bytes.len() || bytes[at + k] != BESIDE[k] {
            return false;
        }
        k += 1;
    }
    true
}
