//! Definitions and calls with mistakes: each has an error that names the part, and none panics.

use linkwright_generic::{BodyMotion, DefinitionError, Error, Formulation, Mechanism};
use linkwright_models::bricard::Bricard;
use linkwright_models::cam_follower::CamFollower;
use linkwright_models::car_axis::CarAxis;
use linkwright_models::dc_motor_arm::DcMotorArm;
use linkwright_models::double_wishbone::DoubleWishbone;
use linkwright_models::four_bar::FourBar;
use linkwright_models::planetary_gear_train::PlanetaryGearTrain;
use linkwright_models::rear_wheel::RearWheel;
use linkwright_models::slider_crank::SliderCrank;
use mechanisms::zoo::Mounted;
use mechanisms::zoo_cables::Hoisted;
use mechanisms::zoo_hysteresis::Worn;
use mechanisms::zoo_laws::Terrain;
use serde_json::{Value, json};

fn refused(definition: &str) -> DefinitionError {
    Mechanism::from_definition(definition).expect_err("it has a mistake")
}

/// The four-bar with something changed.
fn changed(change: impl FnOnce(&mut Value)) -> DefinitionError {
    let mut tree: Value = serde_json::from_str(FourBar::<f64>::DEFINITION).expect("a definition");
    change(&mut tree);
    refused(&tree.to_string())
}

