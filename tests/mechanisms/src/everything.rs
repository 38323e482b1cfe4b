//! One mechanism that uses every operation of the language. Its outputs are compared with their closed forms by
//! `tests/checks/every_operation.rs`.

linkwright::mechanism! {
    /// A rod on a driven cart, so that time, parameters, inputs, positions and velocities are all at hand.
    pub planar Everything {
        param scale [1] = 0.6 in 0.1..0.9;
        param level [m] = 0.3;
        param weight [kg] = 2;
        input push [N];
        input gain [1];
        gravity [m/s^2] = (0, -9.81 [m/s^2] * scale);
        body cart { mass [kg] = weight; inertia [kg*m^2] = 0; }
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint rail: prismatic(ground(0, 0) [m], cart.center, axis = (1, 0));
        joint pivot: revolute(cart.center, arm.start);
        drive shake: rail.travel = level * sin(3 [rad/s] * time) + 0.01 [m/s^2] * time^2;
        force wind: force(arm.end, direction = (1, 2)) = if(arm.end.y < level, push, push / 2);
        torque spin: torque(pivot) = if(scale > 0.5 and not (gain > 0.3), 1 [N*m], -0.2 [N*m*s/rad] * pivot.rate);
        start { pivot.angle [rad] = 0.5; pivot.rate [rad/s] = 0.2; }

        output negated [m] = -arm.end.x;
        output sum [m] = arm.end.x + arm.end.y - level;
        output product [m^2] = arm.end.x * arm.end.y;
        output ratio [1] = arm.end.x / (3 [m] + arm.end.y);
        output square [m^2] = arm.end.x^2;
        output cube [m^-3] = (3 [m] + arm.end.x)^-3;
        output root [m^3] = ((3 [m] + arm.end.x)^2)^1.5;
        output general_power [1] = (2 + gain)^1.3;
        output square_root [1] = sqrt(1.5 + gain);
        output magnitude [m] = abs(arm.end.x);
        output direction [1] = sign(arm.end.x);
        output sine [1] = sin(pivot.angle);
        output cosine [1] = cos(2 * pivot.angle);
        output tangent [1] = tan(gain);
        output arc_sine [rad] = asin(gain);
        output arc_cosine [rad] = acos(gain);
        output arc_tangent [rad] = atan2(arm.end.y, arm.end.x);
        output exponential [1] = exp(gain);
        output logarithm [1] = ln(2 + gain);
        output decades [1] = log10(2 + gain);
        output hyperbolic_sine [1] = sinh(gain);
        output hyperbolic_cosine [1] = cosh(gain);
        output hyperbolic_tangent [1] = tanh(3*gain);
        output slope [rad] = atan(2*gain);
        output hypotenuse [m] = hypot(arm.end.x, level);
        output limited [m] = clamp(arm.end.x, -0.5 [m], level);
        output beyond [m] = deadband(arm.end.y, level);
        output smooth [1] = smoothstep(gain, -0.4, 0.5);
        output positive [1] = step(gain);
        output wrapped [rad] = wrap(5*pivot.angle);
        output phase [m] = wrap(arm.end.x, level);
        output smaller [m] = min(arm.end.x, arm.end.y);
        output larger [m] = max(arm.end.x, level);
        output less [1] = if(gain < 0.2, 1, -1);
        output less_equal [1] = if(gain <= 0.2, 1, -1);
        output greater [1] = if(gain > 0.2, 1, -1);
        output greater_equal [1] = if(gain >= 0.2, 1, -1);
        output equal [1] = if(gain == 0.2, 1, -1);
        output not_equal [1] = if(gain != 0.2, 1, -1);
        output both [1] = if(gain > -0.5 and gain < 0.5, 1, -1);
        output either [1] = if(gain < -0.5 or gain > 0.5, 1, -1);
        output neither [1] = if(not (gain < -0.5 or gain > 0.5), 1, -1);
        output of_parameters [1] = if(scale > 0.6, gain, -gain);
        output of_parameters_too [1] = if(scale > 0.6 and gain > 0, scale, 2*scale);
        output angle [rad] = pivot.angle;
        output body_angle [rad] = arm.angle;
        output rate [rad/s] = pivot.rate;
        output travel [m] = rail.travel;
        output speed [m/s] = rail.speed;
        output velocity [m/s] = arm.end.velocity.x;
        output far [m] = distance(ground(1, 2) [m], arm.end);
        output clock [s] = time;
        output wind_power [W] = power(wind);
        output shake_power [W] = shake.power;
        output shake_effort [N] = shake.effort;
        output moving [J] = kinetic_energy;
        output stored [J] = potential_energy;
        output total [J] = energy;
    }
}
