//! A wooden woodpecker on a spring, whose sleeve jams on a pole, slides and lets go, so that it pecks its way down.
//!
//! Data of Glocker (Dynamik von Starrkörpersystemen mit Reibung und Stössen, 1995, 9.1; Leine, Glocker, van Campen, Nonlinear dynamics of the
//! woodpecker toy, ASME DETC2001/VIB-21608): masses and inertias of sleeve and bird, the spring between them, radii of pole and sleeve, Newton's
//! restitution 0.5 of the beak and 0 of the sleeve's edges, friction 0.3. They take small angles; here sleeve and bird turn as they do, and the
//! axis of the sleeve stays on that of the pole. One of both edges of the sleeve that meet the pole together stands for both.
//!
//! Expected, ours (`tests/checks/dry.rs`): it repeats itself each 0.130747525 s and comes down by 14.49691 mm meanwhile. For small angles, where the
//! cycle takes 0.145976 s and 19.445 mm, the sleeve has −0.33948 m/s and the bird −7.4621 rad/s where φ_S passes −0.2788; −0.3411 and −7.4583 were
//! published, by time stepping.

linkwright::mechanism! {
    /// A sleeve on a pole and a bird on a spring, with three rigid contacts that rub.
    pub planar Woodpecker {
        gravity [m/s^2] = (0, -9.81);
        const pole [mm] = 2.5;
        const bore [mm] = 3.1;
        const half [mm] = 5.8;
        param grip [1] = 0.3;
        body sleeve {
            mass [kg] = 0.3e-3; inertia [kg*m^2] = 5e-9;
            point low = (bore, -half); point high = (bore, half); point spring [mm] = (10, 0);
            surface lower: point(sleeve.low); surface upper: point(sleeve.high);
        }
        body bird {
            mass [kg] = 4.5e-3; inertia [kg*m^2] = 7e-7;
            point spring [mm] = (-15, 0); point tip [mm] = (-20.1, 20);
            surface beak: point(bird.tip);
        }
        surface wood: half_plane(line(ground(pole, 30 [mm]), ground(pole, -60 [mm])));
        joint axis: point_on_line(line(ground(0, -60) [mm], ground(0, 30) [mm]), sleeve.center);
        joint leg: revolute(sleeve.spring, bird.spring);
        torsion_spring steel: torsion_spring(leg, stiffness [N*m/rad] = 5.6e-3);
        contact pecks: between(bird.beak, wood) = rigid(restitution = 0.5);
        contact below: between(sleeve.lower, wood) = rigid(restitution = 0);
        contact above: between(sleeve.upper, wood) = rigid(restitution = 0);
        friction stops: on(pecks) = dry(static = grip);
        friction jams: on(below) = dry(static = grip);
        friction catches: on(above) = dry(static = grip);
        start {
            sleeve.center.y [m] = 0; sleeve.angle [rad] = -0.1; bird.angle [rad] = -0.2788;
            sleeve.center.velocity.y [m/s] = -0.3411; sleeve.rate [rad/s] = 0; bird.rate [rad/s] = -7.4583;
        }
        expect { degrees_of_freedom = 3; }
        output height [m] = sleeve.center.y;
        output rate [m/s] = sleeve.center.velocity.y;
        output sleeve_angle [rad] = sleeve.angle;
        output bird_angle [rad] = bird.angle;
        output bird_rate [rad/s] = bird.rate;
        output jammed [N] = jams.force;
    }
}
