//! Names in C: those of a mechanism as a prefix, and words that no name may be.

/// What the items of one mechanism are called after: `four_bar` for types and functions, `FOUR_BAR` for constants.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prefix {
    pub lower: String,
    pub upper: String,
}

impl Prefix {
    /// Of `FourBar`: words are told apart where a capital follows what is none, or stands before what is none.
    pub fn of(name: &str) -> Prefix {
        let letters: Vec<char> = name.chars().collect();
        let mut lower = String::new();
        for (index, letter) in letters.iter().enumerate() {
            let before = index.checked_sub(1).map(|index| letters[index]);
            let after = letters.get(index + 1);
            let begins = letter.is_uppercase()
                && before.is_some_and(|before| {
                    before != '_'
                        && (!before.is_uppercase() || after.is_some_and(|after| after.is_lowercase()))
                });
            if begins {
                lower.push('_');
            }
            lower.extend(letter.to_lowercase());
        }
        let lower = field(&lower);
        Prefix { upper: lower.to_uppercase(), lower }
    }
}

/// A field, a value or an index: the user's name in the letters that every compiler takes, no word of C or C++.
pub fn field(name: &str) -> String {
    let name = plain(name);
    if WORDS.contains(&name.as_str()) { name + "_" } else { name }
}

/// Letters beyond ASCII by their numbers: `α` is `u3b1`.
pub fn plain(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        match letter {
            letter if letter.is_ascii_alphanumeric() || letter == '_' => text.push(letter),
            '.' | '[' | '(' | ' ' | ',' => text.push('_'),
            ']' | ')' => {}
            letter => text.push_str(&format!("u{:x}", u32::from(letter))),
        }
    }
    text
}

/// An index or a size: `FOUR_BAR_Q_CRANK_COS`.
pub fn constant(prefix: &Prefix, kind: &str, name: &str) -> String {
    format!("{}_{kind}_{}", prefix.upper, plain(name).to_uppercase())
}

/// Words of C and C++, and what the headers that are included define.
pub const WORDS: [&str; 136] = [
    "auto",
    "break",
    "case",
    "char",
    "const",
    "continue",
    "default",
    "do",
    "double",
    "else",
    "enum",
    "extern",
    "float",
    "for",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "register",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "struct",
    "switch",
    "typedef",
    "union",
    "unsigned",
    "void",
    "volatile",
    "while",
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "bitand",
    "bitor",
    "bool",
    "catch",
    "char8_t",
    "char16_t",
    "char32_t",
    "class",
    "compl",
    "concept",
    "consteval",
    "constexpr",
    "constinit",
    "const_cast",
    "co_await",
    "co_return",
    "co_yield",
    "decltype",
    "delete",
    "dynamic_cast",
    "explicit",
    "export",
    "false",
    "friend",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "reinterpret_cast",
    "requires",
    "static_assert",
    "static_cast",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typeid",
    "typename",
    "using",
    "virtual",
    "wchar_t",
    "xor",
    "xor_eq",
    "sqrt",
    "sqrtf",
    "fabs",
    "fabsf",
    "floor",
    "floorf",
    "memcpy",
    "memcmp",
    "main",
    "errno",
    "stdin",
    "stdout",
    "stderr",
    "isnan",
    "isinf",
    "isfinite",
    "signbit",
    "fpclassify",
    "INFINITY",
    "NAN",
    "HUGE_VAL",
    "HUGE_VALF",
    "NULL",
    "EOF",
    "size_t",
    "uint8_t",
    "uint16_t",
    "uint32_t",
    "uint64_t",
    "int8_t",
    "int16_t",
    "int32_t",
    "int64_t",
    "linux",
    "unix",
    "i386",
    "model",
    "constants",
    "outputs",
    "near",
    "far",
    "I",
    "asm_",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_are_words_with_lines_between() {
        let lower = |name| Prefix::of(name).lower;
        assert_eq!(lower("FourBar"), "four_bar");
        assert_eq!(lower("NFourBar40"), "n_four_bar40");
        assert_eq!(lower("CAN"), "can");
        assert_eq!(lower("PDController"), "pd_controller");
        assert_eq!(lower("Float"), "float_");
        assert_eq!(lower("already_there"), "already_there");
        assert_eq!(Prefix::of("FourBar").upper, "FOUR_BAR");
    }

    #[test]
    fn fields_are_no_words_and_plain() {
        assert_eq!(field("class"), "class_");
        assert_eq!(field("α_1"), "u3b1_1");
        assert_eq!(field("crank[2].angle"), "crank_2_angle");
    }
}
