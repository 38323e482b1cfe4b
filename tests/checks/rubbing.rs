//! Friction of contacts: blocks on slopes by closed forms, and what holds of bodies that touch nothing but each other.

use linkwright::{Fields, Mechanism, Report, Rk4, Simulation, StateOf, Vector, retract};

linkwright::mechanism! {
    /// A block on a slope of 30°, pressed in as deep as its weight presses it.
    planar Slope {
        param steep [deg] = 30;
        param smooth [m/s] = 1e-9;
        const depth [m] = 1e-5;
        gravity = (9.81 [m/s^2]*sin(steep), -9.81 [m/s^2]*cos(steep));
        particle block { mass [kg] = 2; }
        surface sole: point(block.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        #[allow(penetration)]
        contact touch: between(sole, floor) = 2 [kg]*9.81 [m/s^2]*cos(steep)*(touch.depth/depth) + 4000 [N*s/m]*touch.closing;
        friction grip: on(touch) = coulomb(coefficient = 0.5, speed = smooth);
        start { block.center.x [m] = 0; block.center.y [m] = -1e-5; block.center.velocity.x [m/s] = 2; }
        output speed [m/s] = block.center.velocity.x;
        output place [m] = block.center.x;
    }
}

linkwright::mechanism! {
    /// The same of a box on two corners, whose front one is pressed in deeper.
    planar BoxOnSlope {
        gravity = (9.81 [m/s^2]*sin(30 [deg]), -9.81 [m/s^2]*cos(30 [deg]));
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.02; point a [m] = (-0.1, -0.05); point b [m] = (0.1, -0.05); point c [m] = (0, 0.1);
                     surface sole: polygon(block.a, block.b, block.c); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(block.sole, floor) = kelvin_voigt(stiffness [N/m] = 1e5, damping [N*s/m] = 300);
        friction grip: on(touch) = coulomb(coefficient = 0.3, speed [m/s] = 1e-6);
        start { block.center.x [m] = 0; block.center.y [m] = 0.0501; block.angle [rad] = 0; block.center.velocity.x [m/s] = 2; }
        output speed [m/s] = block.center.velocity.x;
        output pressed [N] = grip.normal;
        output lost [W] = -power(grip);
    }
}

linkwright::mechanism! {
    /// Three bodies far from everything.
    #[allow(penetration)]
    planar Adrift {
        disk ball { mass [kg] = 1; radius [m] = 0.4; }
        disk ring { mass [kg] = 0.5; radius [m] = 0.7; }
        body frame {
            mass [kg] = 2; inertia [kg*m^2] = 0.3; center [m] = (0.02, -0.03);
            point a [m] = (-0.5, -0.3); point b [m] = (0.6, -0.2); point c [m] = (0.4, 0.5);
            surface block: polygon(frame.a, frame.b, frame.c);
            surface bar: segment(frame.a, frame.c, radius [m] = 0.3);
            surface bore: hole(frame.b, radius [m] = 0.45);
        }
        contact sits: between(ball.surface, frame.block) = kelvin_voigt(stiffness [N/m] = 100, damping [N*s/m] = 2);
        contact lies: between(ring.surface, frame.bar) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 1);
        contact held: between(ball.surface, frame.bore) = kelvin_voigt(stiffness [N/m] = 60, damping [N*s/m] = 3);
        contact hits: between(ring.surface, ball.surface) = kelvin_voigt(stiffness [N/m] = 90);
        friction f_sits: on(sits) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_lies: on(lies) = stribeck(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, speed [m/s] = 0.1, viscous [N*s/m] = 1);
        friction f_held: on(held) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_hits: on(hits) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        start { ball.center.x [m] = 0.1; ball.center.y [m] = 0.2; ball.angle [rad] = 0; ring.center.x [m] = -0.3; ring.center.y [m] = 0.1;
                frame.center.x [m] = 0; frame.center.y [m] = 0; frame.angle [rad] = 0.3; ring.angle [rad] = 0; }
    }
}

