//! A slider-crank whose slider runs against a rigid stop at the end of its rail.
//!
//! Data: rods of 0.2 m, 1 kg and 0.5 m, 2 kg, a slider of 1.5 kg, released with the crank 120 degrees from the rail; a stop 0.64 m from the crank's
//! hinge, 60 mm before the linkage is stretched, with a restitution of 0.6. The linkage has one freedom: its energy is kept between the touches,
//! and each leaves 0.36 of the kinetic energy. Expected, of a separate integration in the angle of the crank (SciPy's DOP853 at 1e-13, which agrees
//! with 1e-11 to 1e-11 s): touches after 0.53916275258 s, 1.40756310193 s and 2.41075204604 s, the first at 8.80749302596 rad/s of the crank with
//! 9.636366629 N s; after three seconds the crank at 3.751322537732 rad with 1.27486387683 rad/s.

linkwright::mechanism! {
    /// A slider-crank whose stop takes the impulses of the whole loop.
    pub planar SliderCrankOnStop {
        param end [mm] = 640;
        param restitution [1] = 0.6;
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2; length [m] = 0.5; }
        body slider { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        joint hinge: revolute(ground(0, 0) [m], crank.start);
        joint pin: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, slider.center);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        limit stop: rail.travel in 0..end = rigid(restitution = restitution);
        start { hinge.angle [deg] = 120; hinge.rate [rad/s] = 0; coupler.angle [deg] ~ -20; }
        expect { degrees_of_freedom = 1; }
        options { emit = (null_space); }
        output angle [rad] = hinge.angle;
        output rate [rad/s] = hinge.rate;
        output travel [m] = rail.travel;
        output pressed [N] = stop.force;
    }
}
