//! Mechanisms that emit their derivatives: loops and trees, of the plane and of space, with springs, couplings, drivers, balls,
//! parameters and inputs in all of them, rows that repeat others, a body without mass.

#[path = "../../runtime_fuzz/winch.rs"]
mod winch;

use crate::registry::model;
pub use winch::Winch;

linkwright::mechanism! {
    /// A four-bar that a torsion spring holds, with more inputs than it needs.
    pub planar Gripper {
        param stiffness [N*m/rad] = 6;
        param length [m] = 0.9;
        param weight [kg] = 1.2 in 0.1..10;
        input drive [N*m];
        input pull [N];
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = weight; length [m] = 0.4; }
        rod coupler { mass [kg] = 0.8; length [m] = length; }
        rod rocker  { mass [kg] = 0.6; length [m] = 0.7; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.end);
        joint d: revolute(ground(0.8, 0) [m], rocker.start);
        torsion_spring coil: torsion_spring(a, stiffness = stiffness, angle = 40 [deg], damping = 0.2 [N*m*s/rad]);
        torque motor: torque(a) = drive;
        force rope: force(coupler.center, direction = (1, 2)) = pull;
        start { a.angle [deg] = 70; a.rate [rad/s] = 1; d.angle [deg] ~ 80; coupler.angle [rad] ~ 0.3; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 1; }
        output reach [m] = coupler.center.x;
        output swing [rad] = d.angle;
        output swinging [rad/s] = d.rate;
        output stored [J] = potential_energy;
    }
}