linkwright::mechanism! {
    /// The same in space.
    #[allow(penetration)]
    spatial AdriftInSpace {
        sphere ball { mass [kg] = 1; radius [m] = 0.4; }
        sphere marble { mass [kg] = 0.5; radius [m] = 0.6; }
        body block {
            mass [kg] = 3; inertia [kg*m^2] = (0.3, 0.4, 0.5);
            point left [m] = (-0.4, 0.1, 0.2); point right [m] = (0.4, 0.3, 0.1);
            surface slope: plane(block.left, axis = (0.2, 0.1, 1));
            surface socket: ball_socket(block.right, radius [m] = 0.45);
            surface rail: capsule(block.left, block.right, radius [m] = 0.2);
            surface column: cylinder(block.left, axis = (0.1, 0.2, 1), radius [m] = 0.5, length [m] = 0.8);
        }
        contact rolls: between(ball.surface, block.slope) = kelvin_voigt(stiffness [N/m] = 100, damping [N*s/m] = 2);
        contact seated: between(block.socket, ball.surface) = kelvin_voigt(stiffness [N/m] = 60, damping [N*s/m] = 2);
        contact rails: between(marble.surface, block.rail) = kelvin_voigt(stiffness [N/m] = 70, damping [N*s/m] = 2);
        contact columns: between(block.column, marble.surface) = kelvin_voigt(stiffness [N/m] = 80, damping [N*s/m] = 1);
        contact knocks: between(marble.surface, ball.surface) = kelvin_voigt(stiffness [N/m] = 90);
        friction f_rolls: on(rolls) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_seated: on(seated) = stribeck(static = 0.5, kinetic = 0.3, transition [m/s] = 0.4, speed [m/s] = 0.1, viscous [N*s/m] = 1);
        friction f_rails: on(rails) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_columns: on(columns) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        friction f_knocks: on(knocks) = coulomb(coefficient = 0.4, speed [m/s] = 0.1);
        start { ball.center.x [m] = 0.1; ball.center.y [m] = 0.2; ball.center.z [m] = 0.3; marble.center.x [m] = -0.3; marble.center.y [m] = 0.1;
                marble.center.z [m] = 0.2; block.center.x [m] = 0; block.center.y [m] = 0; block.center.z [m] = 0; }
    }
}

fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// g (sin α − μ cos α) down the slope, and with the other sign of μ up.
#[test]
fn a_block_slides_on_a_slope() {
    let (model, alpha) = (Slope::default(), 30.0_f64.to_radians());
    for (speed, sign) in [(2.0, -1.0), (-2.0, 1.0)] {
        let mut state = Slope::START;
        state.v.as_mut_slice()[0] = speed;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(0.0, &state, &Default::default(), &mut a, &mut lambda);
        close(a.as_slice()[0], 9.81 * (alpha.sin() + sign * 0.5 * alpha.cos()), 1e-12, "along the slope");
        close(a.as_slice()[1], 0.0, 1e-12, "across it");
    }
    let mut simulation = Simulation::new(&model, Slope::START).integrator(Rk4).step(1e-4);
    simulation.advance_until(0.5).expect("it slides");
    let speed = simulation.sample().outputs.speed;
    close(speed, 2.0 + 0.5 * 9.81 * (alpha.sin() - 0.5 * alpha.cos()), 1e-10, "after half a second");
}

/// With μ N s(v) = m g sin α, s = v/√(v² + v_s²): v = v_s t/√(1 − t²), t = tan α/μ.
#[test]
fn a_block_that_rests_creeps() {
    let parameters = SlopeParameters { steep: 20.0_f64.to_radians(), smooth: 1e-3 };
    let model = Slope::prepare(parameters).expect("parameters");
    let mut state = Slope::START;
    state.v.as_mut_slice()[0] = 0.0;
    let mut simulation = Simulation::new(&model, state).integrator(Rk4).step(1e-4);
    simulation.advance_until(0.1).expect("it creeps");
    let t = 20.0_f64.to_radians().tan() / 0.5;
    let creeps = simulation.sample().outputs;
    close(creeps.speed, 1e-3 * t / (1.0 - t * t).sqrt(), 1e-12, "creep");
    assert!(creeps.place <= 0.1 * creeps.speed, "it has crept by {} m", creeps.place);
}

/// Both corners are pressed by what they carry, and rub by it.
#[test]
fn a_box_slides_on_its_corners() {
    let (model, alpha) = (BoxOnSlope::default(), 30.0_f64.to_radians());
    let mut simulation = Simulation::new(&model, BoxOnSlope::START).integrator(Rk4).step(1e-4);
    simulation.advance_until(1.0).expect("it slides");
    let first = simulation.sample().outputs;
    simulation.advance_until(1.5).expect("it slides");
    let then = simulation.sample().outputs;
    close((then.speed - first.speed) / 0.5, 9.81 * (alpha.sin() - 0.3 * alpha.cos()), 1e-8, "acceleration");
    close(then.pressed, 2.0 * 9.81 * alpha.cos(), 1e-8, "what presses");
    close(then.lost, 0.3 * then.pressed * then.speed, 1e-4, "power");
}

