//! The documentation of a model's struct: one line, and the page of `page` where only rustdoc makes it.

use super::{Emitter, quoted};
use std::fmt::Write;

/// ```text
/// #[doc = ""]
/// #[doc = "Equations of motion of the planar mechanism `FourBar`."]
/// #[cfg_attr(doc, doc = ::linkwright::__private::v1::mechanism_page! { pub planar FourBar { … } })]
/// ```
/// A macro in an attribute is expanded only where the attribute is kept, so that other builds do not pay for the page.
pub fn model(text: &mut String, emitter: &Emitter, source: &str) {
    let Emitter { name, path, mechanism, .. } = emitter;
    let summary = format!("Equations of motion of the {} mechanism `{name}`.", mechanism.space.text());
    let _ = writeln!(text, "#[doc = \"\"] #[doc = {}]", quoted(&summary));
    // Files of tables and parts are found from where the definition is, which the text does not say.
    let folder =
        mechanism.files().next().map(|file| format!("in {} ", quoted(&file.folder))).unwrap_or_default();
    let _ = writeln!(text, "#[cfg_attr(doc, doc = {path}::mechanism_page! {{ {folder}{source} }})]");
}
