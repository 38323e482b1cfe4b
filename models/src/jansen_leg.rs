//! Jansen leg, the leg of the Strandbeest.
//!
//! Source: Theo Jansen, *The Great Pretender* (2007), the "holy numbers" a 38, b 41.5, c 39.3, d 40.1, e 55.8, f 39.4,
//! g 36.7, h 65.7, i 49, j 50, k 61.9, l 7.8, m 15, taken here in centimetres. The published linkage has no masses: all
//! rods are uniform, 0.2 kg/m, the two triangles (b, d, e and g, h, i) rigid frames of three such rods. Expected: foot
//! and knee at a crank angle of 0° at (−43.160110524105, −91.756932926123) and (−59.231514961415, −28.052930230748) cm.

linkwright::mechanism! {
    /// Jansen leg: eleven rods and two triangles, one crank.
    ///
    /// The crank is driven at a constant speed; the driver's effort is the torque it needs. At a crank angle of 0° the
    /// foot stands at (−0.43160110524105, −0.91756932926123) m.
    pub planar JansenLeg {
        const a [cm] = 38;
        const b [cm] = 41.5;
        const c [cm] = 39.3;
        const d [cm] = 40.1;
        const e [cm] = 55.8;
        const f [cm] = 39.4;
        const g [cm] = 36.7;
        const h [cm] = 65.7;
        const i [cm] = 49;
        const j [cm] = 50;
        const k [cm] = 61.9;
        const l [cm] = 7.8;
        const m [cm] = 15;
        const DENSITY [kg/m] = 0.2;
        // Corner of the upper triangle opposite to b, and the centre of its three rods.
        const TX [m] = (b^2 + d^2 - e^2)/(2*b);
        const TY [m] = sqrt(d^2 - TX^2);
        const TCX [m] = (b*b + d*TX + e*(b + TX))/(2*(b + d + e));
        const TCY [m] = (d + e)*TY/(2*(b + d + e));
        // The same of the lower one, opposite to g.
        const FX [m] = (g^2 + i^2 - h^2)/(2*g);
        const FY [m] = sqrt(i^2 - FX^2);
        const FCX [m] = (g*g + i*FX + h*(g + FX))/(2*(g + i + h));
        const FCY [m] = (i + h)*FY/(2*(g + i + h));
        /// Speed of the crank.
        param speed [rad/s] = 3;

        gravity [m/s^2] = (0, -9.81);
        rod crank      { mass [kg] = DENSITY*m; length [m] = m; }
        rod upper_link { mass [kg] = DENSITY*j; length [m] = j; }
        rod lower_link { mass [kg] = DENSITY*k; length [m] = k; }
        rod strut      { mass [kg] = DENSITY*c; length [m] = c; }
        rod shin       { mass [kg] = DENSITY*f; length [m] = f; }
        body thigh {
            mass [kg] = DENSITY*(b + d + e);
            center [m] = (TCX, TCY);
            inertia [kg*m^2] = DENSITY*(b*(b^2/12 + (b/2 - TCX)^2 + TCY^2)
                + d*(d^2/12 + (TX/2 - TCX)^2 + (TY/2 - TCY)^2)
                + e*(e^2/12 + ((b + TX)/2 - TCX)^2 + (TY/2 - TCY)^2));
            point upper [m] = (b, 0);
            point rear [m] = (TX, TY);
        }
        body foot {
            mass [kg] = DENSITY*(g + i + h);
            center [m] = (FCX, FCY);
            inertia [kg*m^2] = DENSITY*(g*(g^2/12 + (g/2 - FCX)^2 + FCY^2)
                + i*(i^2/12 + (FX/2 - FCX)^2 + (FY/2 - FCY)^2)
                + h*(h^2/12 + ((g + FX)/2 - FCX)^2 + (FY/2 - FCY)^2));
            point knee [m] = (g, 0);
            point toe [m] = (FX, FY);
        }

        joint crank_pin: revolute(ground(0, 0) [m], crank.start);
        joint hip:       revolute(ground(-a, -l), thigh.origin);
        joint strut_pin: revolute(ground(-a, -l), strut.start);
        joint upper_eye: revolute(crank.end, upper_link.start);
        joint lower_eye: revolute(crank.end, lower_link.start);
        joint top:       revolute(upper_link.end, thigh.upper);
        joint bottom:    revolute(lower_link.end, strut.end);
        joint ankle:     revolute(strut.end, foot.origin);
        joint rear:      revolute(thigh.rear, shin.start);
        joint knee:      revolute(shin.end, foot.knee);

        drive walk: crank_pin.angle = speed*time;

        start  { thigh.angle [deg] ~ 70; strut.angle [deg] ~ -74; upper_link.angle [deg] ~ 141;
                 lower_link.angle [deg] ~ -133; shin.angle [deg] ~ -67; foot.angle [deg] ~ 152; }
        expect { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; }
        output toe_x [m] = foot.toe.x;
        output toe_y [m] = foot.toe.y;
        output knee_x [m] = foot.knee.x;
        output knee_y [m] = foot.knee.y;
        /// Torque that the crank needs.
        output torque [N*m] = walk.effort;
    }
}
