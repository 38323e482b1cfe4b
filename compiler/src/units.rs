//! Units and dimensions: `kg*m^2/s^2` as a factor to SI and as exponents of kg, m, s, A and rad.
//!
//! Knows nothing of tokens. Which dimension is expected where is the business of `model`.

use std::fmt;

/// One whole exponent; exponents are counted in sixtieths so that roots stay exact.
const ONE: i32 = 60;

/// A unit as written.
#[derive(Clone, Debug)]
pub struct Unit {
    /// `kg*m^2`: names, `*`, `/` and `^` only, whatever the spacing and grouping as written.
    pub text: String,
    /// SI value of one of it.
    pub scale: f64,
    /// What it measures.
    pub dimension: Dimension,
}

/// Exponents of kg, m, s, A and rad.
///
/// The angle is tracked where neither mass, length nor current takes part. Where one does it cancels (rad·m is m, N·m/rad
/// is N·m) and stays open from there on: a speed divided by a radius is as good an angular rate as any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    mass: i32,
    length: i32,
    time: i32,
    current: i32,
    /// `None` where the angle has been cancelled against a length, a mass or a current.
    angle: Option<i32>,
}

/// Why a text is not a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UnitError {
    /// `[]`.
    Empty,
    /// No unit has this name.
    Unknown(String),
    /// A known unit with a prefix it does not take, as (prefix, unit).
    Prefix(String, String),
    /// Anything else, at this piece of the text.
    Malformed(String),
}

/// Parses products, quotients and integer powers of unit names, parentheses included.
pub fn parse(text: &str) -> Result<Unit, UnitError> {
    let mut reader = Reader { rest: text.trim_start(), factors: Vec::new() };
    if reader.rest.is_empty() {
        return Err(UnitError::Empty);
    }
    reader.product(1, 0)?;
    if !reader.rest.is_empty() {
        return Err(UnitError::Malformed(reader.rest.trim_end().to_string()));
    }
    assemble(reader.factors)
}

/// What to write instead of a name that is no unit.
pub fn suggest(name: &str) -> Option<String> {
    const MISNOMERS: [(&str, &str); 30] = [
        ("degree", "deg"),
        ("degrees", "deg"),
        ("radian", "rad"),
        ("radians", "rad"),
        ("meter", "m"),
        ("metre", "m"),
        ("meters", "m"),
        ("metres", "m"),
        ("sec", "s"),
        ("second", "s"),
        ("seconds", "s"),
        ("newton", "N"),
        ("kilogram", "kg"),
        ("gram", "g"),
        ("joule", "J"),
        ("watt", "W"),
        ("pascal", "Pa"),
        ("hertz", "Hz"),
        ("hour", "h"),
        ("hr", "h"),
        ("minute", "min"),
        ("ton", "t"),
        ("ampere", "A"),
        ("amp", "A"),
        ("volt", "V"),
        ("ohms", "ohm"),
        ("Ω", "ohm"),
        ("henry", "H"),
        ("farad", "F"),
        ("weber", "Wb"),
    ];
    let lower = name.to_lowercase();
    if let Some((_, unit)) = MISNOMERS.iter().find(|(wrong, _)| *wrong == lower) {
        return Some((*unit).to_string());
    }
    if let Some((known, ..)) = NAMED.iter().find(|(known, ..)| known.to_lowercase() == lower) {
        return Some((*known).to_string());
    }
    // `Nm`, `kgm`, `Ns`: two units without the `*` between them.
    for (split, _) in name.char_indices().skip(1) {
        let (left, right) = name.split_at(split);
        if let (Ok((_, one)), Ok((_, other))) = (find(left), find(right))
            && one != other
        {
            return Some(format!("{left}*{right}"));
        }
    }
    // `m2`, `s2`: a power without its `^`.
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if base.len() < name.len() && find(base).is_ok() {
        return Some(format!("{base}^{}", &name[base.len()..]));
    }
    // A letter too many or too few in one of the longer names.
    let longer = NAMED.iter().map(|(known, ..)| *known).filter(|known| known.len() > 1 && name.len() > 2);
    crate::spelling::closest(name, longer).map(str::to_string)
}

