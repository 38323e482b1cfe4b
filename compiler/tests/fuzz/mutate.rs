//! Changes to a definition: of tokens, of statements, and statements that a mechanism might have had.

#![allow(clippy::ptr_arg)] // All mutations have one type.

use super::random::Random;
use super::soup;
use super::tokens::{groups, statements};
use std::ops::Range;

type Mutation = fn(&mut Random, &mut Vec<String>, &[String]);

/// Each as often as it stands here. The last argument is another definition.
const MUTATIONS: [Mutation; 36] = [
    delete_statement,
    duplicate_statement,
    swap_statements,
    move_statement,
    foreign_statement,
    new_statement,
    new_statement,
    new_statement,
    swap_blocks,
    repeat_statement,
    swap_names,
    swap_names,
    other_word,
    other_word,
    other_word,
    rename,
    number,
    number,
    nudge,
    nudge,
    nudge,
    to_parameter,
    to_parameter,
    number_to_expression,
    number_to_expression,
    negate,
    unit,
    unit,
    delete_token,
    duplicate_token,
    insert_token,
    replace_token,
    wrap,
    deepen,
    lengthen,
    cut,
];

/// Changes a definition, mostly once.
pub fn mutate(random: &mut Random, tokens: &mut Vec<String>, other: &[String]) {
    for _ in 0..1 + random.below(4).saturating_sub(1) {
        MUTATIONS[random.below(MUTATIONS.len())](random, tokens, other);
    }
}

// ---- Statements -------------------------------------------------------------------------------------------------

fn statement(random: &mut Random, tokens: &[String]) -> Option<Range<usize>> {
    random.of(&statements(tokens)).cloned()
}

fn delete_statement(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(range) = statement(random, tokens) else { return };
    tokens.drain(range);
}

fn duplicate_statement(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(range) = statement(random, tokens) else { return };
    let copy = tokens[range.clone()].to_vec();
    tokens.splice(range.end..range.end, copy);
}

fn swap_statements(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let all = statements(tokens);
    swap(random, tokens, &all);
}

fn swap_blocks(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let all: Vec<_> = groups(tokens).into_iter().filter(|group| tokens[group.start] == "{").collect();
    swap(random, tokens, &all);
}

fn swap(random: &mut Random, tokens: &mut Vec<String>, all: &[Range<usize>]) {
    let (Some(a), Some(b)) = (random.of(all).cloned(), random.of(all).cloned()) else { return };
    let (a, b) = if a.start <= b.start { (a, b) } else { (b, a) };
    if a.end > b.start {
        return;
    }
    let (first, second) = (tokens[a.clone()].to_vec(), tokens[b.clone()].to_vec());
    tokens.splice(b, first);
    tokens.splice(a, second);
}

fn move_statement(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(range) = statement(random, tokens) else { return };
    let moved: Vec<String> = tokens.drain(range).collect();
    let at = statement(random, tokens).map_or(tokens.len(), |range| range.start);
    tokens.splice(at..at, moved);
}

fn foreign_statement(random: &mut Random, tokens: &mut Vec<String>, other: &[String]) {
    let (Some(theirs), Some(ours)) = (statement(random, other), statement(random, tokens)) else { return };
    let end = if random.once_in(2) { ours.start } else { ours.end };
    tokens.splice(ours.start..end, other[theirs].to_vec());
}

