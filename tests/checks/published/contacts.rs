//! Contacts that yield, against closed forms and separate integrations: balls that bounce, the restitution that was asked for, places and
//! directions of forces, a cross that falls, a hammer at a wall, a pin with play.

use linkwright::{Assemble, DormandPrince, Rk4, Sample, Simulation, StateOf};
use linkwright_models::bouncing_ball::{BouncingBall, BouncingBallOfHuntAndCrossley};
use linkwright_models::falling_cross::FallingCross;
use linkwright_models::hammer_at_wall::HammerAtWall;
use linkwright_models::loose_wrist::LooseWrist;

mod inner {
    linkwright::mechanism! {
        /// A ball that hits a wall without gravity, and two disks that hit each other off their centres.
        pub planar Blow {
            param exponent_free [N] = 900;
            disk ball { mass [kg] = 0.7; radius [m] = 0.05; }
            surface wall: half_plane(line(ground(0, 1) [m], ground(0, -1) [m]), side = right);
            contact strike: between(ball.surface, wall) = hunt_crossley(force = exponent_free, depth [mm] = 8, exponent = 2.3, restitution = 0.8, speed [m/s] = 1.7);
            disk one { mass [kg] = 1; radius [m] = 0.1; }
            disk other { mass [kg] = 2; radius [m] = 0.2; }
            contact meet: between(one.surface, other.surface) = kelvin_voigt(stiffness [N/m] = 8000, damping [N*s/m] = 10);
            start { ball.center.x [m] = -0.2; ball.center.y [m] = 0; ball.center.velocity.x [m/s] = 1.7; ball.angle [rad] = 0;
                    one.center.x [m] = 1; one.center.y [m] = 0; one.angle [rad] = 0; other.angle [rad] = 0; one.center.velocity.x [m/s] = 2;
                    other.center.x [m] = 1.4; other.center.y [m] = 0.15; }
            output speed [m/s] = ball.center.velocity.x;
            output force [N] = strike.force;
            output gap [m] = meet.gap;
            output met [N] = meet.force;
            output point_x [m] = meet.point.x;
            output point_y [m] = meet.point.y;
            output wall_x [m] = strike.point.x;
            output momentum_x [N*s] = 1 [kg]*one.center.velocity.x + 2 [kg]*other.center.velocity.x;
            output momentum_y [N*s] = 1 [kg]*one.center.velocity.y + 2 [kg]*other.center.velocity.y;
            output turning [N*m*s] = 1 [kg]*cross(one.center, one.center.velocity) + 2 [kg]*cross(other.center, other.center.velocity)
                + 0.005 [kg*m^2]*one.rate + 0.04 [kg*m^2]*other.rate;
        }
    }
}

use inner::Blow;

