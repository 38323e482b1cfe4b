//! Shared libraries, loaded at run time.

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::Path;

// `dlopen` and `dlsym` of POSIX.
unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// A library that is never closed, so that what it has stays where it is.
pub struct Library(*mut c_void);

impl Library {
    pub fn open(path: &Path) -> Option<Self> {
        const NOW: c_int = 2;
        let file = CString::new(std::fs::canonicalize(path).ok()?.to_str()?).ok()?;
        // SAFETY: the path ends with zero; what the library does when it is loaded is its maker's, who is the caller's.
        let library = unsafe { dlopen(file.as_ptr(), NOW) };
        (!library.is_null()).then_some(Library(library))
    }

    /// The function of this name.
    ///
    /// # Safety
    /// The library has it with the signature `F`, a function pointer.
    pub unsafe fn function<F: Copy>(&self, name: &str) -> Option<F> {
        assert_eq!(size_of::<F>(), size_of::<*mut c_void>(), "a function pointer");
        let name = CString::new(name).ok()?;
        // SAFETY: the library is open and the name ends with zero.
        let address = unsafe { dlsym(self.0, name.as_ptr()) };
        // SAFETY: the caller's.
        (!address.is_null()).then(|| unsafe { std::mem::transmute_copy(&address) })
    }
}
