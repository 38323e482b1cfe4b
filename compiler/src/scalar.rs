//! The two scalars, and numbers in them.

/// The type of all numbers in what is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scalar {
    #[default]
    F64,
    F32,
}

impl Scalar {
    /// By its name in Rust or in C.
    pub fn named(name: &str) -> Option<Scalar> {
        match name {
            "f64" | "double" => Some(Scalar::F64),
            "f32" | "float" => Some(Scalar::F32),
            _ => None,
        }
    }

    /// The type in C.
    pub fn c(self) -> &'static str {
        match self {
            Scalar::F64 => "double",
            Scalar::F32 => "float",
        }
    }

    /// The nearest number as a literal that reads back to the same bits.
    pub fn literal(self, value: f64) -> String {
        // Those of <math.h> are floats.
        let infinite = |is_negative: bool| match (self, is_negative) {
            (Scalar::F64, false) => "(double)INFINITY".to_string(),
            (Scalar::F64, true) => "(-(double)INFINITY)".to_string(),
            (Scalar::F32, false) => "INFINITY".to_string(),
            (Scalar::F32, true) => "(-INFINITY)".to_string(),
        };
        match self {
            Scalar::F64 if value.is_nan() => "(double)NAN".to_string(),
            Scalar::F32 if value.is_nan() => "NAN".to_string(),
            Scalar::F64 if value.is_infinite() => infinite(value < 0.0),
            Scalar::F64 => format!("{value:?}"),
            Scalar::F32 => {
                let value = value as f32;
                if value.is_infinite() { infinite(value < 0.0) } else { format!("{value:?}F") }
            }
        }
    }

    /// The same where it may stand as an operand.
    pub fn operand(self, value: f64) -> String {
        let text = self.literal(value);
        if text.starts_with('-') { format!("({text})") } else { text }
    }

    /// The product of the nearest numbers, rounded.
    pub fn product(self, a: f64, b: f64) -> f64 {
        match self {
            Scalar::F64 => a * b,
            Scalar::F32 => f64::from(a as f32 * b as f32),
        }
    }

    /// The least number of this type that is not below.
    pub fn ceiling(self, value: f64) -> f64 {
        match self {
            Scalar::F64 => value,
            Scalar::F32 => {
                let near = value as f32;
                f64::from(if f64::from(near) < value { near.next_up() } else { near })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_read_back() {
        assert_eq!(Scalar::F64.literal(0.1), "0.1");
        assert_eq!(Scalar::F32.literal(0.1), "0.1F");
        assert_eq!(Scalar::F32.literal(1e-300), "0.0F");
        assert_eq!(Scalar::F32.literal(1e300), "INFINITY");
        assert_eq!(Scalar::F64.operand(-1.5e-20), "(-1.5e-20)");
        assert_eq!(Scalar::F32.operand(f64::NEG_INFINITY), "(-INFINITY)");
    }

    #[test]
    fn ceilings_are_not_below() {
        for value in [0.1, -0.1, 3.0, 1e-40, 16_777_217.0] {
            let ceiling = Scalar::F32.ceiling(value);
            assert!(ceiling >= value && f64::from((ceiling as f32).next_down()) < value, "{value}");
        }
    }
}
