//! Dry friction of rigid contacts: it holds, slides and turns as closed forms say, in touches too; errors where it jams. The toy that pecks its way
//! down by it.

use linkwright::{
    AssembleExt, DormandPrince, LagrangeIndex1, Rk4, SemiImplicitEuler, Simulation, SimulationError, Vector,
};
use linkwright_engine::Engine;
use linkwright_models::woodpecker::Woodpecker;

linkwright::mechanism! {
    /// A block on two of its corners, thrown up a slope of 20 or 30 degrees.
    planar Block {
        param slope [deg] = 20;
        gravity = (-9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; point a [m] = (-0.1, -0.05); point b [m] = (0.1, -0.05);
                     surface left: point(block.a); surface right: point(block.b); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact one: between(block.left, floor) = rigid(restitution = 0);
        contact other: between(block.right, floor) = rigid(restitution = 0);
        friction rub: on(one) = dry(static = 0.5);
        friction grip: on(other) = dry(static = 0.5);
        state taken [J] = 0;
        rate taken = power(rub) + power(grip);
        start { block.center.x [m] = 0; block.center.y [m] = 0.05; block.angle [rad] = 0; block.center.velocity.x [m/s] = 2; }
        output x [m] = block.center.x;
        output v [m/s] = block.center.velocity.x;
        output pressed [N] = rub.normal + grip.normal;
        output force [N] = rub.force + grip.force;
        output share [N] = rub.force - grip.force;
        output friction [J] = taken;
    }
}

linkwright::mechanism! {
    /// A disk that is thrown along a road, and falls on it or lies there.
    planar Thrown {
        param bounces [1] = 0;
        param grip [1] = 0.2;
        gravity [m/s^2] = (0, -9.81);
        disk wheel { mass [kg] = 2; radius [m] = 0.1; }
        surface road: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(road, wheel.surface) = rigid(restitution = bounces);
        friction rub: on(touch) = dry(static = grip);
        start { wheel.center.x [m] = 0; wheel.center.y [m] = 0.1; wheel.angle [rad] = 0; wheel.center.velocity.x [m/s] = 3; }
        output sliding [m/s] = touch.sliding;
        output force [N] = rub.force;
    }
}

linkwright::mechanism! {
    /// A block on a belt, held back by a spring: N and stiffness of the sources' 1 kg, 1 N/m, 0.2 m/s, 1 N and 0.5 N.
    planar Carried {
        param kinetic [1] = 0.5;
        gravity [m/s^2] = (0, -1);
        body belt { mass [kg] = 1; inertia [kg*m^2] = 1; point a [m] = (0, 0); point b [m] = (1, 0);
                    line top = (belt.a, belt.b); surface over: half_plane(belt.top); }
        joint guide: prismatic(ground(0, 0) [m], belt.center, axis = (1, 0));
        drive run: guide.travel = 0.2 [m/s]*time;
        particle block { mass [kg] = 1; surface foot: point(block.center); }
        contact touch: between(block.foot, belt.over) = rigid(restitution = 0);
        friction rub: on(touch) = dry(static = 1, kinetic = kinetic);
        spring back: spring(ground(-10, 0) [m], block.center, stiffness [N/m] = 1, length [m] = 10);
        start { block.center.x [m] = 0; block.center.y [m] = 0; block.center.velocity.x [m/s] = 0.2; }
        output sliding [m/s] = touch.sliding;
        output x [m] = block.center.x;
    }
}

linkwright::mechanism! {
    /// Kane and Levinson's kind of impact: two rods that swing, whose tip strikes a rough floor.
    planar Tipped {
        param grip [1] = 0.5;
        param share [1] = 0.5;
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; surface tip: point(lower.end); }
        surface floor: half_plane(line(ground(0, -1.81) [m], ground(1, -1.81) [m]));
        joint hip: revolute(ground(0, 0) [m], upper.start);
        joint knee: revolute(upper.end, lower.start);
        contact strikes: between(lower.tip, floor) = rigid(restitution = share);
        friction rub: on(strikes) = dry(static = grip);
        start { hip.angle [deg] = -70; knee.angle [deg] = 10; hip.rate [rad/s] = -0.1; knee.rate [rad/s] = -0.1; }
        output height [m] = strikes.gap;
        output sliding [m/s] = strikes.sliding;
        output closing [m/s] = strikes.closing;
    }
}

