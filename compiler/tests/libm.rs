//! The functions of `libm` that exported C brings along have the same bits as those of the crate: one C program and
//! this one form the same arguments, and compare a hash of the results for every function and class of arguments.

#[path = "../src/export/libm/mod.rs"]
mod table;

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// Arguments of a class, for each function.
const ARGUMENTS: u32 = 20_000;
/// In the order of `argument`.
const CLASSES: [&str; 10] = [
    "any bits",
    "from -10 to 10",
    "from -1 to 1",
    "where exponentials are finite",
    "near multiples of pi/2",
    "near thresholds",
    "near 1",
    "tiny",
    "huge",
    "special",
];

enum Of {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    OneF(fn(f32) -> f32),
    TwoF(fn(f32, f32) -> f32),
}

/// The last four are those called by others that are functions of the crate too.
const FUNCTIONS: [(&str, Of); 28] = [
    ("sin", Of::One(libm::sin)),
    ("cos", Of::One(libm::cos)),
    ("tan", Of::One(libm::tan)),
    ("asin", Of::One(libm::asin)),
    ("acos", Of::One(libm::acos)),
    ("atan2", Of::Two(libm::atan2)),
    ("exp", Of::One(libm::exp)),
    ("log", Of::One(libm::log)),
    ("log10", Of::One(libm::log10)),
    ("sinh", Of::One(libm::sinh)),
    ("cosh", Of::One(libm::cosh)),
    ("tanh", Of::One(libm::tanh)),
    ("sinf", Of::OneF(libm::sinf)),
    ("cosf", Of::OneF(libm::cosf)),
    ("tanf", Of::OneF(libm::tanf)),
    ("asinf", Of::OneF(libm::asinf)),
    ("acosf", Of::OneF(libm::acosf)),
    ("atan2f", Of::TwoF(libm::atan2f)),
    ("expf", Of::OneF(libm::expf)),
    ("logf", Of::OneF(libm::logf)),
    ("log10f", Of::OneF(libm::log10f)),
    ("sinhf", Of::OneF(libm::sinhf)),
    ("coshf", Of::OneF(libm::coshf)),
    ("tanhf", Of::OneF(libm::tanhf)),
    ("atan", Of::One(libm::atan)),
    ("atanf", Of::OneF(libm::atanf)),
    ("expm1", Of::One(libm::expm1)),
    ("expm1f", Of::OneF(libm::expm1f)),
];

/// Where the functions of `f64` go from one formula to another.
const THRESHOLDS: [u64; 50] = [
    0x3fe921fb00000000,
    0x3e50000000000000,
    0x3e46a09e00000000,
    0x3e40000000000000,
    0x400f6a7a00000000,
    0x3ff921fb00000000,
    0x400921fb00000000,
    0x4002d97c00000000,
    0x401c463b00000000,
    0x4015fdbc00000000,
    0x4012d97c00000000,
    0x401921fb00000000,
    0x413921fb00000000,
    0x3fe5942800000000,
    0x3ff0000000000000,
    0x3fe0000000000000,
    0x3fef333300000000,
    0x3c60000000000000,
    0x4410000000000000,
    0x3fdc000000000000,
    0x3fe6000000000000,
    0x3ff3000000000000,
    0x4003800000000000,
    0x4086232b00000000,
    0x3fd62e4200000000,
    0x3ff0a2b200000000,
    0x3e30000000000000,
    0x4043687a00000000,
    0x3c90000000000000,
    0x3fe6a09e00000000,
    0x3ff6a09e00000000,
    0x0010000000000000,
    0x7ff0000000000000,
    0x40862e4200000000,
    0x40862e42fefa39ef,
    0x4086232bdd7abcd2,
    0x40874910d52d3051,
    0x3fe62e4200000000,
    0x4034000000000000,
    0x3fe193ea00000000,
    0x3fd058ae00000000,
    // Nearest to multiples of pi/2.
    0x7506ac5b262ca1ff,
    0x416b951f1572eba5,
    0x482504cac51f1eaf,
    0x7dee009c53148be1,
    0x6404c96c11134d36,
    0x75bcfe482285f8ed,
    0x6a7db41f3cb71d7b,
    0x4c4e7e44a78ac18c,
    0x526c45cd11154dfd,
];

