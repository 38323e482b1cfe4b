//! A wheel of spokes without a rim, which walks down a slope.
//!
//! After McGeer (Int. J. Robotics Research 9(2) (1990) 62). Data, ours: eight spokes of 1 m on a hub of 1 kg and 0.2 kg m², a slope of 6 degrees. A foot
//! does not slide because it lands in a notch, whose two frictionless sides push within 45 degrees of the slope's normal; it lands without a bounce
//! while the foot behind it lifts off. With half an angle between spokes α, the slope γ, the radius of gyration k: angular momentum about the
//! foot that lands gives ω⁺ = η ω⁻, η = (k² + l² cos 2α)/(k² + l²), and the way down the rest of the map from landing to landing,
//!
//! ```text
//! ω²(n + 1) = η² (ω²(n) + 4 g l sin α sin γ/(k² + l²))
//! ```
//! Expected: this map, and 1.320600545 rad/s behind a landing in the end.

linkwright::mechanism! {
    /// Eight spokes on a hub, which walk down a slope from notch to notch.
    pub planar RimlessWheel {
        param slope [deg] = 6;
        const spokes = 8;
        const spoke [m] = 1;
        const pace [m] = 2*spoke*sin(pi/spokes);
        gravity = (9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
        const skew [m] = spoke/sqrt(2);
        // Its feet are named for the picture alone.
        #[allow(unused)]
        body hub {
            mass [kg] = 1; inertia [kg*m^2] = 0.2;
            point a = (0 [m], -spoke); point b = (skew, -skew); point c = (spoke, 0 [m]); point d = (skew, skew);
            point e = (0 [m], spoke); point f = (-skew, skew); point g = (-spoke, 0 [m]); point h = (-skew, -skew);
        }
        repeat i in 0..spokes {
            signal turned[i] [rad] = hub.angle + i*2*pi/spokes * 1 [rad];
            signal high[i] [m] = hub.center.y - spoke*cos(turned[i]);
            // From the nearest notch, whose sides rise by 45 degrees.
            signal off[i] [m] = wrap(hub.center.x + spoke*sin(turned[i]) + pace/2, pace) - pace/2;
            contact front[i]: gap((high[i] - off[i])/sqrt(2)) = rigid(restitution = 0);
            contact rear[i]: gap((high[i] + off[i])/sqrt(2)) = rigid(restitution = 0);
        }
        start { hub.center.x [m] = 0; hub.center.y = spoke; hub.angle [rad] = 0; hub.rate [rad/s] = -1.2; hub.center.velocity.x = 1.2 [1/s]*spoke; }
        expect { degrees_of_freedom = 3; }
        output rate [rad/s] = hub.rate;
        output walked [m] = hub.center.x;
        output height [m] = hub.center.y;
        output pressed [N] = front[0].force + rear[0].force;
    }
}