/// A statement that fits the names of the definition: `J` is a joint, `B` a body, `P` a place, `Q` a quantity, `L` a
/// load, `X` a value, `#` a number.
const TEMPLATES: [&str; 56] = [
    "joint new : revolute ( P , P ) ;",
    "joint new : revolute ( P , P ) = penalty ( stiffness = X , damping = X ) ;",
    "joint new : fixed ( P , P ) = penalty ( stiffness = X , torsional_stiffness = X , damping_along = line , smallest = X ) ;",
    "joint new : revolute ( P , P , axis = ( # , # , # ) ) ;",
    "joint new : fixed ( P , P ) ;",
    "joint new : prismatic ( P , P , axis = ( # , # ) ) ;",
    "joint new : cylindrical ( P , P , axis = ( # , # , # ) ) ;",
    "joint new : universal ( P , P , axis = ( 1 , 0 , 0 ) , second_axis = ( 0 , 1 , 0 ) ) ;",
    "joint new : spherical ( P , P ) ;",
    "joint new : distance ( P , P , length = X ) ;",
    "table outline ( angle [ deg ] ) [ mm ] = [ ( 0 , 0 ) , ( 90 , # ) , ( 180 , 1 ) , ( 360 , 0 ) ] , periodic ;",
    "joint new : cam ( P , P , lift = outline , base [ m ] = # , radius = X ) ;",
    "joint new : point_on_curve ( P , P , y [ m ] = # * new . parameter ) ;",
    "joint new : point_on_curve ( P , P , x [ m ] = X + cos ( new . parameter / # [ m ] ) * 1 [ m ] , y [ m ] = new . parameter ) ;",
    "joint new : point_on_curve ( P , P , x [ m ] = # * sin ( Q ) , y [ m ] = # * cos ( new . parameter / # [ m ] ) ) ;",
    "expect { J . force > # ; J . reaction . size [ N ] < X ; }",
    "joint new : point_on_line ( line ( P , P ) , P ) ;",
    "joint new : point_on_plane ( P , P , axis = ( # , # , # ) ) ;",
    "joint new : constant_velocity ( P , P , axis = ( # , # , # ) ) ;",
    "joint new : screw ( P , P , axis = ( 1 , # , 0 ) , pitch [ m ] = # ) ;",
    "constraint new : Q - # * Q = 0 ;",
    "constraint new : Q = X ;",
    "constraint new : gear ( J , B , ratio = # ) ;",
    "gear new : gear ( B . rim , B . rim ) ;",
    "mesh new : mesh ( B . rim , B . rim , stiffness [ N / m ] = X , backlash [ m ] = # ) ;",
    "mesh new : mesh ( B . rim , B . rim , stiffness [ N / m ] = X , axes = moving ) ;",
    "shaft new : shaft ( J , B , ratio = # , stiffness [ N * m ] = # ) ;",
    "constraint new : rack ( J , J , radius [ m ] = # , phase = 0 ) ;",
    "differential new : differential ( J , B , J ) ;",
    "drive new : Q = # [ rad / s ] * time ;",
    "drive new : Q = sin ( # * time / 1 [ s ] ) * X ;",
    "force new : force ( P ) = ( X , X ) ;",
    "force new : force ( P , direction = ( # , # ) ) = X ;",
    "torque new : torque ( J ) = - X * Q ;",
    "spring new : spring ( P , P , stiffness [ N / m ] = # , length [ m ] = # ) ;",
    "torsion_spring new : torsion_spring ( J , stiffness [ N * m ] = # , angle = # [ deg ] ) ;",
    "output new [ 1 ] = if ( Q > # and not X == # , min ( # , X ) , atan2 ( # , # ) / 1 [ rad ] ) ;",
    "output new [ m ] = distance ( P , P ) ^ # ;",
    "output new [ W ] = power ( L ) + # * energy / 1 [ s ] ;",
    "output new [ 1 ] = sqrt ( X / X ) + exp ( # ) ;",
    "start { Q = # ; Q ~ # ; }",
    "start { Q [ deg ] = # ; }",
    "options { redundant = drop ; emit = ( tangent , projection , penalty , null_space ) ; }",
    "options { coordinates = absolute ; cut = J ; independent = ( Q , Q ) ; inertia = accept ; }",
    "expect { degrees_of_freedom = 2 ; operations <= # ; }",
    "param new [ 1 ] = # in # .. # ;",
    "particle new { mass [ kg ] = # ; }",
    "rod new { mass [ kg ] = X ; length [ m ] = # ; }",
    "flexible new ( file = \"new.flex\" ) { point tip = node ( # ) ; modes = 1 .. # ; damping_ratio = X ; }",
    "beam new { mass [ kg ] = X ; length [ m ] = # ; young [ GPa ] = # ; area [ m^2 ] = # ; second_moment [ m^4 ] = # ; }",
    "modes = ( axial = # , bending = # ) ;",
    "modes = ( bending_y = # , torsion = # ) ; shear_modulus [ GPa ] = # ;",
    "shapes = clamped ;",
    "theory = timoshenko ; shear_modulus [ GPa ] = # ;",
    "start { B = static ; }",
    "expect { deflection ( P ) <= # [ mm ] ; }",
];

fn new_statement(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let template = TEMPLATES[random.below(TEMPLATES.len())];
    let new: Vec<String> = template.split(' ').flat_map(|piece| filled(random, tokens, piece)).collect();
    let at = match tokens.last() {
        Some(last) if last == "}" => tokens.len() - 1,
        _ => tokens.len(),
    };
    tokens.splice(at..at, new);
}

