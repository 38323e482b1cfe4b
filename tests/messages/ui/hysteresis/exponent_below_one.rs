//! An exponent below one.

linkwright::mechanism! {
    planar Mount {
        param share = 0.1;
        body cart { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        force bush: bouc_wen(rail, stiffness [N/m] = 1e5, share = share, depth [mm] = 2, beta = 0.5, gamma = 0.5, exponent = 0.5);
    }
}

fn main() {}