linkwright::mechanism! {
    /// Painlevé's rod: it slides on its tip, which its friction presses into the floor.
    planar Painleve {
        param grip [1] = 0.3;
        gravity [m/s^2] = (0, -9.81);
        rod rod { mass [kg] = 1; length [m] = 1; surface tip: point(rod.start); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact stands: between(rod.tip, floor) = rigid(restitution = 0);
        friction rub: on(stands) = dry(static = grip);
        start { rod.start.x [m] = 0; rod.start.y [m] = 0; rod.angle [deg] = 120; rod.rate [rad/s] = 0; rod.start.velocity.x [m/s] = 1; rod.start.velocity.y [m/s] = 0; }
        output force [N] = stands.force;
    }
}

linkwright::mechanism! {
    /// A disk that rolls to and fro in a bowl, where what it rolls on turns under it.
    planar Bowl {
        gravity [m/s^2] = (0, -9.81);
        disk wheel { mass [kg] = 2; radius [m] = 0.2; }
        surface bowl: hole(ground(0, 0) [m], radius [m] = 1);
        contact lies: between(wheel.surface, bowl) = rigid(restitution = 0);
        friction rub: on(lies) = dry(static = 0.5);
        start { wheel.center.x = 0.8 [m]*sin(0.7 [rad]); wheel.center.y = -0.8 [m]*cos(0.7 [rad]); wheel.angle [rad] = 0; }
        output angle [rad] = atan2(wheel.center.x, -wheel.center.y);
        output sliding [m/s] = lies.sliding;
        output force [N] = rub.force;
        output pressed [N] = lies.force;
    }
}

linkwright::mechanism! {
    /// The toy for small angles, as it was published: turns do not move what they turn, but for the levers.
    planar Published {
        gravity [m/s^2] = (0, -9.81);
        const pole [m] = 0.0025;
        const bore [m] = 0.0031;
        const half [m] = 0.0058;
        const spring [m] = 0.010;
        const leg [m] = 0.015;
        const high [m] = 0.02;
        const long [m] = 0.0201;
        particle sleeve { mass [kg] = 0.0003; }
        particle bird { mass [kg] = 0.0045; }
        body rock { mass [kg] = 1; inertia [kg*m^2] = 5e-9; }
        body lean { mass [kg] = 1; inertia [kg*m^2] = 7e-7; }
        signal rocked [1] = rock.angle/1 [rad];
        signal leant [1] = lean.angle/1 [rad];
        joint axis: point_on_line(line(ground(0, 0) [m], ground(0, 1) [m]), sleeve.center);
        joint beside: point_on_line(line(ground(0.025, 0) [m], ground(0.025, 1) [m]), bird.center);
        joint first: revolute(ground(0, 0) [m], rock.center);
        joint second: revolute(ground(0, 0) [m], lean.center);
        constraint tied: bird.center.y - sleeve.center.y - spring*rocked - leg*leant = 0;
        shaft steel: shaft(rock, lean, ratio = 1, stiffness [N*m/rad] = 0.0056);
        contact pecks: gap(spring + leg - long - pole - high*leant, slip = sleeve.center.y + spring*rocked + (leg - long)*leant)
            = rigid(restitution = 0.5);
        contact below: gap(bore - pole + half*rocked, slip = sleeve.center.y + bore*rocked) = rigid(restitution = 0);
        contact above: gap(bore - pole - half*rocked, slip = sleeve.center.y + bore*rocked) = rigid(restitution = 0);
        friction stops: on(pecks) = dry(static = 0.3);
        friction jams: on(below) = dry(static = 0.3);
        friction catches: on(above) = dry(static = 0.3);
        start { sleeve.center.y [m] = 0; rock.angle [rad] = -0.1034; lean.angle [rad] = -0.2788; sleeve.center.velocity.y [m/s] = -0.3411;
                rock.rate [rad/s] = 0; lean.rate [rad/s] = -7.4583; }
        output height [m] = sleeve.center.y;
        output rate [m/s] = sleeve.center.velocity.y;
        output bird_angle [rad] = lean.angle;
        output bird_rate [rad/s] = lean.rate;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn block(slope: f64) -> Block {
    Block::prepare(BlockParameters { slope: slope.to_radians() }).expect("a slope")
}

/// With g, μ and α: it stops after v²/(2 g (sin α + μ cos α)), and there it stays where tan α < μ.
#[test]
fn a_block_stops_on_a_slope_and_stays() {
    let model = block(20.0);
    let mut simulation = Simulation::new(&model, Block::START).step(1e-3);
    simulation.advance_until(0.251_117_160_261_027 - 1e-9).expect("it moves");
    close(simulation.state().v[0], 0.0, 1e-7, "speed just before it stops");
    assert!(simulation.state().v[0] > 0.0);
    simulation.advance_until(2.0).expect("it rests");
    let outputs = simulation.sample().outputs;
    close(outputs.x, 0.251_117_160_261_027, 1e-12, "20 degrees: where it stays");
    close(outputs.v, 0.0, 1e-14, "creeping");
    let angle = 20.0_f64.to_radians();
    close(outputs.pressed, 2.0 * 9.81 * angle.cos(), 1e-10, "what presses");
    close(outputs.force, 2.0 * 9.81 * angle.sin(), 1e-10, "what holds");
    // Where both hold the same, both hold alike.
    close(outputs.share, 0.0, 1e-5, "how differently both hold");
    close(
        outputs.friction,
        -2.0 * 9.81 * angle.cos() * 0.5 * 0.251_117_160_261_027,
        1e-9,
        "what friction took",
    );
}

/// Where tan α > μ it slides back.
#[test]
fn a_block_slides_back_down_a_steep_slope() {
    let model = block(30.0);
    let mut methods = [0.0; 4];
    let run = |h: f64| Simulation::new(&model, Block::START).step(h);
    methods[0] = run(1e-3).run_until(1.0, |_| {}).expect("it moves").q[0];
    methods[1] =
        run(1e-3).integrator(DormandPrince::tolerance(1e-11)).run_until(1.0, |_| {}).expect("it moves").q[0];
    methods[2] = run(1e-3).formulation(LagrangeIndex1).run_until(1.0, |_| {}).expect("it moves").q[0];
    methods[3] = run(1e-4).integrator(SemiImplicitEuler).run_until(1.0, |_| {}).expect("it moves").q[0];
    for (found, within) in methods.into_iter().zip([1e-11, 1e-9, 1e-11, 2e-3]) {
        close(found, 0.017_843_517_838_295, within, "30 degrees: where it is after 1 s");
    }
    let state = run(1e-3).run_until(1.0, |_| {}).expect("it moves");
    close(state.v[0], -0.513_551_854_988_346, 1e-11, "and how fast");
}

fn thrown(bounces: f64, grip: f64) -> Thrown {
    Thrown::prepare(ThrownParameters { bounces, grip }).expect("a disk")
}

/// A disk rolls from t = v/(3 μ g) on, with 2/3 v.
#[test]
fn a_disk_slides_until_it_rolls() {
    let model = thrown(0.0, 0.2);
    let mut simulation = Simulation::new(&model, Thrown::START).integrator(Rk4).step(1e-3);
    simulation.advance_until(0.509_683_995_922_528 + 1e-12).expect("it moves");
    close(simulation.state().q[0], 1.274_209_989_806_32, 1e-10, "where it begins to roll");
    let mut turned = 0;
    while simulation.time() < 1.0 {
        turned += simulation.advance().expect("it rolls").gates_changed;
    }
    let sample = simulation.sample();
    close(sample.state.v[0], 2.0, 1e-11, "speed");
    close(sample.outputs.sliding, 0.0, 1e-14, "sliding");
    close(sample.outputs.force, 0.0, 1e-11, "force where it rolls");
    assert!(turned <= 1, "{turned} changes where it rolls");
}

/// A disk falls with spin ω: P_N = (1 + e) m v_y; it slips through the touch with μ P_N, or sticks with m r ω/3.
#[test]
fn a_spinning_disk_slips_or_sticks_in_a_touch() {
    for (spin, grip) in [(-40.0, 0.1), (-40.0, 0.6), (15.0, 0.1), (2.0, 0.6)] {
        for bounces in [0.0, 0.6] {
            let model = thrown(bounces, grip);
            let (mass, radius, fall) = (2.0, 0.1, 0.5_f64);
            let mut start = Thrown::START;
            (start.q[1], start.v[0]) = (radius + fall, 0.0);
            start.v[2] = spin;
            let mut simulation = Simulation::new(&model, start).step(1e-3);
            let mut step = simulation.advance().expect("it falls");
            while step.impacts == 0 {
                step = simulation.advance().expect("it falls");
            }
            let speed = (2.0 * 9.81 * fall).sqrt();
            let pressed = (1.0 + bounces) * mass * speed;
            // v_t = v_x + r ω for a disk above its road; G_t = 3/m.
            let stopped = -mass * radius * spin / 3.0;
            let along = stopped.clamp(-grip * pressed, grip * pressed);
            let after = [along / mass, spin + along * radius / (0.5 * mass * radius * radius)];
            let name = format!("spin {spin}, friction {grip}, restitution {bounces}");
            if bounces > 0.0 {
                close(simulation.state().v[0], after[0], 1e-11, &format!("{name}: speed"));
                close(simulation.state().v[2], after[1], 1e-10, &format!("{name}: spin"));
            }
            let energy = |v: [f64; 3]| {
                0.5 * mass * (v[0] * v[0] + v[1] * v[1]) + 0.25 * mass * radius * radius * v[2] * v[2]
            };
            let lost = energy([0.0, speed, spin]) - energy([after[0], bounces * speed, after[1]]);
            close(step.lost, lost, 1e-7, &format!("{name}: lost"));
            assert_eq!(step.gained, 0.0);
        }
    }
}

/// The belt of the sources: a slip takes π + 2 atan(0.4), what sticks 5 s.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    let model = Carried::default();
    let mut simulation = Simulation::new(&model, Carried::START).step(1e-3);
    let slip = core::f64::consts::PI + 2.0 * 0.4_f64.atan();
    let mut begins = 5.0;
    for turn in 0..3 {
        for (time, slides) in [
            (begins - 1e-6, false),
            (begins + 1e-3, true),
            (begins + slip - 1e-3, true),
            (begins + slip + 1e-6, false),
        ] {
            simulation.advance_until(time).expect("it moves");
            let sliding = simulation.sample().outputs.sliding;
            println!("turn {turn}, {time} s: {sliding:e}");
            assert_eq!(sliding < -1e-5, slides, "turn {turn}, {time} s: {sliding}");
            assert!(slides || sliding.abs() < 1e-12, "turn {turn}, {time} s: {sliding}");
        }
        // Where it sticks again is where the spring pulls with 2·0.5 − 1 = 0 N.
        close(simulation.sample().outputs.x, 0.2e-6, 1e-8, "where it sticks again");
        begins += slip + 5.0;
    }
    close(begins, 5.0 + 3.0 * 8.902_605_407_814_52, 1e-12, "period");
}

/// A block on a belt without friction once it slides swings as its spring lets it: x = cos t + 0.2 sin t from where it was torn off.
#[test]
fn nothing_may_slide() {
    let model = Carried::prepare(CarriedParameters { kinetic: 0.0 }).expect("a belt");
    let mut simulation = Simulation::new(&model, Carried::START).step(1e-3);
    simulation.advance_until(5.0 + 1.0).expect("it moves");
    let (x, v) = (1.0_f64, 0.2_f64);
    let expected = x * 1.0_f64.cos() + v * 1.0_f64.sin();
    close(simulation.sample().outputs.x, expected, 1e-9, "where it swings");
}

/// Rolling in a bowl of radius R it swings as a pendulum of length 3/2 (R − r), held by a third of its weight along the slope: as well as
/// the method is, and in coarse steps without a slip.
#[test]
fn a_disk_rolls_in_a_bowl() {
    let model = Bowl::default();
    let pendulum = |mut angle: f64, mut rate: f64, time: f64| {
        let (steps, pull) = (20_000, 9.81 / (1.5 * 0.8));
        let h = time / f64::from(steps);
        for _ in 0..steps {
            // Velocity Verlet; its error is far below what is asked for.
            rate -= 0.5 * h * pull * angle.sin();
            angle += h * rate;
            rate -= 0.5 * h * pull * angle.sin();
        }
        (angle, rate)
    };
    let (angle, rate) = pendulum(0.7, 0.0, 2.0);
    for (h, within) in [(1e-3, 1e-8_f64), (2e-2, 2e-4)] {
        let mut simulation = Simulation::new(&model, Bowl::START).step(h);
        let mut changed = 0;
        while simulation.time() < 2.0 - 1e-9 {
            changed += simulation.advance().expect("it rolls").gates_changed;
            assert!(
                simulation.sample().outputs.sliding.abs() < 1e-6 * within.sqrt(),
                "at {} s",
                simulation.time()
            );
        }
        let outputs = simulation.sample().outputs;
        close(outputs.angle, angle, within, "where it has rolled");
        close(outputs.force.abs(), 2.0 * 9.81 * angle.sin().abs() / 3.0, 20.0 * within, "what holds it");
        let pressed = 2.0 * (9.81 * angle.cos() + 0.8 * rate * rate);
        close(outputs.pressed, pressed, 100.0 * within, "what presses it");
        assert_eq!(changed, 1, "it slipped");
    }
}

/// Newton's law may give energy beside friction, and says how much; Poisson's does not. Both keep to their equations.
#[test]
fn energy_from_a_touch_is_told() {
    let (mut gained, mut touches) = (0, 0);
    let by_impulses =
        Tipped::<f64>::SOURCE.replace("output height", "options { impact = poisson; } output height");
    let by_impulses: Engine = Engine::read(&by_impulses).expect("rods");
    for grip in [0.0, 0.2, 0.5, 0.8, 1.2] {
        for share in [0.3, 0.7, 0.9] {
            for rates in [[-0.1, -0.2], [-0.3, -0.1], [0.1, -0.4], [-0.5, 0.2]] {
                let model = Tipped::prepare(TippedParameters { grip, share }).expect("rods");
                let mut start = Tipped::START;
                start.v = rates;
                let mut simulation = Simulation::new(&model, start).step(1e-4);
                let (mut before, mut energy) = (simulation.sample().outputs, simulation.energy());
                let other = by_impulses.prepared(&[grip, share]).expect("rods");
                let mut start = other.start();
                start.v.as_mut_slice().copy_from_slice(&rates);
                let mut same = Simulation::new(&other, start).constant(other.no_inputs()).step(1e-4);
                let mut other = None;
                while other.is_none() && same.time() < 0.5 {
                    let step = same.advance().expect("it swings");
                    other = (step.impacts > 0).then_some(step);
                }
                while simulation.time() < 0.5 {
                    let step = match simulation.advance() {
                        Ok(step) => step,
                        Err(error) => panic!("{grip}, {share}, {rates:?}: {error}"),
                    };
                    if step.impacts == 0 {
                        (before, energy) = (simulation.sample().outputs, simulation.energy());
                        continue;
                    }
                    let change = simulation.energy() - energy;
                    close(change, step.gained - step.lost, 1e-9, "energy");
                    let after = simulation.sample().outputs;
                    close(
                        -after.closing,
                        share * before.closing,
                        1e-2 * before.closing.abs().max(0.1),
                        "restitution",
                    );
                    assert!(step.gained == 0.0 || step.lost == 0.0);
                    gained += u32::from(step.gained > 1e-4);
                    touches += 1;
                    let other = other.expect("it touches");
                    close(other.gained, 0.0, 1e-12, "gained by Poisson's law");
                    assert!(grip > 0.0 || (other.lost - step.lost).abs() < 1e-9, "{other:?} {step:?}");
                    break;
                }
            }
        }
    }
    println!("{touches} touches, {gained} gained energy by Newton's law");
    assert!(touches >= 30 && gained >= 5, "{touches} touches, {gained} gained");
}

/// A rod at θ to the floor slides on its tip: N = m g/(1 + 3 cos θ (cos θ + μ sin θ)), which has no solution below zero.
#[test]
fn a_rod_that_jams_is_an_error() {
    let model = Painleve::prepare(PainleveParameters { grip: 0.3 }).expect("a rod");
    let mut simulation = Simulation::new(&model, Painleve::START).step(1e-5);
    simulation.advance().expect("it slides");
    let (sin, cos) = (120.0_f64.to_radians().sin(), 120.0_f64.to_radians().cos());
    // With m = l = 1 the tip slides with σ = 1: ÿ = N (1 + 3 cos² θ) + 3 μ N sin θ cos θ − g at rest.
    let pressed = 9.81 / (1.0 + 3.0 * cos * (cos + 0.3 * sin));
    close(simulation.sample().outputs.force, pressed, 1e-3, "what presses the tip");
    let model = Painleve::prepare(PainleveParameters { grip: 3.0 }).expect("a rod");
    let error =
        Simulation::new(&model, Painleve::START).step(1e-4).run_until(0.1, |_| {}).expect_err("it jams");
    println!("{error}");
    assert!(matches!(error, SimulationError::NoImpact { contact: "stands", .. }), "{error:?}");
    assert!(error.to_string().contains("dry friction jams"), "{error}");
}

/// Where the angle of the bird passes −0.2788 on its way down the sleeve slides with what was published; the cycle repeats itself.
#[test]
fn a_woodpecker_pecks_its_way_down() {
    let model = Published::default();
    let mut simulation = Simulation::new(&model, Published::START).step(1e-4);
    let (mut cycles, mut last) = (Vec::new(), (0.0, 0.0));
    let level = linkwright::Event::of("bird_angle").level(-0.2788).falling().tolerance(1e-12);
    while cycles.len() < 8 {
        simulation.run_until_event(5.0, &[level], |_| {}).expect("it pecks").expect("it goes on");
        let outputs = simulation.sample().outputs;
        cycles.push([simulation.time() - last.0, last.1 - outputs.height, outputs.rate, outputs.bird_rate]);
        last = (simulation.time(), outputs.height);
    }
    let [period, height, rate, bird_rate] = limit(&cycles);
    println!("small angles: {period} s a cycle, {height} m down, {rate} m/s, {bird_rate} rad/s");
    close(rate, -0.3411, 2e-3, "the sleeve's speed, as it was published");
    close(bird_rate, -7.4583, 6e-3, "the bird's rate, as it was published");
    close(period, 0.145_975, 2e-6, "its period");
    for h in [1e-4, 4e-5] {
        let model = Woodpecker::default();
        let mut simulation = Simulation::new(&model, Woodpecker::START).step(h);
        let (mut cycles, mut last) = (Vec::new(), (0.0, 0.0));
        while cycles.len() < 9 {
            simulation.run_until_event(5.0, &[level], |_| {}).expect("it pecks").expect("it goes on");
            let outputs = simulation.sample().outputs;
            cycles.push([
                simulation.time() - last.0,
                last.1 - outputs.height,
                outputs.rate,
                outputs.bird_rate,
            ]);
            last = (simulation.time(), outputs.height);
        }
        let [period, height, rate, bird_rate] = limit(&cycles);
        close(period, 0.130_747_525_0, 4e-9, "the period of what turns");
        close(height, 0.014_496_911_1, 3e-9, "how far it comes down");
        close(rate, -0.278_693_596, 3e-8, "the sleeve's speed");
        close(bird_rate, -8.145_936_67, 5e-7, "the bird's rate");
    }
}

/// Where a sequence leads that comes nearer by the same part each time, by its last three members (Aitken).
fn limit(cycles: &[[f64; 4]]) -> [f64; 4] {
    let [.., a, b, c] = cycles else { panic!("three cycles") };
    core::array::from_fn(|k| {
        let (first, second) = (b[k] - a[k], c[k] - b[k]);
        c[k] - second * second / (second - first)
    })
}