impl Dimension {
    /// A plain number.
    pub const ONE: Self = Self::new(0, 0, 0, 0);
    /// rad.
    pub const ANGLE: Self = Self::new(0, 0, 0, 1);
    /// rad/s.
    pub const ANGULAR_RATE: Self = Self::new(0, 0, -1, 1);
    /// s.
    pub const TIME: Self = Self::new(0, 0, 1, 0);
    /// kg.
    pub const MASS: Self = Self::new(1, 0, 0, 0);
    /// m.
    pub const LENGTH: Self = Self::new(0, 1, 0, 0);
    /// m/s.
    pub const SPEED: Self = Self::new(0, 1, -1, 0);
    /// m/s².
    pub const ACCELERATION: Self = Self::new(0, 1, -2, 0);
    /// kg/m³.
    pub const DENSITY: Self = Self::new(1, -3, 0, 0);
    /// kg m².
    pub const INERTIA: Self = Self::new(1, 2, 0, 0);
    /// N.
    pub const FORCE: Self = Self::new(1, 1, -2, 0);
    /// N m, and J.
    pub const TORQUE: Self = Self::new(1, 2, -2, 0);
    /// W.
    pub const POWER: Self = Self::new(1, 2, -3, 0);
    /// N/m.
    pub const STIFFNESS: Self = Self::new(1, 0, -2, 0);
    /// N s/m.
    pub const DAMPING: Self = Self::new(1, 0, -1, 0);
    /// N m s.
    pub const ANGULAR_DAMPING: Self = Self::new(1, 2, -1, 0);

    /// Pa.
    pub const PRESSURE: Self = Self::new(1, -1, -2, 0);
    /// m².
    pub const AREA: Self = Self::new(0, 2, 0, 0);
    /// m⁴.
    pub const SECOND_MOMENT: Self = Self::new(0, 4, 0, 0);

    /// From whole exponents of kg, m, s and rad.
    const fn new(mass: i32, length: i32, time: i32, angle: i32) -> Self {
        Self::electric(mass, length, time, 0, angle)
    }

    /// The same with an exponent of A.
    const fn electric(mass: i32, length: i32, time: i32, current: i32, angle: i32) -> Self {
        let angle = Some(angle * ONE);
        let [mass, length, time, current] = [mass * ONE, length * ONE, time * ONE, current * ONE];
        Self { mass, length, time, current, angle }.cancelled()
    }

    /// The same with the angle given up where mass, length or current takes part.
    const fn cancelled(mut self) -> Self {
        if self.mass != 0 || self.length != 0 || self.current != 0 {
            self.angle = None;
        }
        self
    }

    /// The dimension of a product.
    pub fn times(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            length: self.length + other.length,
            time: self.time + other.time,
            current: self.current + other.current,
            angle: self.angle.zip(other.angle).map(|(a, b)| a + b),
        }
        .cancelled()
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Self) -> Self {
        self.times(Self {
            mass: -other.mass,
            length: -other.length,
            time: -other.time,
            current: -other.current,
            angle: other.angle.map(|angle| -angle),
        })
    }

    /// The dimension of a power; `None` if an exponent is no multiple of 1/60 or out of all reason.
    pub fn power(self, exponent: f64) -> Option<Self> {
        let scaled = |own: i32| {
            let exact = f64::from(own) * exponent;
            let whole = libm::round(exact);
            ((exact - whole).abs() < 1e-6 && whole.abs() < 1e5).then_some(whole as i32)
        };
        let angle = match self.angle {
            Some(angle) => Some(scaled(angle)?),
            None => None,
        };
        let (mass, length, time) = (scaled(self.mass)?, scaled(self.length)?, scaled(self.time)?);
        let current = scaled(self.current)?;
        Some(Self { mass, length, time, current, angle }.cancelled())
    }

    /// Whether values of both may be added and compared. The angle counts for 1, 1/s and 1/s² only.
    pub fn fits(self, other: Self) -> bool {
        let powers = |it: Self| [it.mass, it.length, it.time, it.current];
        let same = powers(self) == powers(other);
        let counts = [0, -ONE, -2 * ONE].contains(&self.time);
        let angles = match (self.angle, other.angle) {
            (Some(a), Some(b)) if counts => a == b,
            _ => true,
        };
        same && angles
    }

    /// The dimension of a sum: the angle is known if either summand knows it.
    pub fn merged(self, other: Self) -> Self {
        Self { angle: self.angle.or(other.angle), ..self }
    }

    /// A plain number, and an angle only where it was cancelled.
    pub fn is_one(self) -> bool {
        self.fits(Self::ONE)
    }

    /// 1/s without any angle, as of Hz.
    pub fn is_frequency(self) -> bool {
        self == Self::new(0, 0, -1, 0)
    }

    /// `a length`, `a force`; a quantity without a name of its own is `a value in kg*m^3`.
    pub fn kind(self) -> String {
        let known: [(Self, &str); 20] = [
            (Self::ONE, "a plain number"),
            (Self::ANGLE, "an angle"),
            (Self::ANGULAR_RATE, "an angular rate"),
            (Self::new(0, 0, -2, 1), "an angular acceleration"),
            (Self::new(0, 0, -1, 0), "a frequency"),
            (Self::TIME, "a time"),
            (Self::MASS, "a mass"),
            (Self::LENGTH, "a length"),
            (Self::new(0, 2, 0, 0), "an area"),
            (Self::SPEED, "a speed"),
            (Self::ACCELERATION, "an acceleration"),
            (Self::INERTIA, "a moment of inertia"),
            (Self::DENSITY, "a density"),
            (Self::FORCE, "a force"),
            (Self::TORQUE, "a torque or energy"),
            (Self::POWER, "a power"),
            (Self::STIFFNESS, "a stiffness"),
            (Self::electric(0, 0, 0, 1, 0), "a current"),
            (Self::electric(1, 2, -3, -1, 0), "a voltage"),
            (Self::electric(1, 2, -3, -2, 0), "a resistance"),
        ];
        match known.iter().find(|(dimension, _)| dimension.fits(self)) {
            Some((_, kind)) => (*kind).to_string(),
            None => format!("a value in {self}"),
        }
    }
}

