//! Sun and ring have 122 teeth, which three planets do not share.

linkwright::mechanism! {
    planar Set {
        const AXES [mm] = 61;
        body arm {
            mass [kg] = 1; inertia [kg*m^2] = 1e-3;
            point pin[0] [m] = (AXES*cos(0 [deg]), AXES*sin(0 [deg]));
            point pin[1] [m] = (AXES*cos(120 [deg]), AXES*sin(120 [deg]));
            point pin[2] [m] = (AXES*cos(240 [deg]), AXES*sin(240 [deg]));
        }
        body sun  { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 41, module [mm] = 2); }
        body ring { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: internal(teeth = 81, module [mm] = 2); }
        joint main: revolute(ground(0, 0), arm.origin);
        joint axle: revolute(ground(0, 0), sun.center);
        joint rim:  revolute(ground(0, 0), ring.center);
        repeat p in 0..3 {
            body planet[p] { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
            joint bolt[p]: revolute(arm.pin[p], planet[p].center);
            gear inner[p]: gear(sun.rim, planet[p].rim);
            gear outer[p]: gear(planet[p].rim, ring.rim);
        }
    }
}

fn main() {}
