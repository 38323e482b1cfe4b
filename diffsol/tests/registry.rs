//! Shipped mechanisms of every kind under diffsol's explicit and implicit solvers against Linkwright's RK4, over a short time.

use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Simulation, Vector};
use linkwright_diffsol::{Error, Method, Settings, StateOf, problem, solve};

const END: f64 = 0.005;

/// Both inputs are zero; positions agree to the tolerance, velocities relative to the largest.
fn moves_alike<M: Assemble<f64>>(name: &str, model: &M)
where
    M::Inputs: Fields<f64>,
{
    let start = model.start();
    let inputs = |_: f64, _: &StateOf<M>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    // Steel on steel, whose vibrations are shorter than what suits the others.
    let is_stiff =
        ["loose_wrist", "planetary_stage", "planetary_stage_held", "princeton_beam"].contains(&name);
    let h = if is_stiff { 5e-7 } else { 1e-5 };
    // Teeth between grams vibrate at 55 kHz, short strips at tens of them: errors of the tolerance add up over some periods only.
    let is_fast = name.starts_with("planetary_stage") || name == "princeton_beam";
    let end = if is_fast { END / 50.0 } else { END };
    let mut simulation = Simulation::new(model, start.clone()).formulation(baumgarte).sampled(inputs).step(h);
    let expected = simulation.advance_until(end).unwrap_or_else(|error| panic!("{name}: {error}"));
    let settings = Settings { relative: 1e-8, absolute: 1e-8, baumgarte, ..Settings::default() };
    if model.is_rigid() {
        let refused = problem(model, 0.0, &start, inputs, &settings).err();
        assert!(matches!(refused, Some(Error::RigidContact { .. })), "{name}: {refused:?}");
        return;
    }
    let problem =
        problem(model, 0.0, &start, inputs, &settings).unwrap_or_else(|error| panic!("{name}: {error}"));
    for method in [Method::Tsit45, Method::Bdf] {
        let states = solve(&problem, method, &[end]);
        let found = states.unwrap_or_else(|error| panic!("{name} {method:?}: {error}")).remove(0);
        let position = found.q.plus(-1.0, &expected.q).max_abs();
        let velocity = found.v.plus(-1.0, &expected.v).max_abs() / (1.0 + expected.v.max_abs());
        println!("{name} {method:?}: {position:.1e} {velocity:.1e}");
        assert!(position < 1e-6 && velocity < 1e-6, "{name} {method:?}: {position:.1e} {velocity:.1e}");
    }
}

macro_rules! all {
    ($($name:ident: $model:path),* $(,)?) => {
        $(#[test] fn $name() {
            moves_alike(stringify!($name), &<$model>::default());
        })*
    };
}

all! {
    simple_pendulum: linkwright_models::simple_pendulum::SimplePendulum,
    four_bar: linkwright_models::four_bar::FourBar,
    n_four_bar_2: linkwright_models::n_four_bar::NFourBar2,
    slider_crank: linkwright_models::slider_crank::SliderCrank,
    andrews: linkwright_models::andrews::Andrews,
    planetary_gear_train: linkwright_models::planetary_gear_train::PlanetaryGearTrain,
    car_axis: linkwright_models::car_axis::CarAxis,
    light_cart_pole: linkwright_models::light_cart_pole::LightCartPole,
    heavy_top: linkwright_models::heavy_top::HeavyTop,
    screw_pendulum: linkwright_models::spatial_pendulums::ScrewPendulum,
    constant_velocity_pendulum: linkwright_models::spatial_pendulums::ConstantVelocityPendulum,
    point_on_line_pendulum: linkwright_models::spatial_pendulums::PointOnLinePendulum,
    bricard: linkwright_models::bricard::Bricard,
    flyball_governor: linkwright_models::flyball_governor::FlyballGovernor,
    panda: linkwright_models::panda::Panda,
    stewart_platform: linkwright_models::stewart_platform::StewartPlatform,
    cable_robot: linkwright_models::cable_robot::CableRobot,
    dc_motor_arm: linkwright_models::dc_motor_arm::DcMotorArm,
    lugre_block: linkwright_models::lugre_block::LugreBlock,
    stick_slip: linkwright_models::stick_slip::StickSlip,
    cam_follower: linkwright_models::cam_follower::CamFollower,
    geared_shafts: linkwright_models::geared_shafts::GearedShafts,
    planetary_stage: linkwright_models::planetary_stage::PlanetaryStage,
    elastic_motor_gear_load: linkwright_models::motor_gear_load::ElasticMotorGearLoad,
    hydraulic_loader: linkwright_models::knuckle_boom_loader::HydraulicLoader,
    bouncing_ball: linkwright_models::bouncing_ball::BouncingBall,
    hammer_at_rigid_wall: linkwright_models::hammer_at_rigid_wall::HammerAtRigidWall,
    loose_wrist: linkwright_models::loose_wrist::LooseWrist,
    flexible_quick_return: linkwright_models::flexible_quick_return::FlexibleQuickReturn,
    spin_up: linkwright_models::spinning_beam::SpinUp,
    princeton_beam: linkwright_models::princeton_beam::PrincetonBeam,
    rubbing_four_bar: linkwright_models::rubbing_four_bar::RubbingFourBar,
    penalty_chain: linkwright_models::penalty_chain::PenaltyChain,
}
