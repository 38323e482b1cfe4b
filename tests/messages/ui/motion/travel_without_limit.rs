linkwright::mechanism! {
    planar Drawer {
        body drawer { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint rail: prismatic(ground(0, 0) [m], drawer.center, axis = (1, 0));
        expect { rail.travel in -0.5..0.5 [m]; }
    }
}

fn main() {}
