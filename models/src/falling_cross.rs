//! A cross of four balls that falls on the floor with one tip first, tumbles and comes to rest.
//!
//! Data: balls of 0.5 kg at 0.5 m, taken together as one body; 5000 N/m and 40 N s/m at each, cut where it would pull; centre at 1.2 m with 0.3 m/s along
//! x, turned by 30 degrees about x and then by 20 about its own y, 1 rad/s about its own z. Expected, of a separate integration at two tolerances that agree to
//! 2e-10: at 0.5 s z = 0.12145118118342 m, quaternion (0.9551194241, 0.0571155295, 0.0321654564, 0.2888772843), ω = (−8.7794535678, −0.3631717413,
//! 0.7182911909) rad/s; at 1 s z = 0.00977394444708 m; at 1.5 s −9.80999847e-4 m, near the rest at −4·0.5·9.81/(4·5000) m, and ω_z = 0.81379768134938 rad/s.

linkwright::mechanism! {
    /// Four balls on a cross above a plane.
    pub spatial FallingCross {
        gravity [m/s^2] = (0, 0, -9.81);
        body cross {
            mass [kg] = 2; inertia [kg*m^2] = (0.25, 0.25, 0.5);
            point a [m] = (0.5, 0, 0); point b [m] = (-0.5, 0, 0); point c [m] = (0, 0.5, 0); point d [m] = (0, -0.5, 0);
            surface tip_a: point(cross.a);
            surface tip_b: point(cross.b);
            surface tip_c: point(cross.c);
            surface tip_d: point(cross.d);
        }
        surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
        contact at_a: between(cross.tip_a, floor) = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 40);
        contact at_b: between(cross.tip_b, floor) = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 40);
        contact at_c: between(cross.tip_c, floor) = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 40);
        contact at_d: between(cross.tip_d, floor) = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 40);
        start {
            cross.center.x [m] = 0; cross.center.y [m] = 0; cross.center.z [m] = 1.2;
            cross.center.velocity.x [m/s] = 0.3; cross.rate.z [rad/s] = 1;
            cross.orientation = (0.951251242564198, 0.254887002244179, 0.167731259496521, 0.044943455527548);
        }
        expect { degrees_of_freedom = 6; contact_time(at_a) >= 10e-3 [s]; }
        output height [m] = cross.center.z;
        output rate_x [rad/s] = cross.rate.x;
        output rate_y [rad/s] = cross.rate.y;
        output rate_z [rad/s] = cross.rate.z;
        output force [N] = at_a.force + at_b.force + at_c.force + at_d.force;
    }
}