#[test]
fn what_is_no_definition_is_refused() {
    assert!(matches!(refused(""), DefinitionError::Json { .. }));
    assert!(matches!(refused("{\"linkwright\": 1"), DefinitionError::Json { .. }));
    assert!(matches!(refused("[]"), DefinitionError::Malformed { .. }));
    assert!(matches!(refused("{\"linkwright\": 2}"), DefinitionError::Malformed { .. }));
    let deep = format!("{}1{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(matches!(refused(&deep), DefinitionError::Json { .. }));
}

#[test]
fn errors_name_the_part() {
    let kind = |part: &str, kind: &str| DefinitionError::UnknownKind { part: part.into(), kind: kind.into() };
    let name = |part: &str, name: &str| DefinitionError::UnknownName { part: part.into(), name: name.into() };
    assert_eq!(changed(|tree| tree["joints"][0]["kind"] = json!("hinge")), kind("crank_pin", "hinge"));
    assert_eq!(changed(|tree| tree["kind"] = json!("curved")), kind("FourBar", "curved"));
    assert_eq!(changed(|tree| tree["bodies"][0]["kind"] = json!("balloon")), kind("crank", "balloon"));
    let place = json!({"place": "crank.tip"});
    assert_eq!(changed(|tree| tree["joints"][2]["first"] = place), name("left", "crank.tip"));
    let inch = json!({"unit": "inch", "value": {"number": "1"}});
    let unit = DefinitionError::Unit { part: "crank".into(), unit: "inch".into() };
    assert_eq!(changed(|tree| tree["bodies"][0]["properties"]["length"] = inch), unit);
    let missing = DefinitionError::Malformed { part: "crank".into(), field: "length".into() };
    let properties = json!({"mass": {"unit": "kg", "value": {"number": "1"}}});
    assert_eq!(changed(|tree| tree["bodies"][0]["properties"] = properties), missing);
    let infinite = json!({"unit": "kg", "value": {"op": "/", "args": [{"number": "1"}, {"number": "0"}]}});
    let error = changed(|tree| tree["bodies"][0]["properties"]["mass"] = infinite);
    assert!(matches!(error, DefinitionError::Value { .. }), "{error}");
    let state = json!([{"name": "felt", "unit": "N*m", "value": {"number": "0"}}]);
    let rate = json!([{"name": "felt", "value": {"name": "crank_pin.reaction.torque"}}]);
    let error = changed(|tree| {
        tree["states"] = state;
        tree["rates"] = rate;
    });
    assert!(matches!(&error, DefinitionError::NotThereYet { part, .. } if part == "felt"), "{error}");
}

#[test]
fn a_curve_that_is_no_graph_is_not_there_yet() {
    let error = changed(|tree| {
        let still = json!({"unit": "m", "value": {"number": "1"}});
        let joint = &mut tree["joints"][0];
        joint["kind"] = json!("point_on_curve");
        (joint["x"], joint["y"]) = (still.clone(), still);
    });
    assert!(matches!(&error, DefinitionError::NotThereYet { part, .. } if part == "crank_pin"), "{error}");
}

#[test]
fn names_that_stand_for_themselves_are_refused() {
    let error = changed(|tree| {
        tree["signals"] = json!([{"name": "loop", "unit": "1", "value": {"name": "loop"}}]);
        tree["loads"] =
            json!([{"name": "pull", "kind": "torque", "on": "crank_pin", "value": {"name": "loop"}}]);
    });
    assert!(matches!(&error, DefinitionError::Value { part, .. } if part == "pull"), "{error}");
    // Each twice the one before it.
    let error = changed(|tree| {
        let twice = |of: String| json!({"op": "+", "args": [{"name": of}, {"name": of}]});
        let signals = (1..60)
            .map(|k| json!({"name": format!("s{k}"), "unit": "1", "value": twice(format!("s{}", k - 1))}));
        let first = json!({"name": "s0", "unit": "1", "value": {"name": "time"}});
        tree["signals"] = std::iter::once(first).chain(signals).collect();
        tree["loads"] =
            json!([{"name": "pull", "kind": "torque", "on": "crank_pin", "value": {"name": "s59"}}]);
    });
    assert!(matches!(&error, DefinitionError::Value { part, .. } if part == "pull"), "{error}");
}

#[test]
fn wrong_calls_have_errors() {
    let mut mechanism = Mechanism::from_definition(SliderCrank::<f64>::DEFINITION).expect("it is there");
    let mut state = mechanism.origin();
    let (mut a, mut lambda) = (vec![0.0; mechanism.velocity_count()], vec![0.0; mechanism.row_count()]);
    let plain = Formulation::Lagrange;
    let mut solve = |time: f64, q: &[f64], v: &[f64], inputs: &[f64]| {
        mechanism.acceleration(time, q, v, inputs, plain, &mut a, &mut lambda)
    };
    let length = |what, expected, given| Err(Error::Length { what, expected, given });
    assert_eq!(solve(0.0, &state.q, &state.v, &[1.0]), length("inputs", 2, 1));
    assert_eq!(solve(0.0, &state.q[1..], &state.v, &[0.0; 2]), length("positions", 9, 8));
    assert_eq!(solve(0.0, &state.q, &[], &[0.0; 2]), length("velocities", 9, 0));
    let infinite = |what| Err(Error::Value { what, value: f64::INFINITY });
    assert_eq!(solve(f64::INFINITY, &state.q, &state.v, &[0.0; 2]), infinite("the time"));
    assert_eq!(solve(0.0, &state.q, &state.v, &[f64::INFINITY, 0.0]), infinite("an input"));
    let unknown = Err(Error::UnknownName { name: "wheel".into() });
    assert_eq!(mechanism.set_body(&mut state, "wheel", &BodyMotion::default()), unknown);
    let mut top = Mechanism::from_definition(Bricard::<f64>::DEFINITION).expect("it is there");
    let mut position = top.origin();
    let flat = BodyMotion { orientation: [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]], ..BodyMotion::default() };
    assert!(matches!(top.set_body(&mut position, "rod_1", &flat), Err(Error::Value { .. })));
    assert!(top.set_parameter("mass", 1.0).is_err());
    let before = state.clone();
    assert!(mechanism.step(0.0, &mut state, &[0.0; 2], plain, f64::NAN).is_err());
    assert!(mechanism.step(0.0, &mut state, &[], plain, 1e-3).is_err());
    assert_eq!(state, before);
    assert!(mechanism.set_parameter("radius", 1.0).is_err());
    let mut wheel = Mechanism::from_definition(RearWheel::<f64>::DEFINITION).expect("it is there");
    assert!(matches!(wheel.set_parameter("speed", 0.5), Err(DefinitionError::Value { .. })));
    assert!(matches!(wheel.set_parameter("speed", f64::NAN), Err(DefinitionError::Value { .. })));
    wheel.set_parameter("speed", 2.0).expect("within its bounds");
}

