//! Mechanisms that ship with Linkwright: textbook systems and published benchmarks, one file each, with source, data
//! and expected result.

pub mod four_bar;

/// Calls a macro with every shipped model, `name: path::to::Type`, so that no test forgets one.
///
/// ```text
/// macro_rules! names { ($($name:ident: $model:path),* $(,)?) => { [$(stringify!($name)),*] } }
/// let names = linkwright_models::for_each_model!(names);
/// ```
#[macro_export]
macro_rules! for_each_model {
    ($callback:ident) => {
        $callback! {
            four_bar: $crate::four_bar::FourBar,
        }
    };
}
