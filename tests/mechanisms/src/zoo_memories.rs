//! Memories and the events that set them, beside gates of contacts that are held.

linkwright::mechanism! {
    /// A sampled controller holds the force on one slider; a latch catches another, which has a stop and remembers how it was caught; a pendulum
    /// counts its swings. The bolt is thrown back once.
    pub planar Remembering {
        param target [m] = 0.2;
        param stiffness [N/m] = 200;
        input pull [N];
        gravity [m/s^2] = (0, -9.81);
        body slider { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        body bolt { mass [kg] = 2; inertia [kg*m^2] = 0.02; }
        rod pendulum { mass [kg] = 0.5; length [m] = 0.6; }
        joint rail: prismatic(ground(0, 1) [m], slider.origin, axis = (1, 0));
        joint bore: prismatic(ground(0, 2) [m], bolt.origin, axis = (1, 0));
        joint pivot: revolute(ground(1, 0) [m], pendulum.start);
        memory held [N] = 0;
        memory sum [m*s] = 0.01;
        memory before [mm] = 50;
        memory engaged = 0;
        memory touched [m/s] = 0;
        memory swings = 0;
        memory most [N] = 0;
        signal error [m] = target - rail.travel;
        event tick: every 10 [ms] {
            held = 50 [N/m]*error + 20 [N/(m*s)]*sum - 15 [N*s/m]*(rail.travel - before)/0.01 [s];
            sum = sum + error*0.01 [s];
            before = rail.travel;
        }
        event latch: bore.travel rises 0.1 [m] { engaged = 1; touched = bore.speed; }
        event off: bore.travel falls 0.1 [m] { engaged = 0; }
        event swing: pivot.angle crosses -90 [deg] { swings = swings + 1; most = max(most, 2 [N*s/rad]*abs(pivot.rate)); }
        event kicked: time rises 1.3 [s] { jump(bore.speed) = 0.1 [m/s] - 0.5*bore.speed; }
        event pushed: time rises 0.6 [s] { most = 2*pull; }
        force motor: along(rail.travel) = held;
        force spring: along(bore.travel) = -stiffness*engaged*(bore.travel - 0.1 [m]);
        limit stop: bore.travel [m] in -0.5..0.4 = kelvin_voigt(stiffness [N/m] = 5000, damping [N*s/m] = 30);
        start { rail.travel [m] = 0.05; rail.speed [m/s] = 0.3; bore.travel [m] = 0; bore.speed [m/s] = 0.5;
                pivot.angle [deg] = -60; pivot.rate [rad/s] = 0; }
        options { contact = held; emit = (penalty, projection, null_space, tangent); }
        output place [m] = rail.travel;
        output speed [m/s] = rail.speed;
        output force [N] = held;
        output caught [m] = bore.travel;
        output back [m/s] = bore.speed;
        output impact [m/s] = touched;
        output passes = swings;
        output load [N] = most;
        output summed [m*s] = sum;
    }
}
