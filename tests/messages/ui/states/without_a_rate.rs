//! A state that nothing moves, and a rate whose name is misspelt.

linkwright::mechanism! {
    planar Motor {
        input voltage [V];
        state current [A] = 0;
        rate curent = (voltage - 0.5 [ohm]*current)/2 [mH];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        torque drive: torque(pin) = 0.1 [N*m/A]*current;
    }
}

fn main() {
    // What stands in the model's place has the state.
    let current = Motor::internal(&Motor::START.z).current;
    println!("{current}");
}