/// Where the functions of `f32` do.
const THRESHOLDS_F: [u64; 33] = [
    0x3f490fda, 0x39800000, 0x407b53d1, 0x4016cbe3, 0x40e231d5, 0x40afeddf, 0x4dc90fdb, 0x7f800000,
    0x3f800000, 0x3f000000, 0x32800000, 0x4c800000, 0x3ee00000, 0x3f980000, 0x3f300000, 0x401c0000,
    0x42aeac50, 0x42b17218, 0x42cff1b5, 0x3eb17218, 0x3f851592, 0x39000000, 0x4195b844, 0x33000000,
    0x00800000, 0x3f3504f3, 0x3fb504f3, 0x3f317217, 0x42b17217, 0x41200000, 0x3f0c9f54, 0x3e82c578,
    0x40490fdb,
];

#[test]
fn functions_of_libm_have_the_same_bits_in_c() {
    if !has_cc("functions_of_libm_have_the_same_bits_in_c") {
        return;
    }
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("libm");
    build(&program);
    let found = Command::new(&program).stdout(Stdio::piped()).spawn().expect("the program starts");
    let mut expected = Vec::new();
    for (index, (name, of)) in FUNCTIONS.iter().enumerate() {
        for class in 0..CLASSES.len() {
            expected.push(format!("{name} {class} {:016x}", hash(index, of, class)));
        }
    }
    let found = found.wait_with_output().expect("the program ends");
    assert!(found.status.success(), "{}", found.status);
    let found = String::from_utf8(found.stdout).expect("it prints text");
    let found: Vec<&str> = found.lines().collect();
    assert_eq!(found.len(), expected.len());
    let differing: Vec<String> = std::iter::zip(&found, &expected)
        .enumerate()
        .filter(|(_, (found, expected))| found != expected)
        .map(|(line, _)| {
            let (function, class) = (line / CLASSES.len(), line % CLASSES.len());
            format!("{}, arguments {}", FUNCTIONS[function].0, CLASSES[class])
        })
        .collect();
    assert!(differing.is_empty(), "other bits in C: {differing:#?}");
}

fn has_cc(test: &str) -> bool {
    let found = Command::new("cc").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if found.is_err() {
        assert!(std::env::var_os("REQUIRE_ALL").is_none(), "there is no `cc`");
        println!("{test}: skipped, because there is no `cc`");
    }
    found.is_ok()
}

fn build(program: &Path) {
    let mut text = String::new();
    for name in ["inttypes", "math", "stdint", "stdio", "string"] {
        let _ = writeln!(text, "#include <{name}.h>");
    }
    text += &table::text(FUNCTIONS.iter().map(|(name, _)| *name));
    let _ = writeln!(text, "#define ARGUMENTS {ARGUMENTS}U\n#define CLASSES {}U", CLASSES.len());
    text += "#define COUNT(array) (sizeof(array) / sizeof((array)[0]))\n";
    for (of, thresholds) in [("double", &THRESHOLDS[..]), ("float", &THRESHOLDS_F[..])] {
        let values: Vec<String> = thresholds.iter().map(|bits| format!("{bits:#x}U")).collect();
        let _ = writeln!(text, "static const uint64_t thresholds_of_{of}[] = {{ {} }};", values.join(", "));
    }
    text += "static const struct function {\n    const char *name;\n    double (*one)(double);\n";
    text +=
        "    double (*two)(double, double);\n    float (*one_f)(float);\n    float (*two_f)(float, float);\n";
    text += "} functions[] = {\n";
    for (name, of) in &FUNCTIONS {
        let mut columns = ["NULL".to_string(), "NULL".into(), "NULL".into(), "NULL".into()];
        let column = match of {
            Of::One(_) => 0,
            Of::Two(_) => 1,
            Of::OneF(_) => 2,
            Of::TwoF(_) => 3,
        };
        columns[column] = format!("lw_{name}");
        let _ = writeln!(text, "    {{ \"{name}\", {} }},", columns.join(", "));
    }
    text += "};\n";
    text += include_str!("libm/driver.c");
    let file = program.with_extension("c");
    std::fs::write(&file, text).expect("the folder of the tests takes files");
    let built = Command::new("cc")
        .args(["-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion"])
        .args(["-Wshadow", "-Wstrict-prototypes", "-Werror"])
        .arg(&file)
        .arg("-o")
        .arg(program)
        .arg("-lm")
        .output()
        .expect("there is a `cc`");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
}

fn hash(index: usize, of: &Of, class: usize) -> u64 {
    let mut random = Random(0x9e3779b97f4a7c15_u64.wrapping_mul((16 * index + class + 1) as u64));
    (0..ARGUMENTS)
        .fold(0, |hash: u64, _| hash.wrapping_mul(31).wrapping_add(of.hash_of_result(class, &mut random)))
}

