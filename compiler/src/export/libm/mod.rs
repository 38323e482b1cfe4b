//! The functions of the crate `libm` in C.
//!
//! Why: the sine of C's own library has other bits on every platform, and the exported C gives the same bits as the Rust.
//! So it brings along what the Rust calls: the algorithms of `libm` 0.2.16, operation by operation, rounding to nearest
//! and without contraction to fused operations. Left out are only the operations whose sole effect is a flag, what no
//! argument reaches, and the distinction of NaNs. Of `<math.h>`, `sqrt`, `sqrtf`, `fabs`, `fabsf` and `floor` remain, which are exact everywhere.
//!
//! Each file holds one function and names its authors: the algorithms come from FreeBSD's msun by way of musl.
//! The licence, MIT, is in `notice.c`.

/// A function, the functions that it calls, and its text. What is called comes before its callers.
type File = (&'static str, &'static [&'static str], &'static str);

const NOTICE: &str = include_str!("notice.c");

const FILES: [File; 55] = [
    ("bits", &[], include_str!("bits.c")),
    ("from_bits", &[], include_str!("from_bits.c")),
    ("high_word", &["bits"], include_str!("high_word.c")),
    ("clear_low_word", &["bits", "from_bits"], include_str!("clear_low_word.c")),
    ("is_nan", &["bits"], include_str!("is_nan.c")),
    ("pow2", &["from_bits"], include_str!("pow2.c")),
    ("scalbn", &["pow2"], include_str!("scalbn.c")),
    ("k_sin", &[], include_str!("k_sin.c")),
    ("k_cos", &[], include_str!("k_cos.c")),
    ("k_tan", &["high_word", "clear_low_word"], include_str!("k_tan.c")),
    ("rem_pio2_large", &["scalbn"], include_str!("rem_pio2_large.c")),
    ("rem_pio2_medium", &["high_word"], include_str!("rem_pio2_medium.c")),
    (
        "rem_pio2",
        &["bits", "from_bits", "high_word", "rem_pio2_large", "rem_pio2_medium"],
        include_str!("rem_pio2.c"),
    ),
    ("sin", &["high_word", "k_sin", "k_cos", "rem_pio2"], include_str!("sin.c")),
    ("cos", &["high_word", "k_sin", "k_cos", "rem_pio2"], include_str!("cos.c")),
    ("tan", &["high_word", "k_tan", "rem_pio2"], include_str!("tan.c")),
    ("asin_r", &[], include_str!("asin_r.c")),
    ("asin", &["bits", "high_word", "clear_low_word", "asin_r"], include_str!("asin.c")),
    ("acos", &["bits", "high_word", "clear_low_word", "asin_r"], include_str!("acos.c")),
    ("atan", &["high_word", "is_nan"], include_str!("atan.c")),
    ("atan2", &["bits", "high_word", "is_nan", "atan"], include_str!("atan2.c")),
    ("exp", &["high_word", "is_nan", "scalbn"], include_str!("exp.c")),
    ("expm1", &["high_word", "is_nan", "pow2"], include_str!("expm1.c")),
    ("k_expo2", &["exp"], include_str!("k_expo2.c")),
    ("log_r", &[], include_str!("log_r.c")),
    ("log", &["bits", "from_bits", "high_word", "log_r"], include_str!("log.c")),
    ("log10", &["bits", "from_bits", "high_word", "clear_low_word", "log_r"], include_str!("log10.c")),
    ("sinh", &["high_word", "expm1", "k_expo2"], include_str!("sinh.c")),
    ("cosh", &["high_word", "exp", "expm1", "k_expo2"], include_str!("cosh.c")),
    ("tanh", &["high_word", "expm1"], include_str!("tanh.c")),
    ("bitsf", &[], include_str!("bitsf.c")),
    ("from_bitsf", &[], include_str!("from_bitsf.c")),
    ("pow2f", &["from_bitsf"], include_str!("pow2f.c")),
    ("scalbnf", &["pow2f"], include_str!("scalbnf.c")),
    ("k_sinf", &[], include_str!("k_sinf.c")),
    ("k_cosf", &[], include_str!("k_cosf.c")),
    ("k_tanf", &[], include_str!("k_tanf.c")),
    ("rem_pio2f", &["rem_pio2_large", "bitsf", "from_bitsf"], include_str!("rem_pio2f.c")),
    ("sinf", &["bitsf", "k_sinf", "k_cosf", "rem_pio2f"], include_str!("sinf.c")),
    ("cosf", &["bitsf", "k_sinf", "k_cosf", "rem_pio2f"], include_str!("cosf.c")),
    ("tanf", &["bitsf", "k_tanf", "rem_pio2f"], include_str!("tanf.c")),
    ("asin_rf", &[], include_str!("asin_rf.c")),
    ("asinf", &["bitsf", "asin_rf"], include_str!("asinf.c")),
    ("acosf", &["bitsf", "from_bitsf", "asin_rf"], include_str!("acosf.c")),
    ("atanf", &["bitsf"], include_str!("atanf.c")),
    ("atan2f", &["bitsf", "atanf"], include_str!("atan2f.c")),
    ("expf", &["bitsf", "scalbnf"], include_str!("expf.c")),
    ("expm1f", &["bitsf", "pow2f"], include_str!("expm1f.c")),
    ("k_expo2f", &["expf"], include_str!("k_expo2f.c")),
    ("log_rf", &[], include_str!("log_rf.c")),
    ("logf", &["bitsf", "from_bitsf", "log_rf"], include_str!("logf.c")),
    ("log10f", &["bitsf", "from_bitsf", "log_rf"], include_str!("log10f.c")),
    ("sinhf", &["bitsf", "expm1f", "k_expo2f"], include_str!("sinhf.c")),
    ("coshf", &["bitsf", "expf", "expm1f", "k_expo2f"], include_str!("coshf.c")),
    ("tanhf", &["bitsf", "expm1f"], include_str!("tanhf.c")),
];

/// The C of these functions (`sin`, `sinf`, ...) and of all that they call. It needs `<math.h>`, `<stdint.h>` and `<string.h>`.
pub(super) fn text(names: impl IntoIterator<Item = &'static str>) -> String {
    let mut wanted: Vec<&str> = names.into_iter().collect();
    if wanted.is_empty() {
        return String::new();
    }
    for name in &wanted {
        assert!(FILES.iter().any(|(file, ..)| file == name), "there is no C of `{name}`");
    }
    // From callers to the called.
    for (name, needs, _) in FILES.iter().rev() {
        if wanted.contains(name) {
            wanted.extend(*needs);
        }
    }
    let texts = FILES.iter().filter(|(name, ..)| wanted.contains(name)).map(|(.., text)| *text);
    std::iter::once(NOTICE).chain(texts).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::{FILES, NOTICE, text};
    use std::collections::BTreeSet;

    /// The text without comments.
    fn code(text: &str) -> String {
        let mut parts = text.split("/*");
        let first = parts.next().unwrap_or_default().to_string();
        parts.fold(first, |code, part| code + part.split_once("*/").expect("each comment ends").1)
    }

    /// What begins with `lw_`, without that.
    fn identifiers(code: &str) -> BTreeSet<&str> {
        code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
            .filter_map(|word| word.strip_prefix("lw_"))
            .collect()
    }

    #[test]
    fn what_a_function_of_libm_needs_comes_before_it_and_is_what_it_calls() {
        for (index, (name, needs, text)) in FILES.iter().enumerate() {
            let before: Vec<&str> = FILES[..index].iter().map(|(name, ..)| *name).collect();
            assert!(needs.iter().all(|need| before.contains(need)), "{name}");
            assert!(!before.contains(name), "{name} twice");
            let code = code(text);
            let mut called = identifiers(&code);
            assert!(called.remove(name), "{name} is not defined");
            assert_eq!(called, needs.iter().copied().collect(), "{name}");
        }
    }

    #[test]
    fn each_file_of_libm_is_one_static_function_without_a_directive() {
        for (name, _, text) in FILES {
            assert!(!text.contains('#'), "{name}");
            let outside: Vec<&str> =
                text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_alphabetic())).collect();
            let [head] = outside[..] else { panic!("{name}: {outside:?}") };
            assert!(head.starts_with("static ") && head.contains(&format!(" lw_{name}(")), "{head}");
            assert!(text.starts_with(&format!("/* lw_{name}: ")), "{name}");
        }
        assert!(code(NOTICE).trim().is_empty());
    }

    #[test]
    fn a_function_of_libm_brings_what_it_calls_once() {
        assert_eq!(text([]), "");
        let found = text(["tanf", "cosf", "tanf"]);
        for (name, ..) in FILES {
            let wanted = [
                "from_bits",
                "pow2",
                "scalbn",
                "rem_pio2_large",
                "bitsf",
                "from_bitsf",
                "k_sinf",
                "k_cosf",
                "k_tanf",
                "rem_pio2f",
                "cosf",
                "tanf",
            ]
            .contains(&name);
            let count = found.matches(&format!("/* lw_{name}: ")).count();
            assert_eq!(count, usize::from(wanted), "{name}");
        }
    }
}
