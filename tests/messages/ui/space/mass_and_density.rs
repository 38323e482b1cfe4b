//! A mass and a density.

linkwright::mechanism! {
    spatial Wrong {
        sphere ball { mass [kg] = 1; density [kg/m^3] = 7800; radius [m] = 0.1; }
    }
}

fn main() {}