impl Of {
    fn hash_of_result(&self, class: usize, random: &mut Random) -> u64 {
        let format = match self {
            Of::One(_) | Of::Two(_) => &DOUBLE,
            Of::OneF(_) | Of::TwoF(_) => &SINGLE,
        };
        let bits = format.argument(class, random);
        let f = f64::from_bits;
        let f_f = |bits: u64| f32::from_bits(bits as u32);
        let bits = match self {
            Of::One(of) => of(f(bits)).to_bits(),
            Of::Two(of) => of(f(bits), f(format.other(bits, class, random))).to_bits(),
            Of::OneF(of) => u64::from(of(f_f(bits)).to_bits()),
            Of::TwoF(of) => u64::from(of(f_f(bits), f_f(format.other(bits, class, random))).to_bits()),
        };
        // FNV-1a, to which all NaNs are the same.
        let size = bits & (format.infinity() | format.fraction());
        let bits = if size > format.infinity() { u64::MAX } else { bits };
        let byte = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x100000001b3);
        bits.to_le_bytes().into_iter().fold(0xcbf29ce484222325, byte)
    }
}

/// xorshift64*
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545f4914f6cdd1d)
    }
}

struct Format {
    width: u32,
    digits: u32,
    bias: u64,
    /// Where the exponential is finite.
    exponent: f64,
    thresholds: &'static [u64],
}

const DOUBLE: Format = Format { width: 64, digits: 52, bias: 1023, exponent: 760.0, thresholds: &THRESHOLDS };
const SINGLE: Format =
    Format { width: 32, digits: 23, bias: 127, exponent: 110.0, thresholds: &THRESHOLDS_F };

impl Format {
    fn is_single(&self) -> bool {
        self.width == 32
    }

    fn infinity(&self) -> u64 {
        (2 * self.bias + 1) << self.digits
    }

    fn fraction(&self) -> u64 {
        (1 << self.digits) - 1
    }

    fn bits_of(&self, x: f64) -> u64 {
        if self.is_single() { u64::from((x as f32).to_bits()) } else { x.to_bits() }
    }

    /// The bits of an argument, like `argument` of `driver.c`.
    fn argument(&self, class: usize, random: &mut Random) -> u64 {
        let (infinity, fraction, one) = (self.infinity(), self.fraction(), self.bias << self.digits);
        let (r, s) = (random.next(), random.next());
        let sign = (s >> 63) << (self.width - 1);
        let few = ((r >> 32) % 7).wrapping_sub(3);
        let uniform = |size: f64| ((r >> 11) as f64 / (1_u64 << 52) as f64 - 1.0) * size;
        match class {
            0 => r >> (64 - self.width),
            1 => self.bits_of(uniform(10.0)),
            2 => self.bits_of(uniform(1.0)),
            3 => self.bits_of(uniform(self.exponent)),
            4 => {
                let multiple = ((s >> 2) >> (r % 61)) as f64;
                let bits = self.bits_of(multiple * std::f64::consts::FRAC_PI_2);
                bits.wrapping_add(few) & (infinity | fraction) | sign
            }
            5 => {
                let mut bits = self.thresholds[(r % self.thresholds.len() as u64) as usize];
                let mut offset = few;
                if !self.is_single() {
                    bits += (r >> 40 & 1) << 32;
                    if r >> 41 & 1 != 0 {
                        offset = (s >> 1 & 0xffff_ffff).wrapping_sub(0x8000_0000);
                    }
                }
                bits.wrapping_add(offset) & (infinity | fraction) | sign
            }
            6 => {
                let offset = (s & fraction) >> (r % u64::from(self.digits));
                (if r >> 40 & 1 != 0 { one + offset } else { one - offset }) | sign
            }
            7 => (r % (self.bias - 19)) << self.digits | s & fraction | sign,
            8 => {
                let span = if r >> 40 & 1 != 0 { 28 } else { self.bias - 20 };
                (2 * self.bias - r % span) << self.digits | s & fraction | sign
            }
            _ => {
                let special = [0, 1, fraction, fraction + 1, one, infinity - 1, infinity, infinity + 1];
                special[(r % 8) as usize] | sign
            }
        }
    }

    /// The bits of the second of a pair, half of which have exponents that are less than 70 apart.
    fn other(&self, first: u64, class: usize, random: &mut Random) -> u64 {
        let bits = self.argument(class, random);
        let r = random.next();
        if r >> 63 == 0 {
            return bits;
        }
        let exponent = self.infinity();
        let near = first.wrapping_add((r % 140).wrapping_sub(70) << self.digits);
        bits & !exponent | near & exponent
    }
}