/// As a unit that can be pasted into a definition.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named: [(Self, &str); 12] = [
            (Self::FORCE, "N"),
            (Self::TORQUE, "N*m"),
            (Self::POWER, "W"),
            (Self::STIFFNESS, "N/m"),
            (Self::DAMPING, "N*s/m"),
            (Self::ANGULAR_DAMPING, "N*m*s"),
            (Self::new(1, -1, -2, 0), "Pa"),
            (Self::electric(1, 2, -3, -1, 0), "V"),
            (Self::electric(1, 2, -3, -2, 0), "ohm"),
            (Self::electric(1, 2, -2, -2, 0), "H"),
            (Self::electric(-1, -2, 4, 2, 0), "F"),
            (Self::electric(1, 2, -2, -1, 0), "Wb"),
        ];
        if let Some((_, name)) = named.iter().find(|(dimension, _)| dimension.fits(*self)) {
            return f.write_str(name);
        }
        // Their rates.
        let integral = self.times(Self::TIME);
        if let Some((_, name)) = named.iter().find(|(dimension, _)| dimension.fits(integral)) {
            return write!(f, "{name}/s");
        }
        let powers = [
            ("kg", self.mass),
            ("m", self.length),
            ("A", self.current),
            ("rad", self.angle.unwrap_or(0)),
            ("s", self.time),
        ];
        let power = |exponent: i32| match exponent {
            ONE => String::new(),
            _ if exponent % ONE == 0 => format!("^{}", exponent / ONE),
            _ => format!("^{}", f64::from(exponent) / f64::from(ONE)),
        };
        let above: Vec<String> =
            powers.iter().filter(|p| p.1 > 0).map(|(name, e)| format!("{name}{}", power(*e))).collect();
        let below: String =
            powers.iter().filter(|p| p.1 < 0).map(|(name, e)| format!("/{name}{}", power(-*e))).collect();
        let above = if above.is_empty() { "1".to_string() } else { above.join("*") };
        write!(f, "{above}{below}")
    }
}

/// Units without prefix: name, SI value, exponents of kg, m, s, rad and A, and whether prefixes apply.
const NAMED: [(&str, f64, [i32; 5], bool); 23] = [
    ("m", 1.0, [0, 1, 0, 0, 0], true),
    ("g", 1e-3, [1, 0, 0, 0, 0], true),
    ("kg", 1.0, [1, 0, 0, 0, 0], false),
    ("s", 1.0, [0, 0, 1, 0, 0], true),
    ("N", 1.0, [1, 1, -2, 0, 0], true),
    ("Pa", 1.0, [1, -1, -2, 0, 0], true),
    ("J", 1.0, [1, 2, -2, 0, 0], true),
    ("W", 1.0, [1, 2, -3, 0, 0], true),
    ("Hz", 1.0, [0, 0, -1, 0, 0], true),
    ("A", 1.0, [0, 0, 0, 0, 1], true),
    ("V", 1.0, [1, 2, -3, 0, -1], true),
    ("ohm", 1.0, [1, 2, -3, 0, -2], true),
    ("H", 1.0, [1, 2, -2, 0, -2], true),
    ("F", 1.0, [-1, -2, 4, 0, 2], true),
    ("Wb", 1.0, [1, 2, -2, 0, -1], true),
    ("t", 1e3, [1, 0, 0, 0, 0], false),
    ("min", 60.0, [0, 0, 1, 0, 0], false),
    ("h", 3600.0, [0, 0, 1, 0, 0], false),
    ("bar", 1e5, [1, -1, -2, 0, 0], false),
    ("rad", 1.0, [0, 0, 0, 1, 0], false),
    ("deg", core::f64::consts::PI / 180.0, [0, 0, 0, 1, 0], false),
    ("rev", 2.0 * core::f64::consts::PI, [0, 0, 0, 1, 0], false),
    ("rpm", 2.0 * core::f64::consts::PI / 60.0, [0, 0, -1, 1, 0], false),
];