/// Runs with Runge and Kutta's method at this step and shows what is at these times.
fn at_times<M: Assemble<f64, Inputs = ()>, T, const N: usize>(
    model: &M,
    start: StateOf<M>,
    step: f64,
    times: [f64; N],
    show: impl Fn(&Sample<'_, f64, M>) -> T,
) -> [T; N] {
    let mut simulation = Simulation::new(model, start).integrator(Rk4).step(step);
    times.map(|time| {
        simulation.advance_until(time).expect("it moves");
        show(&simulation.sample())
    })
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// The force of the linear law jumps where a touch begins, and plain steps are of first order there.
#[test]
fn a_ball_bounces_on_spring_and_damper() {
    let model = BouncingBall::default();
    let height = |sample: &Sample<'_, f64, BouncingBall>| sample.outputs.height;
    let [one, three] = at_times(&model, BouncingBall::START, 1e-5, [1.0, 3.0], height);
    close(one, 0.140_026_352_533_671_8, 1e-4, "height after 1 s");
    close(three, -9.808_079_883_835e-4, 1e-6, "height after 3 s");
}

#[test]
fn a_ball_bounces_after_hunt_and_crossley() {
    let model = BouncingBallOfHuntAndCrossley::default();
    let seen = |sample: &Sample<'_, f64, BouncingBallOfHuntAndCrossley>| {
        (sample.outputs.height, sample.outputs.depth, sample.outputs.force)
    };
    let times = [0.323_996_484_087_54, 1.0, 2.0];
    let [peak, one, two] = at_times(&model, BouncingBallOfHuntAndCrossley::START, 1e-5, times, seen);
    close(peak.1, 9.548_749_886_575_41e-3, 1e-9, "deepest");
    close(peak.2, 933.081_925_322_201, 1e-3, "force there");
    close(one.0, 0.131_956_747_826_441_5, 1e-7, "height after 1 s");
    close(two.0, 0.029_595_746_011_844_4, 1e-7, "height after 2 s");
}

/// e is what was written, whatever mass, stiffness and exponent are; no force pulls.
#[test]
fn restitution_is_exact() {
    let model = Blow::default();
    let mut simulation =
        Simulation::new(&model, Blow::START).integrator(DormandPrince::tolerance(1e-11)).step(1e-4);
    let mut least = f64::INFINITY;
    simulation
        .run_until(0.6, |sample| least = least.min(sample.outputs.force).min(sample.outputs.met))
        .expect("it moves");
    close(simulation.sample().outputs.speed, -0.8 * 1.7, 1e-8, "speed after the blow");
    assert!(least >= 0.0, "a contact pulls by {least} N");
}

/// Equal and opposite forces along one line, which goes through the place of the contact.
#[test]
fn forces_are_opposite() {
    let model = Blow::default();
    let mut simulation = Simulation::new(&model, Blow::START).integrator(Rk4).step(1e-4);
    let before = simulation.sample().outputs;
    let (mut touched, mut worst) = (0, 0.0_f64);
    simulation
        .run_until(0.4, |sample| {
            let now = &sample.outputs;
            let [x, y] = [now.momentum_x - before.momentum_x, now.momentum_y - before.momentum_y];
            worst = worst.max(x.abs()).max(y.abs()).max((now.turning - before.turning).abs());
            touched += usize::from(now.met > 0.0);
        })
        .expect("they move");
    println!("momentum off by {worst:.1e}, {touched} steps in contact");
    assert!(touched > 50, "{touched} steps in contact");
    assert!(worst < 1e-12, "momentum off by {worst}");
    // Halfway between both surfaces: 0.1 and 0.2 m from centres that are 0.4 m and 0.15 m apart.
    let distance = f64::hypot(0.4, 0.15);
    let gap = distance - 0.3;
    close(before.gap, gap, 1e-15, "gap");
    let out = 0.1 + gap / 2.0;
    close(before.point_x, 1.0 + out * 0.4 / distance, 1e-15, "place, x");
    close(before.point_y, out * 0.15 / distance, 1e-15, "place, y");
    close(before.wall_x, -0.075, 1e-15, "halfway to the wall");
}

#[test]
fn a_cross_falls() {
    let model = FallingCross::default();
    let seen = |sample: &Sample<'_, f64, FallingCross>| {
        let o = &sample.outputs;
        ([o.height, o.rate_x, o.rate_y, o.rate_z], sample.state.q.as_slice().to_vec())
    };
    let [half, one, late] = at_times(&model, FallingCross::START, 1e-5, [0.5, 1.0, 1.5], seen);
    for (found, expected) in
        half.0.iter().zip([0.121_451_181_183_42, -8.779_453_567_8, -0.363_171_741_3, 0.718_291_190_9])
    {
        close(*found, expected, 1e-4 * (1.0 + expected.abs()), "after 0.5 s");
    }
    close(one.0[0], 0.009_773_944_447_08, 1e-4, "height after 1 s");
    close(late.0[0], -9.809_998_47e-4, 1e-6, "height after 1.5 s");
    close(late.0[3], 0.813_797_681_349_38, 1e-4, "turning after 1.5 s");
    for (q, expected) in [
        (&half.1, [0.955_119_424_1, 0.057_115_529_5, 0.032_165_456_4, 0.288_877_284_3]),
        (&one.1, [0.877_986_955_0, 0.010_730_984_9, 0.001_482_336_8, 0.478_561_966_2]),
    ] {
        for (part, expected) in q[3..7].iter().zip(expected) {
            close(*part, expected, 1e-4, "orientation");
        }
    }
}

#[test]
fn a_hammer_swings_at_a_wall() {
    let model = HammerAtWall::default();
    let seen = |sample: &Sample<'_, f64, HammerAtWall>| (sample.outputs.upper, sample.outputs.lower);
    let [(upper, lower)] = at_times(&model, HammerAtWall::START, 1e-5, [1.0], seen);
    // But for whole turns.
    close((upper - HAMMER[0]).sin(), 0.0, 1e-7, "upper rod after 1 s");
    close((lower - HAMMER[1]).sin(), 0.0, 1e-7, "lower rod after 1 s");
}

/// Of the double pendulum in two angles by Lagrange's equations, with the force at its tip.
const HAMMER: [f64; 2] = [-0.687_388_757_419_264_9, -2.326_143_940_729_900_7];

#[test]
fn a_wrist_has_play() {
    let model = LooseWrist::default();
    let tolerance = DormandPrince::tolerance(1e-11);
    let mut simulation = Simulation::new(&model, LooseWrist::START).integrator(tolerance).step(1e-6);
    simulation.advance_until(0.025).expect("it moves");
    let o = simulation.sample().outputs;
    close(o.angle, -0.428_311_642_606, 1e-9, "rod");
    close(o.travel, 0.108_685_954_481, 1e-10, "slider");
    close(o.off_x, -0.474_239_204_595e-3, 1e-11, "off along x");
    close(o.off_y, -0.159_734_004_988e-3, 1e-11, "off along y");
}
