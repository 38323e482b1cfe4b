//! States from what encoders read.

use crate::assert_close;
use linkwright::{AssembleExt, Motion, Reading, State, coordinate, coordinate_values, measured};
use linkwright_models::four_bar::FourBar;

#[test]
fn encoders_give_the_state() {
    let model = FourBar::<f64>::default();
    let (crank, rocker) = (coordinate(&model, "crank_pin.angle"), coordinate(&model, "rocker_pin.angle"));
    let crank = crank.expect("an angle of a joint");
    let near = model.start();
    let reading = |coordinate, position, rate| Reading { coordinate, position, rate };
    let found = measured(&model, 0.0, &near, &[reading(crank, 1.2, 0.7)]).expect("regular");
    let given = [Motion { position: 1.2, rate: 0.7, acceleration: 0.0 }];
    let expected = model.kinematics(0.0, &near.q, &given).expect("regular");
    assert_close("q", &found.q, &expected.q, 1e-12);
    assert_close("v", &found.v, &expected.v, 1e-12);
    let values = coordinate_values(&model, 0.0, &found.q);
    assert!((values[usize::from(crank)] - 1.2).abs() < 1e-14, "{values:?}");
    if let Ok(rocker) = rocker {
        // A parallelogram: both turn alike.
        let found = measured(&model, 0.0, &near, &[reading(rocker, 1.2, 0.7)]).expect("regular");
        assert_close("q", &found.q, &expected.q, 1e-12);
    }
    // Nothing read: what is there, on the constraints.
    let off = State::new(near.q.map(|x| x + 1e-3), near.v);
    let found = measured(&model, 0.0, &off, &[]).expect("near");
    assert!(found.q != off.q);
    let projected = model.project(0.0, &State { q: found.q, ..off }).expect("near");
    assert_close("v", &found.v, &projected.v, 1e-12);
    let error = measured(&model, 0.0, &near, &[reading(crank, 1.0, 0.0); 2]).expect_err("one freedom");
    assert_eq!(error, linkwright::AssemblyError::WrongLength { needed: 1, given: 2 });
    let error = measured(&model, 0.0, &near, &[reading(crank, f64::NAN, 0.0)]).expect_err("not a number");
    assert!(
        matches!(error, linkwright::AssemblyError::GivenNotFinite { what: "crank_pin.angle" }),
        "{error}"
    );
    assert!(measured(&model, 0.0, &near, &[reading(99, 1.0, 0.0)]).is_err());
    let error = coordinate(&model, "crank_pin.angel").expect_err("no such coordinate");
    assert!(error.to_string().contains("`crank_pin.angel`"), "{error}");
}
