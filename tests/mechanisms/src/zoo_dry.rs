//! Dry friction in joints: where something turns, slides along a rail and along a line, in trees and closed loops, by reactions and beside them.

linkwright::mechanism! {
    /// A crank, a rod and a slider that brakes press on, and a bead on a wire; one pin has friction of another law.
    pub planar Braking {
        gravity [m/s^2] = (0, -9.81);
        param hold = 0.4 in 0..1;
        input pedal [N*m];
        rod crank { mass [kg] = 0.8; length [m] = 0.1; }
        rod rod_ { mass [kg] = 1.2; length [m] = 0.35; }
        body slider { mass [kg] = 0.6; inertia [kg*m^2] = 2e-3; point edge [m] = (0.02, 0.01); }
        particle bead { mass [kg] = 0.2; }
        joint main: revolute(ground(0, 0) [m], crank.start);
        joint big: revolute(rod_.start, crank.end);
        joint wrist: revolute(rod_.end, slider.origin);
        joint rail: prismatic(slider.edge, ground(0.2, 0.03) [m], axis = (1, 0.1), angle [deg] = 8);
        joint wire: point_on_line(line(ground(-1, 0.5) [m], ground(1, 0.8) [m]), bead.center);
        friction drum: on(main) = dry(static = hold, kinetic = 0.3, radius [mm] = 12, torque = 0.05 [N*m] + pedal*pedal/(1 [N*m]), breakaway [N*m] = 0.5);
        friction at_big: on(big) = coulomb(coefficient = 0.2, radius [mm] = 9, speed [rad/s] = 0.1);
        friction shoe: on(rail) = dry(static = 0.5, kinetic = 0.35, length [m] = 0.4, preload = 2 [N] + 10 [N/m]*abs(wrist.angle)*0.1 [m/rad]);
        friction slips: on(wire) = dry(static = 0.2);
        state taken [J] = 0;
        rate taken = power(drum) + power(shoe) + power(slips);
        start { main.angle [deg] = 50; main.rate [rad/s] = 15; slider.angle [deg] ~ 0; rod_.angle [deg] ~ -15; bead.center.x [m] = 0; wire.speed [m/s] = 1; }
        options { friction_passes = 4; emit = (penalty, projection, null_space); }
        output pressed [N] = shoe.normal;
        output torque [N*m] = drum.torque;
        output force [N] = shoe.force + slips.force;
        output turning [rad/s] = drum.rate;
        output sliding [m/s] = shoe.sliding;
        output work [J] = taken;
        output lost [W] = -power(drum) - power(shoe) - power(slips);
    }
}

linkwright::mechanism! {
    /// An arm in space on a pin that is not upright, and a block along it.
    pub spatial BrakingInSpace {
        gravity [m/s^2] = (0, 0, -9.81);
        param grip = 0.6 in 0..2;
        body arm { mass [kg] = 3; inertia [kg*m^2] = (0.02, 0.1, 0.1); point a [m] = (-0.2, 0, 0); }
        body block { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.01); }
        joint pin: revolute(ground(0, 0, 0) [m], arm.a, axis = (0, 1, 0.5));
        joint rail: prismatic(arm.a, block.center, axis = (1, 0, 0));
        friction stays: on(pin) = dry(static = grip, kinetic = 0.4, radius [m] = 0.05, length [m] = 0.1, shoulder [m] = 0.07);
        friction shoe: on(rail) = dry(static = 0.9, kinetic = 0.6, length [m] = 0.3, preload [N] = 5, force [N] = 1);
        start { pin.angle [deg] = 0; pin.rate [rad/s] = 5; rail.travel [m] = 0.1; rail.speed [m/s] = 0; }
        options { emit = (penalty, projection, null_space); }
        output torque [N*m] = stays.torque;
        output pressed [N] = stays.normal + shoe.normal;
        output lost [W] = -power(stays) - power(shoe);
    }
}

linkwright::mechanism! {
    /// A rod that turns and slides in its sleeve, a bob in a ball on it, and a flag on two pins that cross.
    pub spatial BrakingAllWays {
        gravity [m/s^2] = (0, 1, -9.81);
        param grip = 0.5 in 0..2;
        input wind [N*m];
        body rod_ { mass [kg] = 2; inertia [kg*m^2] = (0.01, 0.05, 0.05); point eye [m] = (0.3, 0.02, 0); }
        body bob { mass [kg] = 1; inertia [kg*m^2] = (0.02, 0.03, 0.01); point eye [m] = (0, 0, 0.2); }
        body flag { mass [kg] = 0.5; inertia [kg*m^2] = (0.01, 0.004, 0.012); point foot [m] = (0.02, 0, -0.25); }
        joint sleeve: cylindrical(ground(0, 0, 0) [m], rod_.center, axis = (1, 0, 0.1));
        joint ball: spherical(rod_.eye, bob.eye);
        joint cross: universal(ground(1, 0, 0) [m], flag.foot, axis = (1, 0, 0), second_axis = (0, 1, 0));
        friction bush: on(sleeve) = dry(static = grip, kinetic = 0.3, radius [m] = 0.03, length [m] = 0.2, force [N] = 0.5);
        friction socket: on(ball) = dry(static = 0.4, kinetic = 0.3, radius [m] = 0.02, torque = 0.01 [N*m] + wind*wind/(1 [N*m]), breakaway [N*m] = 0.05);
        friction pins: on(cross) = dry(static = 0.5, kinetic = 0.4, radius [m] = 0.015, torque [N*m] = 0.02);
        start {
            sleeve.angle [deg] = 20; sleeve.rate [rad/s] = 8; sleeve.travel [m] = 0.1; sleeve.speed [m/s] = 0.5;
            bob.rate.x [rad/s] = 1; bob.rate.y [rad/s] = -4; bob.rate.z [rad/s] = 2;
            cross.angle_1 [deg] = 30; cross.rate_1 [rad/s] = 3; cross.angle_2 [deg] = -10; cross.rate_2 [rad/s] = 0;
        }
        options { emit = (penalty, projection, null_space); }
        output pressed [N] = bush.normal + socket.normal + pins.normal;
        output lost [W] = -power(bush) - power(socket) - power(pins);
    }
}
