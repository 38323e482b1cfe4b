//! Numbers as text, without the standard library's formatting, which is larger than a mechanism.

/// Calls `show` with the decimal digits of a number.
pub fn decimal(number: u32, show: &mut impl FnMut(&str)) {
    digits(u64::from(number), const { core::num::NonZeroU64::new(10).unwrap() }, show);
}

/// Calls `show` with sixteen hexadecimal digits.
pub fn hexadecimal(number: u64, show: &mut impl FnMut(&str)) {
    for place in (0..16).rev() {
        show(DIGITS[(number >> (4 * place)) as usize & 15]);
    }
}

const DIGITS: [&str; 16] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "a", "b", "c", "d", "e", "f"];

fn digits(number: u64, base: core::num::NonZeroU64, show: &mut impl FnMut(&str)) {
    if number >= base.get() {
        digits(number / base, base, show);
    }
    show(DIGITS[(number % base) as usize & 15]);
}
