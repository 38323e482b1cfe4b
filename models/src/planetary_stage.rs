//! The torsional vibrations of a planetary stage whose mesh stiffness swings with the teeth: 12/30/72, one planet, soft shafts.
//!
//! Source: the lecture's planetary stage, whose tooth is a cantilever of constant section, with its numbers of teeth and its material (module
//! 1 mm, face 5 mm, 210 GPa, 20 degrees); discs of steel of the pitch radii and the shafts (2000 and 20 000 N m/rad) are ours. Five
//! coordinates: planet, carrier, sun, input and output. Expected: contact ratios 1.40530272 and 1.95638030; mean stiffnesses 1.89079e8 and
//! 2.15548e8 N/m; with the stiffnesses held constant at 2e8 and 2.5e8 N/m natural frequencies of 0, 2148.43215, 8954.85834,
//! 22936.58329 and 54742.46747 Hz. The sun is undercut, and its path of contact ends at the base tangent point: that is known.

linkwright::mechanism! {
    /// A planetary stage with teeth of constant section and eight harmonics.
    pub planar PlanetaryStage {
        const AXES [mm] = 21;
        input torque [N*m];
        #[allow(teeth)]
        body sun { mass [kg] = 1; inertia [kg*m^2] = 7.990326761e-8; toothing rim: external(teeth = 12, module [mm] = 1, face_width [mm] = 5); }
        body planet { mass [kg] = 0.02774419011; inertia [kg*m^2] = 3.121221387e-6; toothing rim: external(teeth = 30, module [mm] = 1, face_width [mm] = 5); }
        body ring { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: internal(teeth = 72, module [mm] = 1, face_width [mm] = 5); }
        body carrier { mass [kg] = 1; inertia [kg*m^2] = 1e-5; point pin [m] = (AXES, 0); }
        body driver { mass [kg] = 1; inertia [kg*m^2] = 1e-5; }
        body driven { mass [kg] = 1; inertia [kg*m^2] = 1e-4; }
        joint held:  fixed(ground(0, 0), ring.center);
        joint main:  revolute(ground(0, 0), carrier.center);
        joint axle:  revolute(ground(0, 0), sun.center);
        joint bolt:  revolute(carrier.pin, planet.center);
        joint front: revolute(ground(0, 0), driver.center);
        joint back:  revolute(ground(0, 0), driven.center);
        #[allow(teeth)]
        mesh inner: mesh(sun.rim, planet.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8));
        mesh outer: mesh(planet.rim, ring.rim, stiffness = involute(young [GPa] = 210, tooth = section, harmonics = 8), sense = -1);
        signal wind [rad] = driver.angle - sun.angle;
        signal lag [rad] = carrier.angle - driven.angle;
        force input_shaft: along(wind) = -2000 [N*m/rad]*wind;
        force output_shaft: along(lag) = -20000 [N*m/rad]*lag;
        torque motor: torque(front) = torque;
        start { sun.angle [rad] = 0; }
        expect { degrees_of_freedom = 5; }
        output inner_stiffness [N/m] = inner.stiffness;
        output outer_stiffness [N/m] = outer.stiffness;
        output inner_phase [1] = inner.phase;
        output outer_phase [1] = outer.phase;
        output inner_pairs [1] = inner.pairs;
        output outer_force [N] = outer.force;
        output inner_deflection [m] = inner.deflection;
    }
}

linkwright::mechanism! {
    /// The same stage at one position of its teeth: both stiffnesses are numbers.
    pub planar PlanetaryStageHeld {
        const AXES [mm] = 21;
        param inner_stiffness [N/m] = 2e8;
        param outer_stiffness [N/m] = 2.5e8;
        #[allow(teeth)]
        body sun { mass [kg] = 1; inertia [kg*m^2] = 7.990326761e-8; toothing rim: external(teeth = 12, module [mm] = 1); }
        body planet { mass [kg] = 0.02774419011; inertia [kg*m^2] = 3.121221387e-6; toothing rim: external(teeth = 30, module [mm] = 1); }
        body ring { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: internal(teeth = 72, module [mm] = 1); }
        body carrier { mass [kg] = 1; inertia [kg*m^2] = 1e-5; point pin [m] = (AXES, 0); }
        body driver { mass [kg] = 1; inertia [kg*m^2] = 1e-5; }
        body driven { mass [kg] = 1; inertia [kg*m^2] = 1e-4; }
        joint held:  fixed(ground(0, 0), ring.center);
        joint main:  revolute(ground(0, 0), carrier.center);
        joint axle:  revolute(ground(0, 0), sun.center);
        joint bolt:  revolute(carrier.pin, planet.center);
        joint front: revolute(ground(0, 0), driver.center);
        joint back:  revolute(ground(0, 0), driven.center);
        #[allow(teeth)]
        mesh inner: mesh(sun.rim, planet.rim, stiffness = inner_stiffness);
        mesh outer: mesh(planet.rim, ring.rim, stiffness = outer_stiffness);
        signal wind [rad] = driver.angle - sun.angle;
        signal lag [rad] = carrier.angle - driven.angle;
        force input_shaft: along(wind) = -2000 [N*m/rad]*wind;
        force output_shaft: along(lag) = -20000 [N*m/rad]*lag;
        start { sun.angle [rad] = 0; }
        expect { degrees_of_freedom = 5; }
        output inner_deflection [m] = inner.deflection;
    }
}