linkwright::mechanism! {
    /// A hull on three springs with a pole on a ball: nothing of it has coordinates for its orientation.
    pub spatial Buoy {
        param stiffness [N/m] = 40;
        param weight [kg] = 2;
        param offset [m] = 0.02;
        input push [N];
        input twist [N*m];
        gravity [m/s^2] = (0, 0, -9.81);
        body hull { mass [kg] = weight; inertia [kg*m^2] = (0.03, 0.04, 0.05); products [kg*m^2] = (0.002, 0, -0.001);
                    center [m] = (0.01, offset, 0);
                    point foot [m] = (0.05, 0.02, 0.1); point bow [m] = (0.2, 0, -0.1);
                    point port [m] = (-0.1, 0.15, -0.1); point stern [m] = (-0.2, -0.1, -0.1); }
        rod pole  { mass [kg] = 0.4; length [m] = 0.3; radius [m] = 0.02; #[allow(outside)] point arm [m] = (0.1, 0.15, 0.1); }
        joint ball: spherical(hull.foot, pole.start);
        spring fore:  spring(ground(0.5, 0, 0.6) [m], hull.bow, stiffness = stiffness, length = 0.3 [m], damping = 0.5 [N*s/m]);
        spring left:  spring(ground(-0.4, 0.5, 0.6) [m], hull.port, stiffness = stiffness, length = 0.3 [m], damping = 0.5 [N*s/m]);
        spring right: spring(ground(-0.4, -0.5, 0.6) [m], hull.stern, stiffness = 1.2 * stiffness, length = 0.3 [m]);
        spring stay:  spring(ground(0.1, 0.3, 1.2) [m], pole.arm, stiffness = 25 [N/m], length = 0.2 [m], damping = 0.2 [N*s/m]);
        force draw:   force(hull.port, direction = (1, 0, 1)) = push;
        torque turn:  torque(pole) = (0, -0.02 [N*m*s/rad] * pole.rate.y, 0.03 * twist - 0.01 [N*m*s/rad] * pole.rate.x);
        start { hull.orientation = (0.98, 0.1, -0.1, 0.05); hull.center.z [m] = -0.1; hull.center.x [m] = 0; hull.center.y [m] = 0;
                pole.orientation = (0.9, -0.1, -0.4, 0.1); hull.rate.x [rad/s] = 0.4; hull.rate.y [rad/s] = -0.7; hull.rate.z [rad/s] = 0.9;
                pole.rate.y [rad/s] = 1.2; pole.rate.x [rad/s] = 0.5; pole.rate.z [rad/s] = 2; hull.center.velocity.x [m/s] = 0.3; }
        options { emit = (tangent); coordinates = tree; }
        expect { degrees_of_freedom = 9; }
        output height [m] = pole.end.z;
        output spin [rad/s] = pole.rate.x;
        output gap [m] = distance(hull.bow, pole.end);
    }
}

linkwright::mechanism! {
    /// Two bars on balls as free bodies: rows besides orientations without coordinates.
    pub spatial Flail {
        param length [m] = 0.5;
        input twist [N*m];
        gravity [m/s^2] = (0, 0.2, -9.81);
        rod handle { mass [kg] = 0.7; length [m] = length; radius [m] = 0.03; #[allow(outside)] point side [m] = (0.1, 0.15, 0.05); }
        body head  { mass [kg] = 1.1; inertia [kg*m^2] = (0.006, 0.005, 0.004); products [kg*m^2] = (0.001, 0, 0.0005);
                     center [m] = (0.2, 0.01, -0.03); point tip [m] = (0.3, 0.05, 0.02); }
        joint hold: spherical(ground(0.1, 0, 0.2) [m], handle.start);
        joint link: spherical(handle.end, head.origin);
        spring rope: spring(ground(0.2, 0.5, 0.9) [m], head.tip, stiffness = 30 [N/m], length = 0.3 [m], damping = 0.4 [N*s/m]);
        spring band: spring(ground(0.5, -0.3, 0.8) [m], handle.side, stiffness = 25 [N/m], length = 0.3 [m]);
        torque turn: torque(handle) = (0.05 * twist, -0.02 [N*m*s/rad] * handle.rate.x, 0);
        start { handle.orientation = (0.9, 0.1, -0.3, 0.2); head.orientation ~ (0.8, 0.3, 0.4, -0.1); head.rate.x [rad/s] = 2;
                handle.rate.y [rad/s] = 1; head.rate.z [rad/s] = -1; }
        options { emit = (tangent); coordinates = absolute; }
        expect { degrees_of_freedom = 6; }
        output height [m] = head.tip.z;
    }
}

linkwright::mechanism! {
    /// A crank that turns a rocker through a ball-ended rod, a screw behind it: a loop in space with a counted angle.
    pub spatial Rocker {
        param pitch [m] = 0.2;
        param length [m] = 0.6;
        input drive [N*m];
        input push [N];
        gravity [m/s^2] = (0.3, 0, -9.81);
        body crank  { mass [kg] = 0.8; inertia [kg*m^2] = (0.01, 0.012, 0.008); products [kg*m^2] = (0.001, 0, 0.0005); point pin [m] = (0.2, 0.05, 0); }
        body rocker { mass [kg] = 1.1; inertia [kg*m^2] = (0.02, 0.03, 0.02); center [m] = (0.02, 0, 0.1); point pin [m] = (0, 0.05, 0.35);
                      point nut [m] = (0.1, 0, 0); }
        body stem   { mass [kg] = 0.3; inertia [kg*m^2] = (0.001, 0.001, 0.0005); }
        joint shaft: revolute(ground(0, 0, 0) [m], crank.center, axis = (0.1, 0, 1));
        joint hinge: revolute(ground(0.6, 0.3, -0.2) [m], rocker.origin, axis = (1, 0.2, 0));
        joint strut: distance(crank.pin, rocker.pin, length = length);
        joint lead:  screw(rocker.nut, stem.center, axis = (0, 0.3, 1), pitch = pitch);
        torsion_spring coil: torsion_spring(lead, stiffness = 0.8 [N*m/rad], angle = 3 [rad], damping = 0.02 [N*m*s/rad]);
        torsion_spring hold: torsion_spring(hinge, stiffness = 9 [N*m/rad], damping = 0.1 [N*m*s/rad]);
        torque motor: torque(shaft) = drive;
        force blow: force(stem.center) = (push, 0, -0.1 * push);
        start { shaft.angle [rad] = 0.3; shaft.rate [rad/s] = 1; hinge.angle [rad] ~ -0.75; lead.angle [rad] = 7; lead.rate [rad/s] = -2; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 2; }
        output swing [rad] = hinge.angle;
        output out [m] = lead.travel;
        output lift [m] = stem.center.z;
    }
}

linkwright::mechanism! {
    /// A table on three cranks, of which the third has no mass and repeats what two hold.
    pub planar Swing {
        param weight [kg] = 2;
        input left [N*m];
        input right [N*m];
        gravity [m/s^2] = (0.5, -9.81);
        rod one { mass [kg] = 1; length [m] = 1; }
        rod two { mass [kg] = 1; length [m] = 1; }
        rod three { mass [kg] = 0; inertia [kg*m^2] = 0; length [m] = 1; }
        rod table { mass [kg] = weight; length [m] = 2; }
        joint a: revolute(ground(0, 0) [m], one.start);
        joint b: revolute(ground(1, 0) [m], two.start);
        joint c: revolute(ground(2, 0) [m], three.start);
        joint d: revolute(one.end, table.start);
        joint e: revolute(two.end, table.center);
        joint f: revolute(three.end, table.end);
        torsion_spring coil: torsion_spring(a, stiffness = 150 [N*m/rad], angle = 1 [rad], damping = 0.3 [N*m*s/rad]);
        torque first: torque(a) = left;
        torque second: torque(b) = right;
        start { a.angle [deg] = 60; a.rate [rad/s] = 0.7; b.angle [deg] ~ 60; c.angle [deg] ~ 60; table.angle [rad] ~ 0; }
        options { redundant = keep; emit = (tangent, penalty); coordinates = absolute; }
        expect { degrees_of_freedom = 1; }
        output angle [rad] = a.angle;
    }
}

linkwright::mechanism! {
    /// A rod on a hinge with a torsion spring.
    pub planar Spring {
        param stiffness [N*m/rad] = 5;
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod bar { mass [kg] = 2; length [m] = 0.6; }
        joint pin: revolute(ground(0, 0) [m], bar.start);
        torsion_spring coil: torsion_spring(pin, stiffness = stiffness, angle = 0.5 [rad]);
        torque motor: torque(pin) = drive;
        start { pin.angle [rad] = 0.5; }
        options { emit = (tangent); }
        output angle [rad] = pin.angle;
    }
}

linkwright::mechanism! {
    /// The same without the spring.
    pub planar Bar {
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod bar { mass [kg] = 2; length [m] = 0.6; }
        joint pin: revolute(ground(0, 0) [m], bar.start);
        torque motor: torque(pin) = drive;
        start { pin.angle [rad] = 0.5; }
        options { emit = (tangent); }
    }
}

/// A test of the function `check::<M>` for each of these mechanisms, in a module of that function's name.
#[macro_export]
macro_rules! for_each_with_tangent {
    ($check:ident) => {
        mod $check {
            $crate::zoo_tangent::for_each_with_tangent! { @ $check
                gripper: zoo_tangent::Gripper, winch: zoo_tangent::Winch, buoy: zoo_tangent::Buoy, flail: zoo_tangent::Flail,
                rocker: zoo_tangent::Rocker, swing: zoo_tangent::Swing, spring: zoo_tangent::Spring, servo: zoo_laws::Servo
            }
        }
    };
    (@ $check:ident $($name:ident: $file:ident :: $model:ident),*) => { $(
        #[test]
        fn $name() {
            super::$check::<$crate::$file::$model>();
        }
    )* };
}
pub use crate::for_each_with_tangent;

model!(Gripper, Winch, Buoy, Flail, Rocker, Swing, Spring, Bar);
