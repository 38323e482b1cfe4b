//! Mechanisms whose laws are made of signals, their rates, tables, internal states, and forces along expressions; in the plane and in space.

linkwright::mechanism! {
    /// A cart on a spring, a wheel that slips on it, and a pendulum that is steered by its reach.
    pub planar Steered {
        param stiffness [N/m] = 500;
        param offset [mm] = 30;
        input push [N];
        gravity [m/s^2] = (0, -9.81);
        signal doubled [N/m] = 2*stiffness;
        signal pull [N] = -doubled*stretch - 3 [N*s/m]*stretch.rate + push;
        signal stretch [m] = hypot(cart.center.x, 0.3 [m]) - 0.2 [m];
        signal slip [m/s] = cart.center.velocity.x - 0.1 [m]*wheel.rate;
        signal reach [m] = distance(bob.end, ground(0.4, 0.6) [m]);
        signal sway [rad] = swing.angle + 0.3 [rad]*sin(2 [rad/s]*time);
        signal area [m^2] = bob.end.x*(bob.end.y - offset);
        signal height [m] = doubled*0.1 [m]/(500 [N/m]) + 0.02 [m]*sin(4 [rad/s]*time);
        signal weight [kg] = 1 [kg] + stiffness*1 [kg*m/N]/1000;
        body cart { mass = weight; inertia [kg*m^2] = 0.1; }
        disk wheel { mass [kg] = 1; radius [m] = 0.1; }
        rod bob { mass [kg] = 0.7; length [m] = 0.5; }
        body slider { mass [kg] = 0.4; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        joint hub: revolute(cart.center, wheel.center);
        joint swing: revolute(cart.center, bob.start);
        joint post: prismatic(ground(1, 0) [m], slider.center, axis = (0, 1));
        constraint follow: post.travel = height + 0.1*stretch;
        force spring: force(rail) = pull;
        torque brake: torque(hub) = 2 [N*m*s/m]*clamp(slip, -1 [m/s], 1 [m/s]);
        force cable: along(reach) = -20 [N/m]*deadband(reach - 0.3 [m], 0.05 [m]) - 0.4 [N*s/m]*reach.rate;
        force steer: along(sway) = -1.5 [N*m/rad]*sway - 0.2 [N*m*s/rad]*sway.rate;
        force press: along(area) = 3 [N/m]*smoothstep(area, -0.1 [m^2], 0.1 [m^2]);
        start { rail.travel [m] = 0.1; rail.speed [m/s] = 0.4; swing.angle [rad] = -1.2; swing.rate [rad/s] = 1; hub.rate [rad/s] = 3;
                post.travel [m] ~ 0.1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output pulled [N] = pull;
        output reached [m] = reach;
        output closing [m/s] = reach.rate;
        output steered [W] = power(steer) + power(cable);
    }
}

linkwright::mechanism! {
    /// A body in space on two cables whose lengths depend on each other.
    pub spatial Tethered {
        param share [1] = 0.4;
        gravity [m/s^2] = (0, 0, -9.81);
        signal left [m] = distance(plate.left, ground(-1, 0.2, 1) [m]);
        signal right [m] = distance(plate.right, ground(1, -0.1, 1.2) [m]);
        signal pulley [m] = left + share*right;
        box plate { mass [kg] = 2; size [m] = (0.6, 0.4, 0.1); point left [m] = (-0.3, 0, 0); point right [m] = (0.3, 0.1, 0.05); }
        force rope: along(pulley) = -200 [N/m]*max(pulley - 1.5 [m], 0 [m]) - 3 [N*s/m]*pulley.rate;
        force twist: along(plate.left.x*plate.right.y) = 2 [N/m];
        start { plate.center.x [m] = 0.1; plate.center.y [m] = 0; plate.center.z [m] = 0.1; }
        output length [m] = pulley;
        output paid_out [m/s] = pulley.rate;
    }
}

linkwright::mechanism! {
    /// A motor with its current, its voltage behind a filter and an observer, on an arm that a spring holds.
    pub planar Powered {
        param resistance [ohm] = 0.5;
        param inductance [mH] = 2;
        param torque_constant [N*m/A] = 0.08;
        param first [A] = 0.1;
        input voltage [V];
        gravity [m/s^2] = (0, -9.81);
        /// Through the motor.
        state current [A] = first;
        state filtered [V] = 0, scale = 0.01;
        state sensed [deg/s] = 2;
        state work [J] = 0;
        rate current = (filtered - resistance*current - torque_constant*back)/inductance;
        rate filtered = (voltage - filtered)/10 [ms];
        rate sensed = (shoulder.rate - sensed)/0.05 [s];
        rate work = power(drive) + 1e-3*kinetic_energy/1 [s];
        signal back [1/s] = shoulder.rate/1 [rad];
        rod arm { mass [kg] = 1; length [m] = 0.4; }
        rod tip { mass [kg] = 0.5; length [m] = 0.3; }
        joint shoulder: revolute(ground(0, 0) [m], arm.start);
        joint elbow: revolute(arm.end, tip.start);
        torque drive: torque(shoulder) = torque_constant*current;
        torque brake: torque(elbow) = -0.02 [N*m*s/rad]*(elbow.rate + 0.1*sensed);
        spring hold: spring(tip.end, ground(0.5, 0) [m], stiffness [N/m] = 30, length [m] = 0.2);
        start { shoulder.angle [deg] = -80; elbow.angle [deg] = 10; }
        output current [A] = current;
        output work [J] = work;
        output losses [W] = resistance*current^2;
    }
}

linkwright::mechanism! {
    /// A slider-crank in space whose slider rubs by a bristle, driven at a given speed; the effort of the drive goes through a filter.
    pub spatial Bristled {
        param stiffness [N/mm] = 100;
        gravity [m/s^2] = (0, 0, -9.81);
        state bristle [mm] = 0.01, scale = 1e-3;
        state felt [N*m] = 0;
        signal speed [m/s] = slider.center.velocity.x;
        signal rough [N] = 1 [N] + 0.5 [N]*exp(-(speed/0.01 [m/s])^2);
        rate bristle = speed - abs(speed)*stiffness*bristle/rough;
        rate felt = (turn.effort - felt)/0.1 [s];
        rod crank { mass [kg] = 0.1; length [m] = 0.1; radius [mm] = 10; }
        rod link { mass [kg] = 0.2; length [m] = 0.3; radius [mm] = 10; }
        box slider { mass [kg] = 0.4; size [mm] = (60, 40, 40); }
        joint pin: revolute(ground(0, 0, 0) [m], crank.start, axis = (0, 0, 1));
        joint ball: spherical(crank.end, link.start);
        joint wrist: universal(link.end, slider.center, axis = (0, 1, 0), second_axis = (0, 0, 1));
        joint rail: prismatic(ground(0, 0, 0) [m], slider.center, axis = (1, 0, 0));
        drive turn: pin.angle = 4 [rad/s]*time + 0.3 [rad];
        force friction: force(rail) = -(stiffness*bristle + 20 [N*s/m]*speed);
        start { rail.travel [m] ~ 0.39; wrist.angle_1 [rad] ~ 0; }
        output bristle [um] = bristle;
        output felt [N*m] = felt;
    }
}

linkwright::mechanism! {
    /// A slider-crank with a motor, on a table that is shaken; what the shaking takes is felt through a filter, which the motor's
    /// voltage follows. Its derivatives are emitted.
    pub planar Servo {
        param resistance [ohm] = 0.5;
        param constant [N*m/A] = 0.3;
        param start [A] = 0.5;
        input voltage [V];
        gravity [m/s^2] = (0, -9.81);
        state current [A] = 2*start, scale = 0.01;
        state felt [N] = 1 [N*s/m]*0.2 [m/s];
        rate current = (voltage - 0.1 [V/N]*felt - resistance*current - constant*pin.rate)/0.02 [H];
        rate felt = (shake.effort - felt)/0.1 [s] + 0.3 [1/s]*sin(felt/1 [N])*1 [N];
        body table { mass [kg] = 4; inertia [kg*m^2] = 0.1; }
        rod crank { mass [kg] = 0.5; length [m] = 0.2; }
        rod link { mass [kg] = 0.7; length [m] = 0.6; }
        body piston { mass [kg] = 0.4; inertia [kg*m^2] = 0.001; }
        joint rail: prismatic(ground(0, 0) [m], table.center, axis = (1, 0));
        joint pin: revolute(table.center, crank.start);
        joint knuckle: revolute(crank.end, link.start);
        joint wrist: revolute(link.end, piston.center);
        joint guide: prismatic(table.center, piston.center, axis = (1, 0));
        drive shake: rail.travel = 0.1 [m]*sin(3 [rad/s]*time);
        torque motor: torque(pin) = constant*current - 0.2 [N*m/rad]*pin.angle;
        start { pin.angle [rad] = 0.6; guide.travel [m] ~ 0.7; }
        options { emit = (tangent); }
        output current [A] = current;
        output load [N] = shake.effort + 0.5*felt;
        output heat [W] = resistance*current^2;
        output place [m] = piston.center.x;
    }
}

linkwright::mechanism! {
    /// A cam lifts a follower, a slide moves by a table of time, and a brake, a bump stop, a bar and a fan have measured laws.
    pub planar Tabled {
        const TURN [deg] = 360;
        param setting [rad] = 0.1;
        param level [1] = 0.2;
        input load [N];
        table lift(angle [deg]) [mm] = [(0, 0), (40, 12), (100, 40), (170, 55), (240, 30), (300, 8), (TURN, 0)], periodic;
        table stroke(clock [s]) [mm] = [(-1, 5), (-0.4, 40), (0, 60), (0.5, 20), (1.1, -30), (2, 10)], cubic;
        table bar(angle [rad]) [N*m] = [(-0.5, -90), (-0.3, -70), (0, 0), (0.25, 42), (1, 250)], natural;
        table bump(gap [mm]) [N] = [(-60, 400), (-20, 90), (0, 0), (30, 0)], outside = hold;
        table damper(speed [m/s]) [N] = [(-1, -60), (-0.2, -30), (0, 0), (0.1, 20), (1, 45)], akima, outside = hold;
        table fan(rate [rpm]) [N*m] = [(-20, -0.3), (-5, -0.1), (0, 0), (5, 0.12), (20, 0.5)], linear;
        table grip(slip [1], load [N]) [N] =
            grid((-0.3, 0, 0.1, 0.3), (-0.5, 0.4, 2), [(-3, 0, 5, 6), (-9, 0, 9, 11), (-20, 0, 17, 20)]), outside = hold;
        table gain(share) = [(0, 1), (0.3, 1.4), (1, 2)], pchip;
        table reach(height [m]) [m] = [(-1, -0.7), (-0.3, -0.3), (0.2, 0.1), (1, 0.9)], modified_akima;
        gravity [m/s^2] = (0, -9.81);
        signal turned [rad] = hinge.angle - setting;
        signal slip [1] = hub.rate*1 [s/rad];
        signal way [m] = reach(bob.end.y);
        disk cam { mass [kg] = 0.8; radius [m] = 0.1; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 0.01; }
        body slide { mass [kg] = 0.5; inertia [kg*m^2] = 0.01; }
        rod arm { mass [kg] = 1.1; length [m] = 0.5; }
        rod bob { mass [kg] = 0.6; length [m] = 0.4; }
        joint hub: revolute(ground(0, 0) [m], cam.center);
        joint rail: prismatic(ground(0, 0.2) [m], follower.center, axis = (0, 1));
        joint bench: prismatic(ground(0.5, 0) [m], slide.center, axis = (1, 0));
        joint hinge: revolute(slide.center, arm.start);
        joint knee: revolute(arm.end, bob.start);
        constraint follow: rail.travel = lift(hub.angle);
        drive shake: bench.travel = 2*stroke(time) + 0.1 [m];
        #[allow(outside_table)]
        torque rest: torque(hinge) = -gain(level)*bar(turned) - fan(hinge.rate);
        force stop: force(rail) = bump(rail.travel - 30 [mm]) - damper(rail.speed);
        #[allow(outside_table)]
        torque brake: torque(hub) = -0.2 [m]*grip(slip, load + 0.3 [N]);
        force rope: along(way) = -20 [N/m]*way - damper(way.rate);
        start { hub.angle [rad] = 0.4; hub.rate [rad/s] = 3; hinge.angle [rad] = -1.2; knee.angle [rad] = 0.3; knee.rate [rad/s] = 1; }
        options { emit = (penalty, projection, null_space, tangent); }
        output bar_rate [N*m/rad] = bar.slope(turned);
        output lifted [mm/deg] = lift.slope(hub.angle);
        output jumped [1] = gain(0.5) + gain.slope(level);
        output rope_rate [m/s] = way.rate;
        output gripped [N] = grip(slip, load);
        output braked [W] = power(brake) + power(rope);
    }
}

linkwright::mechanism! {
    /// A runner on a ground that was measured, with a pendulum on it, in a wind by height and speed.
    pub spatial Terrain {
        param drag [1] = 0.8;
        gravity [m/s^2] = (0, 0, -9.81);
        table relief(east [m], north [m]) [mm] = grid(
            (-1, -0.2, 0.3, 1, 2), (-1, 0, 0.4, 1.5),
            [(0, 120, 90, -60, 20), (40, 180, 130, 0, 30), (60, 150, 60, 20, -10), (-30, 40, 80, 50, 0)]
        ), bicubic;
        table wind(height [m], rate [m/s]) [N] = grid(
            (-1, -0.5, 0, 1), (-3, -1, 1, 3), [(-2, -3, -5, -6), (0, -1, -1, -2), (1, 1, 2, 2), (2, 4, 5, 7)]
        ), bicubic, outside = hold;
        particle runner { mass [kg] = 1.2; }
        rod arm { mass [kg] = 0.7; length [m] = 0.5; radius [mm] = 10; }
        joint hung: spherical(runner.center, arm.start);
        constraint on: runner.center.z = relief(runner.center.x, runner.center.y);
        force blown: force(arm.end, direction = (1, 0.2, 0)) = -drag*wind(arm.end.z, arm.end.velocity.x);
        start { runner.center.x [m] = 0.1; runner.center.y [m] = 0.2; runner.center.velocity.x [m/s] = 0.4; runner.center.velocity.y [m/s] = -0.7;
                arm.orientation = (0.8, 0.1, 0.6, 0); arm.rate.y [rad/s] = 0.3; }
        options { emit = (penalty, projection, null_space, tangent); }
        output height [mm] = runner.center.z;
        output blows [N] = wind(arm.end.z, 2 [m/s]);
    }
}
