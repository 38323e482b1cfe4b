//! A wheel is braked until its tyre slips: relaxation length and magic formula.
//!
//! Data: 250 kg on one wheel of 1.2 kg m² and 0.3 m; magic formula B = 10, C = 1.65, D = 1, E = 0.97, relaxation length σ = 0.3 m; 20 m/s; a
//! brake torque that grows to 600 N m within 0.3 s; g = 9.81 m/s². Equations: Pacejka, *Tire and Vehicle Dynamics*, 2012, 4.3 and 7.2:
//!
//! ```text
//! σ κ̇ = ω R − v − |v| κ,    F = D F_z sin(C atan(x)),  x = B κ − E (B κ − atan(B κ))
//! ```
//! Expected: speed, spin, slip and force after 0.3 s and 1 s, of a separate integration (Dormand and Prince of order 8, 3e-14).

linkwright::mechanism! {
    /// A braked wheel under a quarter of a car, rolling along +x; its slip is a state.
    pub planar BrakedWheel {
        const RADIUS [m] = 0.3;
        const LOAD [N] = 250 [kg]*9.81 [m/s^2];
        param relaxation [m] = 0.3 in 0.01..10;
        param stiffness [1] = 10;
        param shape [1] = 1.65;
        param peak [1] = 1;
        param curvature [1] = 0.97;
        param brake [N*m] = 600;

        /// Practical slip κ, negative while braking.
        state slip [1] = 0, scale = 1e-3;
        rate  slip = (spin*RADIUS - car.center.velocity.x - abs(car.center.velocity.x)*slip)/relaxation;

        // It rolls clockwise.
        signal spin [rad/s] = -axle.rate;
        signal steep [1] = stiffness*slip;
        signal grip [N] = peak*LOAD*sin(shape*atan(steep - curvature*(steep - atan(steep)/1 [rad])));
        signal torque [N*m] = brake*clamp(time/0.3 [s], 0, 1)*sign(spin);

        body car   { mass [kg] = 230; inertia [kg*m^2] = 0; }
        body wheel { mass [kg] = 20; inertia [kg*m^2] = 1.2; }
        joint road: prismatic(ground(0, 0) [m], car.center, axis = (1, 0));
        joint axle: revolute(car.center, wheel.center);

        force  traction: force(wheel.center, direction = (1, 0)) = grip;
        torque braking:  torque(axle) = torque + grip*RADIUS;

        start { road.travel [m] = 0; road.speed [m/s] = 20; axle.angle [rad] = 0; axle.rate [rad/s] = -20/0.3; }
        options { emit = (tangent); }
        output place [m] = road.travel;
        output speed [m/s] = road.speed;
        output spin [rad/s] = spin;
        output slip [1] = slip;
        output force [N] = grip;
    }
}
