//! A block on a slope with Coulomb friction by its weight, thrown upwards; and a brake with Stribeck's friction.
//!
//! Closed forms with exact Coulomb friction, g = 9.81 m/s², 2 m/s up the slope, coefficient 0.5: at 20° it stops at 0.251117160261027 s after as
//! many metres and sticks, at 30° it stops at 0.218511064164014 s and is at 0.017843517838295 m with −0.513551854988346 m/s after 1 s. Made
//! smooth by v_s it creeps where it would stick, with −v_s t/√(1 − t²), t = tan α/μ: at 20° and v_s = 1 mm/s at 1 s it is at 0.250322969903377 m and
//! has −1.06169434217091e-3 m/s. A brake with μ_s = 0.6, μ_k = 0.4, v_t = 0.1 m/s stops from 1 m/s at 0.246400884384634 s after
//! 0.126904351289363 m (by quadrature). Source of the laws: García de Jalón & Bayo, 10.1; Armstrong-Hélouvry, Dupont, Canudas de
//! Wit, Automatica 30 (1994) 1083.

linkwright::mechanism! {
    /// A block on a slope with Coulomb friction, thrown upwards with 2 m/s.
    pub planar RubbingBlock {
        param slope [deg] = 20 in 0..60;
        param smooth [m/s] = 0.001;
        gravity = (-9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = coulomb(coefficient = 0.5, speed = smooth);
        start { rail.travel [m] = 0; rail.speed [m/s] = 2; }
        output place [m] = rail.travel;
        output speed [m/s] = rub.sliding;
        output pressed [N] = rub.normal;
    }
}

linkwright::mechanism! {
    /// A block that brakes itself from 1 m/s by friction that is more where it slides less.
    pub planar StribeckBrake {
        gravity [m/s^2] = (0, -9.81);
        param smooth [m/s] = 0.001;
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = stribeck(static = 0.6, kinetic = 0.4, transition [m/s] = 0.1, speed = smooth);
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        output place [m] = rail.travel;
        output speed [m/s] = rub.sliding;
    }
}
