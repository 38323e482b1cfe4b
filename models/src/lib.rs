//! Mechanisms that ship with Linkwright: textbook systems and published benchmarks, one file each, with source, data
//! and expected result.
#![no_std]
#![warn(missing_docs)]

pub mod andrews;
pub mod ball_between_walls;
pub mod bouncing_ball;
pub mod braked_wheel;
pub mod bricard;
pub mod cable_robot;
pub mod cam_follower;
pub mod cam_lift_off;
pub mod car_axis;
pub mod change_point_four_bar;
pub mod dc_motor_arm;
pub mod delta_robot;
pub mod double_pendulum;
pub mod double_wishbone;
pub mod dump_truck_steering;
pub mod dump_truck_tipping;
pub mod falling_cross;
pub mod flexible_arm;
pub mod flexible_pendulum;
pub mod flexible_quick_return;
pub mod flexible_slider_crank;
pub mod flyball_governor;
pub mod four_bar;
pub mod four_spherical_joints;
pub mod free_rigid_body;
pub mod gear_pair;
pub mod geared_shafts;
pub mod general_four_bar;
pub mod hammer_at_rigid_wall;
pub mod hammer_at_wall;
pub mod heavy_top;
pub mod held_block;
pub mod iiwa14;
pub mod jansen_leg;
pub mod klann_leg;
pub mod knuckle_boom_loader;
pub mod laval_rotor;
pub mod light_cart_pole;
pub mod loose_wrist;
pub mod lugre_block;
pub mod motor_gear_load;
pub mod n_four_bar;
pub mod panda;
pub mod penalty_chain;
pub mod planetary_gear_train;
pub mod planetary_stage;
pub mod princeton_beam;
pub mod quick_return;
pub mod rear_wheel;
pub mod rimless_wheel;
pub mod rod_on_pin;
pub mod rolling;
pub mod rubbing_block;
pub mod rubbing_four_bar;
pub mod sarrus_linkage;
pub mod simple_pendulum;
pub mod slider_crank;
pub mod slider_crank_on_stop;
pub mod spatial_four_bar;
pub mod spatial_pendulums;
pub mod spatial_slider_crank;
pub mod spinning_beam;
pub mod stewart_platform;
pub mod stick_slip;
pub mod toothed_gears;
pub mod tracked_vehicle;
pub mod tree_pendulum;
pub mod vehicle_on_pans;
pub mod woodpecker;
pub mod yaw_drive;

