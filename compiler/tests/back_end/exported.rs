//! What stands in exported files and in the functions behind the C header, where names are unusual or parts are absent. What they compute
//! is compared in `tests/c/`, in the workspace's `tests/exported_c.rs`, and in `.ci/c`.

use super::compiled;
use linkwright_compiler::emit::{self, Home};
use linkwright_compiler::export::{self, Scalar};

/// A mechanism whose names are words of C and C++, or not in their letters.
const AWKWARD: &str = "
    planar INFINITY_ {
        param double [kg] = 2 in 0.5..4;
        param ω0 [rad/s] = 3;
        input class [N*m];
        rod int { mass [kg] = double; length [m] = 1; }
        rod switch { mass [kg] = 1; length [m] = 1; }
        joint this: revolute(ground(0, 0) [m], int.start);
        joint new: revolute(int.end, switch.start);
        force φ: torque(this) = class + 0.1 [N*m*s/rad]*ω0;
        output register [rad] = this.angle;
        OPTIONS
    }";

fn awkward(options: &str) -> String {
    AWKWARD.replace("OPTIONS", options)
}

#[test]
fn names_are_no_words_of_c() {
    let files = export::c(&compiled(&awkward("")).expect("it compiles"), Scalar::F32);
    assert_eq!(files.name, "infinity_");
    for field in ["float double_;", "float u3c90;", "float class_;", "float register_;"] {
        assert!(files.header.contains(field), "{field}: {}", files.header);
    }
    assert!(files.header.contains("from 0.5 to 4.0"), "{}", files.header);
    assert!(
        files.header.is_ascii() || !files.header.lines().any(|line| !line.is_ascii() && line.ends_with(';'))
    );
    // Comments may say ν and ω; names may not.
    for line in files.source.lines().filter(|line| !line.is_ascii()) {
        let code = line.split("/*").next().unwrap_or_default();
        assert!(code.is_ascii() || line.contains('"'), "{line}");
    }
    assert!(files.class.contains("class INFINITY_ {"), "{}", files.class);
}

/// No constraints: nothing to correct, and nothing of it is there.
#[test]
fn what_a_mechanism_has_not_is_absent() {
    let free = "planar Bob {
        body bob { mass [kg] = 1; inertia [kg*m^2] = 0.1; center [m] = (1, 0); }
        joint pin: revolute(ground(0, 0) [m], bob.origin);
    }";
    let files = export::c(&compiled(free).expect("it compiles"), Scalar::F64);
    for name in ["_corrected", "bob_assemble", "bob_inputs", "bob_parameters", "bob_read", "lambda[", " lw_"]
    {
        assert!(!files.header.contains(name) && !files.source.contains(name), "{name}");
    }
    assert!(
        files.header.contains("bob_step_rk4(bob_t *plant, double h, bob_tick_t *tick);"),
        "{}",
        files.header
    );
    // Constraints whose projection is not written out.
    let looped = "planar Loop {
        rod a { mass [kg] = 1; length [m] = 1; } rod b { mass [kg] = 1; length [m] = 2; } rod c { mass [kg] = 1; length [m] = 2; }
        joint p: revolute(ground(0, 0) [m], a.start);  joint q: revolute(a.end, b.start);
        joint r: revolute(b.end, c.end);               joint s: revolute(ground(2, 0) [m], c.start);
        start { a.angle [deg] = 60; b.angle [deg] ~ 20; }
    }";
    let of = |options: &str| {
        let text = looped.replace("rod a", &format!("{options} rod a"));
        export::c(&compiled(&text).expect("it compiles"), Scalar::F64).header
    };
    assert!(
        !of("").contains("corrected")
            && of("options { emit = (projection); }").contains("loop_step_rk4_corrected(")
    );
}

/// Unsafe code is emitted where it is asked for, and nowhere else; each function says what it takes for granted.
#[test]
fn unsafe_code_is_asked_for() {
    let text = |options: &str| {
        let compiled = compiled(&awkward(options)).expect("it compiles");
        emit::emit(&compiled, "", &Home::default()).1 + &export::shims(&compiled, &Home::default())
    };
    assert!(!text("").contains("unsafe"));
    let asked = text("options { export_c = f32; }");
    let functions = asked.matches("pub unsafe extern \"C\" fn infinity__").count();
    assert!(functions > 15 && asked.matches("# Safety").count() == functions, "{functions}");
    assert_eq!(asked.matches("#[repr(C)]").count(), 4, "the model, parameters, inputs and outputs");
    syn::parse_file(&asked).expect("it is Rust");
}
