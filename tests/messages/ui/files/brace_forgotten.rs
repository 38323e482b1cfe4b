//! A brace that is forgotten in a file; what the model is used for is no second error.

linkwright::mechanism!(file = "brace_forgotten.mech");

fn main() {
    let _: usize = FourBar::DEGREES_OF_FREEDOM;
    let _: f64 = FourBar::START.q[0];
}
