//! Cases that are no definitions: words and characters of the language in any order.

use super::random::Random;

/// Everything that stands for something somewhere.
const WORDS: &str = "planar spatial pub const param input gravity body rod disk box sphere cylinder particle beam flexible node marker line \
    joint constraint drive force torque spring damper torsion_spring start options expect output repeat gear bevel worm \
    belt rack screw differential revolute prismatic fixed distance point_on_line point_on_plane universal spherical \
    cylindrical planar constant_velocity mass inertia length radius width height size density center point products \
    inertia_axes axis reference second_axis about_x about_z ratio phase pitch stiffness damping direction angle rate \
    travel speed angle_1 rate_2 x y z velocity origin end orientation coordinates cut independent redundant emit crate \
    auto solution multipliers independent tree absolute drop keep refuse penalty projection null_space tangent degrees_of_freedom operations ground time \
    pi sqrt abs sign min max sin cos tan asin acos atan2 atan exp ln log10 sinh cosh tanh hypot clamp deadband masing bouc_wen backbone depth share exponent beta gamma resistance step smoothstep wrap dot cross norm signal along if and or not energy power kinetic_energy in a b c i N \
    m kg s rad deg rpm N mm Hz self type r#type fn table file grid periodic cubic outside hold columns skip slope state memory event rises falls crosses every jump part place Leg DcMotor Tyre left Größe";

const NUMBERS: &str = "0 1 2 3 10 96 1000000 9223372036854775807 99999999999999999999999 0.5 1e308 1e-308 5e-324 1e400 \
    0.1f32 0x10 1_000 4.9e-162";

const MARKS: &str =
    "; ; ; ; , , = = : : . . .. ~ + - * / ^ < > <= == != ! & | % # $ @ ? -> ( ) ( ) [ ] [ ] { } { } « »";

const OTHERS: &str = "\"text\" 'c' 'lifetime b\"bytes\" r\"raw\" 1.";

/// One token, of any kind.
pub fn token(random: &mut Random) -> String {
    let list = match random.below(20) {
        0..=8 => WORDS,
        9..=11 => NUMBERS,
        12..=18 => MARKS,
        _ => OTHERS,
    };
    random.word(list).to_string()
}

/// A number, of any size.
pub fn number(random: &mut Random) -> String {
    random.word(NUMBERS).to_string()
}

/// Tokens in any order, mostly with the beginning of a definition.
pub fn soup(random: &mut Random) -> Vec<String> {
    let most = 2 << random.below(8);
    let length = 1 + random.below(most);
    let mut tokens: Vec<String> = (0..length).map(|_| token(random)).collect();
    if !random.once_in(4) {
        let kind = random.word("planar spatial");
        tokens.splice(0..0, [kind, "Soup", "{"].map(str::to_string));
    }
    tokens
}