/// Pseudo-random numbers in −1..1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// Rates of the momentum and of the moment of momentum, and the largest force; powers of frictions are none that is positive.
fn adrift<M>(
    model: &M,
    start: StateOf<M, f64>,
    masses: &[f64],
    inertias: &[[f64; 3]],
    seed: &mut u64,
) -> ([f64; 6], f64, usize)
where
    M: Report<f64, Inputs = ()>,
{
    let mut w = model.zero_v();
    w.as_mut_slice().iter_mut().for_each(|w| *w = 0.3 * random(seed));
    let (mut state, q) = (start.clone(), start.q);
    retract(model.layout(), &q, &w, &mut state.q);
    state.v.as_mut_slice().iter_mut().for_each(|v| *v = 3.0 * random(seed));
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration(0.0, &state, &(), &mut a, &mut lambda);
    let powers = model.powers(0.0, &state, &());
    let powers = model.loads().iter().zip(powers.as_slice()).filter(|(name, _)| name.starts_with("f_"));
    let powers: Vec<f64> = powers.map(|(_, power)| *power).collect();
    assert!(powers.iter().all(|power| *power <= 0.0), "{powers:?}");
    let rubbing = powers.iter().filter(|power| **power < 0.0).count();
    let motions = model.motions(0.0, &state.q, &state.v, &a);
    let motions: Vec<f64> =
        motions.as_ref().iter().flat_map(|motion| motion.to_array().as_slice().to_vec()).collect();
    let (mut rates, mut largest) = ([0.0; 6], 0.0_f64);
    let size = motions.len() / masses.len();
    for ((body, m), [jx, jy, jz]) in motions.chunks(size).zip(masses).zip(inertias) {
        let (r, force, torque) = if size == 10 {
            ([body[0], body[1], 0.0], [m * body[7], m * body[8], 0.0], [0.0, 0.0, jz * body[9]])
        } else {
            let (w, b) = (&body[15..18], &body[21..24]);
            let own = [
                jx * b[0] + (jz - jy) * w[1] * w[2],
                jy * b[1] + (jx - jz) * w[2] * w[0],
                jz * b[2] + (jy - jx) * w[0] * w[1],
            ];
            let row = |at: usize| (0..3).map(|k| body[at + k] * own[k]).sum::<f64>();
            ([body[0], body[1], body[2]], [18, 19, 20].map(|at| m * body[at]), [row(3), row(6), row(9)])
        };
        let moment = [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            torque[k] + r[i] * force[j] - r[j] * force[i]
        });
        for k in 0..3 {
            rates[k] += force[k];
            rates[3 + k] += moment[k];
            largest = largest.max(force[k].abs()).max(moment[k].abs());
        }
    }
    (rates, largest, rubbing)
}

#[test]
fn friction_is_mutual_and_takes_energy() {
    let (mut seed, mut rubbing) = (17, [0, 0]);
    let check = |(rates, largest, count): ([f64; 6], f64, usize), rubbing: &mut usize| {
        assert!(rates.iter().all(|rate| rate.abs() <= 1e-11 * (1.0 + largest)), "{rates:?} of {largest}");
        *rubbing += count;
    };
    for _ in 0..200 {
        let plane = Adrift::default();
        let inertias = [0.5 * 0.4 * 0.4, 0.5 * 0.5 * 0.7 * 0.7, 0.3].map(|j| [0.0, 0.0, j]);
        check(adrift(&plane, Adrift::START, &[1.0, 0.5, 2.0], &inertias, &mut seed), &mut rubbing[0]);
        let space = AdriftInSpace::default();
        let [ball, marble] = [0.4 * 0.4 * 0.4, 0.4 * 0.5 * 0.6 * 0.6].map(|j| [j; 3]);
        let inertias = [ball, marble, [0.3, 0.4, 0.5]];
        check(adrift(&space, AdriftInSpace::START, &[1.0, 0.5, 3.0], &inertias, &mut seed), &mut rubbing[1]);
    }
    println!("frictions that act: {rubbing:?}");
    assert!(rubbing.iter().all(|count| *count > 200), "{rubbing:?}");
}
