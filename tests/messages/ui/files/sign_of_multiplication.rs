//! Signs of typography are no operators.

linkwright::mechanism!(file = "sign_of_multiplication.mech");

fn main() {
    let _: usize = FourBar::DEGREES_OF_FREEDOM;
    let _: f64 = FourBar::START.q[0];
}