/// Powers of ten; both micro signs and the letter.
const PREFIXES: [(&str, f64); 13] = [
    ("p", 1e-12),
    ("n", 1e-9),
    ("u", 1e-6),
    ("\u{b5}", 1e-6),
    ("\u{3bc}", 1e-6),
    ("m", 1e-3),
    ("c", 1e-2),
    ("d", 1e-1),
    ("h", 1e2),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
    ("T", 1e12),
];

/// SI value and dimension of one unit name.
fn find(name: &str) -> Result<(f64, Dimension), UnitError> {
    let exponents = |e: [i32; 5]| Dimension::electric(e[0], e[1], e[2], e[4], e[3]);
    if let Some((_, scale, powers, _)) = NAMED.iter().find(|(known, ..)| *known == name) {
        return Ok((*scale, exponents(*powers)));
    }
    for (prefix, factor) in PREFIXES {
        let Some(base) = name.strip_prefix(prefix) else { continue };
        let Some((_, scale, powers, prefixed)) = NAMED.iter().find(|(known, ..)| *known == base) else {
            continue;
        };
        if *prefixed {
            return Ok((scale * factor, exponents(*powers)));
        }
        return Err(UnitError::Prefix(prefix.to_string(), base.to_string()));
    }
    Err(UnitError::Unknown(name.to_string()))
}

/// The factors of a unit, read off its text.
struct Reader<'a> {
    rest: &'a str,
    factors: Vec<(String, i32)>,
}

impl Reader<'_> {
    /// `factor (('*' | '/') factor)*`, all to the power `sign`.
    fn product(&mut self, sign: i32, depth: usize) -> Result<(), UnitError> {
        self.factor(sign, depth)?;
        loop {
            if self.eat('*') {
                self.factor(sign, depth)?;
            } else if self.eat('/') {
                self.factor(-sign, depth)?;
            } else {
                return Ok(());
            }
        }
    }

    /// `name ['^' integer]`, `1` or `'(' product ')'`.
    fn factor(&mut self, sign: i32, depth: usize) -> Result<(), UnitError> {
        if depth > 8 {
            return Err(UnitError::Malformed(self.rest.to_string()));
        }
        if self.eat('(') {
            self.product(sign, depth + 1)?;
            return if self.eat(')') { Ok(()) } else { Err(UnitError::Malformed("(".to_string())) };
        }
        let name = self.take(|c| c.is_alphanumeric() || c == '_');
        if name.is_empty() {
            return Err(UnitError::Malformed(self.rest.trim_end().to_string()));
        }
        let exponent = if self.eat('^') { self.exponent()? } else { 1 };
        self.factors.push((name, sign * exponent));
        Ok(())
    }

    /// A small integer with an optional sign, in parentheses or not.
    fn exponent(&mut self) -> Result<i32, UnitError> {
        let grouped = self.eat('(');
        let sign = if self.eat('-') { -1 } else { 1 };
        let digits = self.take(|c| c.is_ascii_digit());
        let value: i32 = digits.parse().map_err(|_| UnitError::Malformed("^".to_string()))?;
        if value > 12 || (grouped && !self.eat(')')) {
            return Err(UnitError::Malformed(format!("^{digits}")));
        }
        Ok(sign * value)
    }

    fn eat(&mut self, character: char) -> bool {
        let Some(rest) = self.rest.strip_prefix(character) else { return false };
        self.rest = rest.trim_start();
        true
    }

    fn take(&mut self, belongs: impl Fn(char) -> bool) -> String {
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        taken.to_string()
    }
}

/// Multiplies the factors out and writes them down again without parentheses.
fn assemble(factors: Vec<(String, i32)>) -> Result<Unit, UnitError> {
    let mut unit = Unit { text: String::new(), scale: 1.0, dimension: Dimension::ONE };
    for (name, exponent) in factors {
        if name == "1" || exponent == 0 {
            continue;
        }
        let (scale, dimension) = find(&name)?;
        let powered =
            dimension.power(f64::from(exponent)).ok_or_else(|| UnitError::Malformed(name.clone()))?;
        unit.scale *= libm::pow(scale, f64::from(exponent));
        unit.dimension = unit.dimension.times(powered);
        let separator = match (exponent > 0, unit.text.is_empty()) {
            (true, true) => "",
            (true, false) => "*",
            (false, true) => "1/",
            (false, false) => "/",
        };
        unit.text.push_str(separator);
        unit.text.push_str(&name);
        if exponent.abs() != 1 {
            unit.text.push_str(&format!("^{}", exponent.abs()));
        }
    }
    if unit.text.is_empty() {
        unit.text.push('1');
    }
    Ok(unit)
}
