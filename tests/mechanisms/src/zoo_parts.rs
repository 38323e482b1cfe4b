//! Mechanisms put together from parts: of their own and of the library; within parts and rounds; in the plane and in space.

linkwright::mechanism! {
    /// Two legs of one part, in each a shank of another, a row of pendulums, a motor, a strut, a cylinder and a wheel of the library, and
    /// fingers.
    pub planar Assembled {
        const FINGERS = 2;
        param stiffness [N/m] = 300;
        param soft_spring [N*m/rad] = 4;
        input voltage [V];
        input opening [1];
        part Shank(knee: place, share [1]) {
            const LENGTH [m] = 0.35;
            param mass [kg] = 0.8;
            rod bone { mass = share*mass; length [m] = LENGTH; point heel [m] = (0.1, -0.03); }
            joint pin: revolute(knee, bone.start);
            signal bent [rad] = pin.angle - 0.1 [rad];
        }
        part Leg(hip: place, side [1] = 1, stiff [N*m/rad], soft: table) {
            input effort [N*m];
            state tired [N*m*s] = 0.02*side*1 [N*m*s], scale = 0.1;
            rate tired = effort - 2 [1/s]*tired;
            rod thigh { mass [kg] = 1.5; length [m] = 0.4; }
            joint pin: revolute(hip, thigh.start);
            part shank: Shank(knee = thigh.end, share = 1 + 0.1*side);
            torque muscle: torque(shank.pin) = effort - stiff*(shank.bent - 0.2 [rad]*side) - 3 [1/s]*tired;
            torque rest: torque(pin) = -soft(pin.angle);
            start { pin.angle = 20 [deg]*side; shank.pin.angle [deg] = -40; shank.pin.rate = 0.3 [rad/s]*side; }
            output foot [mm] = shank.bone.heel.y;
        }
        part Row(at: place, n [1], step [m] = 0.1) {
            repeat i in 0..n {
                rod link[i] { mass [kg] = 0.1; length = (i + 1)*step; }
                joint pin[i]: revolute(at, link[i].start);
                start { pin[i].angle [rad] = 0.2*(i + 1) - 1; }
            }
            output last [rad] = pin[n - 1].angle;
        }
        part Finger(root: place, turn [rad], spring [N*m/rad]) {
            rod near { mass [g] = 40; length [mm] = 60; }
            part far: Tip(at = near.end);
            joint base: revolute(root, near.start);
            torque hold: torque(base) = -spring*(base.angle - turn);
            start { base.angle = turn; }
        }
        part Tip(at: place) {
            rod link { mass [g] = 20; length [mm] = 40; }
            joint tip: revolute(at, link.start);
            torque hold: torque(tip) = -0.02 [N*m*s/rad]*tip.rate;
        }
        table gentle(angle [deg]) [N*m] = [(-180, -40), (0, 0), (90, 10), (180, 30)], natural;
        table damper(speed [m/s]) [N] = [(-1, -60), (-0.2, -30), (0, 0), (0.1, 20), (1, 45)], akima, outside = hold;
        table stops(length [mm]) [N] = [(100, 800), (180, 60), (300, 0), (500, 0), (600, -400)], monotone;
        gravity [m/s^2] = (0, -9.81);
        box hull { mass [kg] = 10; width [m] = 0.6; height [m] = 0.1; point left [m] = (-0.2, 0); point right [m] = (0.2, 0); point mast [m] = (0, 0.05); }
        body hub { mass [kg] = 2; inertia [kg*m^2] = 0.06; }
        joint rail: prismatic(ground(0, 1) [m], hull.center, axis = (1, 0.2));
        part left: Leg(hip = hull.left, side = -1, stiff = soft_spring, soft = gentle);
        part right: Leg(hip = hull.right, stiff [N*m/deg] = 0.1, soft = gentle);
        part row: Row(at = ground(-1, 0.5) [m], n = FINGERS + 1);
        repeat k in 0..FINGERS { part finger[k]: Finger(root = left.shank.bone.heel, turn [deg] = 30*k - 20, spring = 2*soft_spring); }
        part strut: Strut(top = hull.mast, bottom = ground(0.3, 0.65) [m], stiffness = stiffness, free [mm] = 400, damper = damper, stops = stops);
        part motor: DcMotor(shaft = left.pin, voltage = voltage, resistance [ohm] = 0.5, inductance [mH] = 20, constant [N*m/A] = 0.1, ratio = 3);
        part lift: HydraulicCylinder(base = ground(0.2, 0.2) [m], eye = right.thigh.end, opening = 0.2*sin(opening), bore [mm] = 20, rod [mm] = 12,
                                     closed [mm] = 100, stroke [m] = 0.9, supply [bar] = 5, flow [m^3/s] = 1e-5, start [bar] = 1,
                                     start_ring [bar] = 1.5, bulk [bar] = 60);
        part tyre: Tyre(wheel = hub, radius [m] = 0.25, stiffness [N/m] = 900, damping [N*s/m] = 8);
        spring tie: spring(left.shank.bone.end, right.shank.bone.end, stiffness [N/m] = 300, length [m] = 0.3);
        start { hub.center.x [m] = 1.5; hub.center.y [m] = 0.2; hub.center.velocity.x [m/s] = 2; hub.rate [rad/s] = -8; rail.speed [m/s] = 0.2; }
        options { emit = (tangent); }
        output lead [deg] = left.shank.pin.angle - right.shank.pin.angle;
        output current [A] = motor.current;
        output thrust [N] = lift.thrust;
        output bent [rad] = finger[1].far.tip.angle;
    }
}

linkwright::mechanism! {
    /// A platform in space on three struts and a cylinder, with a swing of a part on it.
    pub spatial Propped {
        input opening [1];
        part Swing(at: place, length [m], reach: body) {
            rod arm { mass [kg] = 0.4; length = length; radius [m] = 0.01; }
            joint pin: revolute(at, arm.start, axis = (0, 1, 0));
            spring tie: spring(arm.end, reach.center, stiffness [N/m] = 20, length [m] = 0.1);
            output height [m] = arm.end.z;
        }
        table damper(speed [m/s]) [N] = [(-1, -60), (0, 0), (1, 45)], linear;
        table stops(length [mm]) [N] = [(100, 800), (300, 0), (600, -400)], pchip;
        gravity [m/s^2] = (0, 0, -9.81);
        box plate { mass [kg] = 3; size [m] = (0.5, 0.4, 0.05); point edge[0] [m] = (0.25, 0, 0); point edge[1] [m] = (-0.2, 0.2, 0);
                    point edge[2] [m] = (-0.2, -0.2, 0); }
        part swing: Swing(at = plate.edge[0], length [mm] = 200, reach = plate);
        repeat i in 0..3 {
            part prop[i]: Strut(top = plate.edge[i], bottom = ground(0.3*cos(2*pi*i/3), 0.3*sin(2*pi*i/3), 0) [m], stiffness [N/m] = 400 + 50*i,
                                free [mm] = 420, damper = damper, stops = stops);
        }
        part lift: HydraulicCylinder(base = ground(0, 0, -0.2) [m], eye = plate.center, opening = 0.3*opening/(1 + opening^2), bore [mm] = 20,
                                     rod [mm] = 12, closed [mm] = 100, stroke [m] = 0.9, supply [bar] = 4, flow [m^3/s] = 1e-5,
                                     start [bar] = 1, start_ring [bar] = 1, bulk [bar] = 50);
        start { plate.center.z [m] = 0.35; plate.center.x [m] = 0.02; swing.pin.angle [rad] = 0.4; }
        output pressure [bar] = lift.pressure;
    }
}