fn filled(random: &mut Random, tokens: &[String], piece: &str) -> Vec<String> {
    let split = |text: String| text.split(' ').map(str::to_string).collect();
    let joints = || declared(tokens, &["joint"]);
    let bodies = || {
        declared(
            tokens,
            &["body", "rod", "disk", "box", "particle", "sphere", "cylinder", "beam", "flexible"],
        )
    };
    match piece {
        "J" => vec![one(random, &joints())],
        "B" => vec![one(random, &bodies())],
        "L" => {
            vec![one(random, &declared(tokens, &["force", "torque", "spring", "damper", "torsion_spring"]))]
        }
        "X" => vec![one(random, &declared(tokens, &["param", "input", "const"]))],
        "#" => vec![some_number(random)],
        "P" if random.once_in(5) => split("ground ( 0 , 0.5 ) [ m ]".to_string()),
        "P" => {
            let body = one(random, &bodies());
            let mut points = declared(tokens, &["point", "marker"]);
            points.extend(["center", "origin", "start", "end"].map(str::to_string));
            split(format!("{body} . {}", one(random, &points)))
        }
        "Q" if random.once_in(3) => split(format!("{} . angle", one(random, &bodies()))),
        "Q" => {
            let quantity =
                random.word("angle angle rate travel speed angle_1 rate_2 center.x center.velocity.y");
            split(format!("{} . {}", one(random, &joints()), quantity.replace('.', " . ")))
        }
        _ => vec![piece.to_string()],
    }
}

fn one(random: &mut Random, names: &[String]) -> String {
    random.of(names).cloned().unwrap_or("nothing".to_string())
}

/// The names after these words.
fn declared(tokens: &[String], words: &[&str]) -> Vec<String> {
    let named = tokens.windows(2).filter(|pair| words.contains(&pair[0].as_str()) && is_word(&pair[1]));
    named.map(|pair| pair[1].clone()).collect()
}

fn repeat_statement(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(range) = statement(random, tokens) else { return };
    let rounds = random.word("0 1 2 3 3 7 40 300 9999 10001 1000000000 9223372036854775807");
    let first = random.word("0 0 0 0 1 -1 -9223372036854775807 rounds");
    tokens.insert(range.end, "}".to_string());
    let head = format!("repeat k in {first} .. {rounds} {{");
    tokens.splice(range.start..range.start, head.split(' ').map(str::to_string));
    // The first name in it gets the index, so that the rounds do not collide.
    if random.once_in(2) {
        let body = range.start + head.split(' ').count();
        let at = (body + 1..body + range.len()).find(|at| is_word(&tokens[*at]));
        tokens.splice(at.map_or(0..0, |at| at + 1..at + 1), ["[", "k", "]"].map(str::to_string));
    }
}

// ---- Words and numbers ------------------------------------------------------------------------------------------

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

fn is_number(token: &str) -> bool {
    token.starts_with(|c: char| c.is_ascii_digit())
}

fn position(random: &mut Random, tokens: &[String], is: impl Fn(&str) -> bool) -> Option<usize> {
    let places: Vec<usize> = (0..tokens.len()).filter(|at| is(&tokens[*at])).collect();
    random.of(&places).copied()
}

fn swap_names(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let (a, b) = (position(random, tokens, is_word), position(random, tokens, is_word));
    let (Some(a), Some(b)) = (a, b) else { return };
    if random.once_in(2) { tokens.swap(a, b) } else { tokens[a] = tokens[b].clone() }
}

/// Words that may stand in one another's place.
const CLASSES: [&str; 14] = [
    "body rod disk box sphere cylinder particle beam flexible",
    "revolute prismatic fixed distance spherical universal cylindrical planar screw constant_velocity point_on_line \
     point_on_plane cam point_on_curve",
    "angle rate travel speed parameter parameter_rate x y z velocity origin center start end angle_1 rate_1 angle_2 travel_2",
    "sin cos tan asin acos exp ln sqrt abs sign",
    "planar spatial",
    "gear rack belt screw bevel worm differential",
    "external internal rack bevel worm",
    "teeth starts cone diameter module shift helix addendum dedendum first bore face_width pressure_angle",
    "mesh shaft",
    "memory state param const",
    "static kinetic breakaway torque force preload restitution rest",
    "rises falls crosses every jump",
    "force torque spring damper torsion_spring",
    "mass inertia length radius width height density center size point marker",
];

fn other_word(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let class = CLASSES[random.below(CLASSES.len())];
    let is = |token: &str| class.split(' ').any(|word| word == token);
    let Some(at) = position(random, tokens, is) else { return };
    tokens[at] = random.word(class).to_string();
}

/// A name that is unusual, everywhere.
fn rename(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_word) else { return };
    let new = random.word(
        "Größe 长度 π ç_1 q v u a a0 k0 lambda time_ constants r#type r#fn _ __ R Self out inf NaN f64 Option m kg i core \
         linkwright start end origin center x angle A Q State parameters phases scalar two_alpha factored self_",
    );
    let old = std::mem::replace(&mut tokens[at], new.to_string());
    for token in tokens.iter_mut().filter(|token| **token == old) {
        *token = new.to_string();
    }
}

fn some_number(random: &mut Random) -> String {
    match random.below(6) {
        0 => soup::number(random),
        1 => random.word("0 1 2 0.5 1e-9 1e9 1e150 1e-150 1e-300 1e300 1.7976931348623157e308").to_string(),
        2 => format!("{}.{}", random.below(4), random.below(1000)),
        _ => random.word("0 1 2 3 0.1 0.5 90").to_string(),
    }
}

