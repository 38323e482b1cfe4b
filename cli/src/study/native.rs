//! Machine code for `--native`, if the program has been built with it.

use linkwright_engine::Translator;
use std::sync::Arc;

/// What makes machine code.
#[cfg(feature = "native")]
pub fn translator() -> Result<Arc<dyn Translator>, String> {
    match linkwright_native::Native::new() {
        Ok(native) => Ok(Arc::new(native)),
        Err(error) => Err(format!("--native: {error}")),
    }
}

/// There is nothing to make it.
#[cfg(not(feature = "native"))]
pub fn translator() -> Result<Arc<dyn Translator>, String> {
    Err("--native: this program has been built without machine code; install it with `--features native`, or leave --native out: \
         the interpreter gives the same numbers"
        .to_string())
}
