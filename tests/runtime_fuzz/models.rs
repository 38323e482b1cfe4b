//! What is tested: small mechanisms of the plane and of space, with loops and without, drivers, counted angles, parameters, inputs,
//! massless bodies, change points.

#[path = "winch.rs"]
mod winch;

use crate::random::Random;
use linkwright::{Fields, StateOf, Tangent};
pub use winch::Winch;

/// A mechanism whose parameters may be anything that it accepts.
pub trait Subject: Tangent<f64> + Sized {
    /// The standard mechanism, or one with other parameters.
    fn any(random: &mut Random) -> Self;
    /// All numbers of motions, reactions and inverse dynamics.
    fn derived(&self, time: f64, state: &StateOf<Self>, u: &Self::Inputs, a: &Self::V, lambda: &Self::Lambda);
}

macro_rules! subjects {
    ($($name:path),* $(,)?) => { $(
        impl Subject for $name {
            fn any(random: &mut Random) -> Self {
                let standard = Self::default();
                if random.once_in(2) {
                    return standard;
                }
                let mut values = Fields::<f64>::to_array(standard.parameters());
                for value in &mut values {
                    *value = random.near(*value);
                }
                Self::prepare(Fields::from_array(values)).unwrap_or(standard)
            }
            fn derived(
                &self,
                time: f64,
                state: &StateOf<Self>,
                u: &Self::Inputs,
                a: &Self::V,
                lambda: &Self::Lambda,
            ) {
                std::hint::black_box(self.motions(time, &state.q, &state.v, a));
                std::hint::black_box(self.reactions(time, state, u, a, lambda));
                std::hint::black_box(self.inverse_dynamics(time, state, u, a));
                std::hint::black_box(self.powers(time, state, u));
            }
        }
    )* };
}

subjects!(Swing<f64>, Winch<f64>, Crank<f64>, Rods<f64>, Top<f64>, Folding<f64>,);

linkwright::mechanism! {
    /// A tree: two rods, a spring, an input.
    pub planar Swing {
        param stiffness [N*m/rad] = 6;
        param length [m] = 0.9 in 0.01..100;
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = length; }
        rod lower { mass [kg] = 0.8; length [m] = 0.5; }
        joint a: revolute(ground(0, 0) [m], upper.start);
        joint b: revolute(upper.end, lower.start);
        torsion_spring coil: torsion_spring(a, stiffness = stiffness, angle = 40 [deg], damping = 0.2 [N*m*s/rad]);
        torque motor: torque(b) = drive;
        start { a.angle [deg] = 70; a.rate [rad/s] = 1; b.angle [deg] = 10; }
        options { emit = (tangent); }
        output reach [m] = lower.end.x;
    }
}

linkwright::mechanism! {
    /// A loop of the plane with two inputs.
    pub planar Crank {
        param eccentric [m] = 0.04;
        input torque [N*m];
        input gas [N];
        body crank  { mass [kg] = 1.2; inertia [kg*m^2] = 2.5e-3; point pin [m] = (eccentric, 0); }
        body rod    { mass [kg] = 0.55; inertia [kg*m^2] = 1.6e-3; center [mm] = (40, 0); point eye [m] = (0.14, 0); }
        body piston { mass [kg] = 0.4; inertia [kg*m^2] = 2e-4; }
        joint main:   revolute(ground(0, 0) [m], crank.origin);
        joint big:    revolute(crank.pin, rod.origin);
        joint wrist:  revolute(rod.eye, piston.center);
        joint bore:   prismatic(ground(0, 0) [m], piston.center, axis = (1, 0));
        force drive: torque(main) = torque;
        force load:  force(piston.center, direction = (-1, 0)) = gas;
        start  { main.angle [deg] = 30; main.rate [rad/s] = 20; bore.travel [mm] ~ 170; }
        options { emit = (tangent, penalty, projection, null_space); }
        output angle [rad] = main.angle;
        output stroke [m] = bore.travel;
    }
}

linkwright::mechanism! {
    /// A loop of space with a massless rod.
    pub spatial Rods {
        gravity [m/s^2] = (0, 0, -9.81);
        body crank  { mass [kg] = 0.12; inertia [kg*m^2] = (1e-4, 1e-4, 1e-5); point pin [m] = (0, 0, 0.08); }
        body slider { mass [kg] = 2; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); }
        joint bearing: revolute(ground(0, 0.1, 0.12) [m], crank.origin, axis = (1, 0, 0));
        joint rod:     distance(crank.pin, slider.center, length = 0.3 [m]);
        joint rail:    prismatic(ground(0, 0, 0) [m], slider.center, axis = (1, 0, 0));
        start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 6; rail.travel [m] ~ 0.2; }
        options { emit = (tangent); }
        output stroke [m] = rail.travel;
    }
}

linkwright::mechanism! {
    /// A tree of space that turns by quaternions.
    pub spatial Top {
        gravity [m/s^2] = (0, 0, -9.81);
        body top { mass [kg] = 1; inertia [kg*m^2] = (2e-3, 2e-3, 1e-3); center [m] = (0, 0, 0.1); }
        joint tip: spherical(ground(0, 0, 0) [m], top.origin);
        options { emit = (tangent); }
        output height [m] = top.center.z;
    }
}

linkwright::mechanism! {
    /// A four-bar with a change point, 4 + 1 = 2 + 3.
    pub planar Folding {
        param ground_length [m] = 4;
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 2; length [m] = 2; }
        rod rocker  { mass [kg] = 3; length [m] = 3; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(ground_length, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 4;
                rocker_pin.angle [deg] ~ 145; coupler.angle [deg] ~ 20; }
        options { emit = (tangent); coordinates = absolute; }
        output crank_angle [rad] = crank_pin.angle;
    }
}