/// All rods in one line: the constraints along it lose rank. Without joints, a rod without mass falls with nothing to say how.
#[test]
fn a_singular_position_is_said() {
    let mut mechanism = Mechanism::from_definition(FourBar::<f64>::DEFINITION).expect("it is there");
    let mut state = mechanism.origin();
    for (body, x) in [("crank", 0.5), ("coupler", 1.5), ("rocker", 1.5)] {
        let flat = BodyMotion { position: [x, 0.0, 0.0], velocity: [0.0, 1.0, 0.0], ..BodyMotion::default() };
        mechanism.set_body(&mut state, body, &flat).expect("a body");
    }
    let (mut a, mut lambda) = (vec![0.0; 9], vec![0.0; 8]);
    let plain = Formulation::Lagrange;
    let error = mechanism.acceleration(0.0, &state.q, &state.v, &[], plain, &mut a, &mut lambda);
    assert_eq!(error, Err(Error::Singular { time: 0.0, row: Some("right.x".into()) }));

    let mut free: Value = serde_json::from_str(FourBar::<f64>::DEFINITION).expect("a definition");
    free["joints"] = json!([]);
    free["bodies"][0]["properties"]["mass"]["value"] = json!({"number": "0"});
    let mut mechanism = Mechanism::from_definition(&free.to_string()).expect("it is there");
    let error = mechanism.acceleration(0.0, &state.q, &state.v, &[], plain, &mut a, &mut []);
    assert_eq!(error, Err(Error::Singular { time: 0.0, row: None }));
}

/// Every node of some definitions is taken away, or replaced by other things: no answer is a panic.
#[test]
fn no_definition_panics() {
    let definitions = [
        SliderCrank::<f64>::DEFINITION,
        CarAxis::<f64>::DEFINITION,
        PlanetaryGearTrain::<f64>::DEFINITION,
        RearWheel::<f64>::DEFINITION,
        Bricard::<f64>::DEFINITION,
        DoubleWishbone::<f64>::DEFINITION,
        CamFollower::<f64>::DEFINITION,
        DcMotorArm::<f64>::DEFINITION,
        Terrain::<f64>::DEFINITION,
        Worn::<f64>::DEFINITION,
        Mounted::<f64>::DEFINITION,
        Hoisted::<f64>::DEFINITION,
    ];
    let others = [json!(null), json!(-1), json!("name"), json!([]), json!({}), json!({"name": "time"})];
    let mut judged = 0;
    for definition in definitions {
        let tree: Value = serde_json::from_str(definition).expect("a definition");
        let mut paths = Vec::new();
        paths_of(&tree, String::new(), &mut paths);
        for (k, path) in paths.iter().enumerate() {
            let mut other = tree.clone();
            *other.pointer_mut(path).expect("it is there") = others[k % others.len()].clone();
            is_judged(&other.to_string());
            judged += 1;
        }
    }
    assert!(judged > 2000, "{judged}");
}

fn paths_of(tree: &Value, path: String, paths: &mut Vec<String>) {
    match tree {
        Value::Array(elements) => {
            for (k, element) in elements.iter().enumerate() {
                paths_of(element, format!("{path}/{k}"), paths);
            }
        }
        Value::Object(fields) => {
            for (key, field) in fields {
                paths_of(field, format!("{path}/{key}"), paths);
            }
        }
        _ => {}
    }
    paths.push(path);
}

/// It is refused, or it gives accelerations that are finite, or an error.
fn is_judged(definition: &str) {
    let Ok(mut mechanism) = Mechanism::from_definition(definition) else { return };
    let state = mechanism.origin();
    let inputs = vec![0.0; mechanism.inputs().count()];
    let (mut a, mut lambda) = (vec![0.0; mechanism.velocity_count()], vec![0.0; mechanism.row_count()]);
    let solved =
        mechanism.acceleration(0.0, &state.q, &state.v, &inputs, Formulation::Lagrange, &mut a, &mut lambda);
    assert!(solved.is_err() || a.iter().chain(&lambda).all(|x| x.is_finite()));
}
