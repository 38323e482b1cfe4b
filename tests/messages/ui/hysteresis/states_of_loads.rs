//! The states of a load are called by its name, and have fields in what stands in the model's place, too.

linkwright::mechanism! {
    planar Mount {
        table bar(way [mm]) [N] = [(0, 0), (1, 100), (2, 150)], linear, outside = hold;
        body cart { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        force bush: masing(rail, backbone = bar);
        force wear: bouc_wen(rail, stiffness [N/m] = 1e5, depth [mm] = 0, beta = 0.5, gamma = 0.5, exponent = 2);
        output wrong [N] = bush.tension;
    }
}

fn main() {
    let named = Mount::internal(&Mount::START.z);
    println!("{} {}", named.bush_element_1, named.wear_deflection);
}
