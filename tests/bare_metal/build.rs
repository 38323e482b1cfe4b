//! Where the linker finds the map of the memory. All models are more than four megabytes of flash: in their image, code stands in the memory
//! beside it, which the two boards have at different places.

use std::env;
use std::path::PathBuf;

fn main() {
    println!("cargo:rerun-if-changed=memory.x");
    println!("cargo:rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "none") {
        let origin = if env::var_os("CARGO_FEATURE_DOUBLE").is_some() { 0x6000_0000 } else { 0x2100_0000 };
        let script = PathBuf::from(env::var_os("OUT_DIR").expect("a folder")).join("code.x");
        let text = format!(
            "MEMORY {{ CODE : ORIGIN = {origin:#x}, LENGTH = 16M }}\n\
             SECTIONS {{ .code : ALIGN(4) {{ *(.text .text.*); }} > CODE }} INSERT BEFORE .text;\n"
        );
        std::fs::write(&script, text).expect("a script for the linker");
        // Before the other, because a section goes where the first pattern matches.
        println!("cargo:rustc-link-arg-bin=every=-T{}", script.display());
        println!("cargo:rustc-link-arg=-Tlink.x");
    }
}
