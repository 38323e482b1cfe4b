//! A misspelt name in a file; coordinates that are used by name are no second error.

linkwright::mechanism!(file = "misspelt_body.mech");

fn main() {
    let mut positions = FourBar::positions(&FourBar::START.q);
    positions.crank_angle = linkwright::Angle::from_radians(0.5);
    let mut state: FourBarState = FourBar::START;
    state.q = positions.into();
    let _: f64 = FourBar::velocities(&state.v).crank_rate;
}