fn number(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_number) else { return };
    tokens[at] = some_number(random);
}

/// A number nearly as large: most of what was right is right still.
fn nudge(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_number) else { return };
    if let Ok(value) = tokens[at].parse::<f64>() {
        tokens[at] = format!("{}", value * (0.9 + 0.01 * random.below(21) as f64));
    }
}

/// A number, as the default of a parameter.
fn to_parameter(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let (Some(at), Some(open)) = (position(random, tokens, is_number), tokens.iter().position(|t| t == "{"))
    else {
        return;
    };
    let value = std::mem::replace(&mut tokens[at], format!("number * 1 [{}]", random.word("m kg rad N 1 1")));
    let declaration = format!("param number [ 1 ] = {value} ;");
    tokens.splice(open + 1..open + 1, declaration.split(' ').map(str::to_string));
}

fn negate(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_number) else { return };
    tokens.insert(at, "-".to_string());
}

fn number_to_expression(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    const EXPRESSIONS: [&str; 16] = [
        "( 0 / 0 )",
        "( 1 / 0 )",
        "( 1e308 * 10 )",
        "( 1e308 ^ 2 )",
        "( 1e-308 ^ 2 )",
        "( 0 ^ - 1 )",
        "( 0 ^ 0 )",
        "( - 1 ) ^ 0.5",
        "( ln ( 0 ) )",
        "( sqrt ( - 1 ) )",
        "( 2 - 2 )",
        "( # * X )",
        "( X / X )",
        "( Q * # )",
        "( if ( time > 1 [ s ] , # , # ) )",
        "( acos ( 2 ) / 1 [ rad ] )",
    ];
    let Some(at) = position(random, tokens, is_number) else { return };
    let template = EXPRESSIONS[random.below(EXPRESSIONS.len())];
    let new: Vec<String> = template.split(' ').flat_map(|piece| filled(random, tokens, piece)).collect();
    tokens.splice(at..=at, new);
}

fn unit(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let all: Vec<_> = groups(tokens).into_iter().filter(|group| tokens[group.start] == "[").collect();
    let Some(group) = random.of(&all).cloned() else { return };
    let new = random.word(
        "1 m mm km kg g s rad deg rev rpm N kN N*m N/m kg*m^2 m/s^2 rad/s 1/s Hz m^-1 m^99 m^9223372036854775807 kgg mdeg \
         m//s m*",
    );
    tokens.splice(group, [format!("[{new}]")]);
}

// ---- Tokens -----------------------------------------------------------------------------------------------------

fn any(random: &mut Random, tokens: &[String]) -> Option<usize> {
    position(random, tokens, |_| true)
}

fn delete_token(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    tokens.remove(at);
}

fn duplicate_token(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    let copy = tokens[at].clone();
    tokens.insert(at, copy);
}

fn insert_token(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    tokens.insert(at, soup::token(random));
}

fn replace_token(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    tokens[at] = soup::token(random);
}

/// Delimiters around a few tokens.
fn wrap(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    let (open, close) = [("(", ")"), ("«", "»"), ("{", "}"), ("[", "]")][random.below(4)];
    let end = (at + 1 + random.below(4)).min(tokens.len());
    tokens.insert(end, close.to_string());
    tokens.insert(at, open.to_string());
}

/// One token, nested.
fn deepen(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_number) else { return };
    let levels = [1, 10, 94, 97, 200, 1000][random.below(6)];
    let (open, close) =
        [("(", ")"), ("«", "»"), ("{", "}"), ("[", "]"), ("-", ""), ("sin (", ")"), ("2 ^", "")]
            [random.below(7)];
    let repeated = |text: &str| format!("{text} ").repeat(levels);
    tokens.splice(at + 1..at + 1, repeated(close).split_whitespace().map(str::to_string));
    tokens.splice(at..at, repeated(open).split_whitespace().map(str::to_string));
}

/// One number, as many terms.
fn lengthen(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = position(random, tokens, is_number) else { return };
    let terms = [2, 50, 95, 97, 5000][random.below(5)];
    let operator = random.word("+ - * / ^ < and .. ,");
    let more = format!("{operator} {} ", tokens[at]).repeat(terms);
    tokens.splice(at + 1..at + 1, more.split_whitespace().map(str::to_string));
}

/// Half typed: nothing behind a token, or nothing up to the end of its statement.
fn cut(random: &mut Random, tokens: &mut Vec<String>, _: &[String]) {
    let Some(at) = any(random, tokens) else { return };
    let around = statements(tokens).into_iter().find(|range| range.contains(&at));
    match around {
        Some(range) if random.once_in(2) => {
            tokens.drain(at..range.end);
        }
        _ => tokens.truncate(at),
    }
}