/// Calls a macro with every shipped model, `name: path::to::Type`, so that no test forgets one.
///
/// ```text
/// macro_rules! names { ($($name:ident: $model:path),* $(,)?) => { [$(stringify!($name)),*] } }
/// let names = linkwright_models::for_each_model!(names);
/// ```
#[macro_export]
macro_rules! for_each_model {
    ($callback:ident) => {
        $callback! {
            simple_pendulum: $crate::simple_pendulum::SimplePendulum,
            double_pendulum: $crate::double_pendulum::DoublePendulum,
            four_bar: $crate::four_bar::FourBar,
            general_four_bar: $crate::general_four_bar::GeneralFourBar,
            parametric_four_bar: $crate::general_four_bar::ParametricFourBar,
            n_four_bar_2: $crate::n_four_bar::NFourBar2,
            n_four_bar_10: $crate::n_four_bar::NFourBar10,
            n_four_bar_40: $crate::n_four_bar::NFourBar40,
            change_point_four_bar: $crate::change_point_four_bar::ChangePointFourBar,
            slider_crank: $crate::slider_crank::SliderCrank,
            quick_return: $crate::quick_return::QuickReturn,
            andrews: $crate::andrews::Andrews,
            andrews_iftomm: $crate::andrews::AndrewsIftomm,
            planetary_gear_train: $crate::planetary_gear_train::PlanetaryGearTrain,
            jansen_leg: $crate::jansen_leg::JansenLeg,
            klann_leg: $crate::klann_leg::KlannLeg,
            car_axis: $crate::car_axis::CarAxis,
            tree_pendulum: $crate::tree_pendulum::TreePendulum,
            light_cart_pole: $crate::light_cart_pole::LightCartPole,
            heavy_top: $crate::heavy_top::HeavyTop,
            free_rigid_body: $crate::free_rigid_body::FreeRigidBody,
            revolute_pendulum: $crate::spatial_pendulums::RevolutePendulum,
            spherical_pendulum: $crate::spatial_pendulums::SphericalPendulum,
            vertical_cylindrical_pendulum: $crate::spatial_pendulums::VerticalCylindricalPendulum,
            cylindrical_pendulum: $crate::spatial_pendulums::CylindricalPendulum,
            prismatic_pendulum: $crate::spatial_pendulums::PrismaticPendulum,
            universal_pendulum: $crate::spatial_pendulums::UniversalPendulum,
            distance_pendulum: $crate::spatial_pendulums::DistancePendulum,
            screw_pendulum: $crate::spatial_pendulums::ScrewPendulum,
            planar_pendulum: $crate::spatial_pendulums::PlanarPendulum,
            constant_velocity_pendulum: $crate::spatial_pendulums::ConstantVelocityPendulum,
            point_on_line_pendulum: $crate::spatial_pendulums::PointOnLinePendulum,
            point_on_plane_pendulum: $crate::spatial_pendulums::PointOnPlanePendulum,
            four_spherical_joints: $crate::four_spherical_joints::FourSphericalJoints,
            spatial_slider_crank_axial: $crate::spatial_slider_crank::SpatialSliderCrankAxial,
            spatial_slider_crank_arm: $crate::spatial_slider_crank::SpatialSliderCrankArm,
            spatial_slider_crank_third: $crate::spatial_slider_crank::SpatialSliderCrankThird,
            spatial_slider_crank_balanced: $crate::spatial_slider_crank::SpatialSliderCrankBalanced,
            fourbar_1: $crate::spatial_four_bar::Fourbar1,
            fourbar_2: $crate::spatial_four_bar::Fourbar2,
            bricard: $crate::bricard::Bricard,
            sarrus_linkage: $crate::sarrus_linkage::SarrusLinkage,
            flyball_governor: $crate::flyball_governor::FlyballGovernor,
            iiwa14: $crate::iiwa14::Iiwa14,
            iiwa14_parametric: $crate::iiwa14::Iiwa14Parametric,
            panda: $crate::panda::Panda,
            stewart_platform: $crate::stewart_platform::StewartPlatform,
            delta_robot: $crate::delta_robot::DeltaRobot,
            double_wishbone: $crate::double_wishbone::DoubleWishbone,
            cable_robot: $crate::cable_robot::CableRobot,
            cable_robot_from_rest: $crate::cable_robot::CableRobotFromRest,
            elastic_cable_robot: $crate::cable_robot::ElasticCableRobot,
            dc_motor_arm: $crate::dc_motor_arm::DcMotorArm,
            braked_wheel: $crate::braked_wheel::BrakedWheel,
            lugre_block: $crate::lugre_block::LugreBlock,
            held_block: $crate::held_block::HeldBlock,
            stick_slip: $crate::stick_slip::StickSlip,
            rear_wheel: $crate::rear_wheel::RearWheel,
            cam_follower: $crate::cam_follower::CamFollower,
            cam_lift_off: $crate::cam_lift_off::CamLiftOff,
            geared_shafts: $crate::geared_shafts::GearedShafts,
            tracked_vehicle: $crate::tracked_vehicle::TrackedVehicle,
            vehicle_on_pans: $crate::vehicle_on_pans::VehicleOnPans,
            toothed_planetary_set: $crate::toothed_gears::ToothedPlanetarySet,
            planetary_stage_held: $crate::planetary_stage::PlanetaryStageHeld,
            planetary_stage: $crate::planetary_stage::PlanetaryStage,
            gear_pair_oscillator: $crate::gear_pair::GearPairOscillator,
            gear_pair: $crate::gear_pair::GearPair,
            compound_train: $crate::toothed_gears::CompoundTrain,
            rack_and_pinion: $crate::toothed_gears::RackAndPinion,
            bevel_pair: $crate::toothed_gears::BevelPair,
            worm_drive: $crate::toothed_gears::WormDrive,
            clutched_differential: $crate::toothed_gears::ClutchedDifferential,
            yaw_drive: $crate::yaw_drive::YawDrive,
            motor_gear_load: $crate::motor_gear_load::MotorGearLoad,
            elastic_motor_gear_load: $crate::motor_gear_load::ElasticMotorGearLoad,
            knuckle_boom_loader: $crate::knuckle_boom_loader::KnuckleBoomLoader,
            hydraulic_loader: $crate::knuckle_boom_loader::HydraulicLoader,
            dump_truck_steering: $crate::dump_truck_steering::DumpTruckSteering,
            dump_truck_tipping: $crate::dump_truck_tipping::DumpTruckTipping,
            bouncing_ball: $crate::bouncing_ball::BouncingBall,
            bouncing_ball_of_hunt_and_crossley: $crate::bouncing_ball::BouncingBallOfHuntAndCrossley,
            falling_cross: $crate::falling_cross::FallingCross,
            hammer_at_wall: $crate::hammer_at_wall::HammerAtWall,
            loose_wrist: $crate::loose_wrist::LooseWrist,
            ball_between_walls: $crate::ball_between_walls::BallBetweenWalls,
            hammer_at_rigid_wall: $crate::hammer_at_rigid_wall::HammerAtRigidWall,
            slider_crank_on_stop: $crate::slider_crank_on_stop::SliderCrankOnStop,
            rimless_wheel: $crate::rimless_wheel::RimlessWheel,
            woodpecker: $crate::woodpecker::Woodpecker,
            flexible_pendulum: $crate::flexible_pendulum::FlexiblePendulum,
            hinged_bar: $crate::flexible_pendulum::HingedBar,
            hinged_bar_of_one: $crate::flexible_pendulum::HingedBarOfOne,
            hinged_bar_of_five: $crate::flexible_pendulum::HingedBarOfFive,
            hinged_bar_of_sines: $crate::flexible_pendulum::HingedBarOfSines,
            flexible_quick_return: $crate::flexible_quick_return::FlexibleQuickReturn,
            flexible_slider_crank: $crate::flexible_slider_crank::FlexibleSliderCrank,
            spin_up: $crate::spinning_beam::SpinUp,
            spin_up_without_stiffening: $crate::spinning_beam::SpinUpWithoutStiffening,
            flexible_arm: $crate::flexible_arm::FlexibleArm,
            laval_rotor: $crate::laval_rotor::LavalRotor,
            princeton_beam: $crate::princeton_beam::PrincetonBeam,
            rod_on_pin: $crate::rod_on_pin::RodOnPin,
            rubbing_four_bar: $crate::rubbing_four_bar::RubbingFourBar,
            rubbing_four_bars: $crate::rubbing_four_bar::RubbingFourBars,
            sliding_disk: $crate::rolling::SlidingDisk,
            sliding_ball: $crate::rolling::SlidingBall,
            penalty_chain: $crate::penalty_chain::PenaltyChain,
            rubbing_block: $crate::rubbing_block::RubbingBlock,
            stribeck_brake: $crate::rubbing_block::StribeckBrake,
        }
    };
}
