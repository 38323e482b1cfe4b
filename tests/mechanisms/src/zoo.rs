//! Mechanisms that ship with nobody: together they have every kind of body, joint, coupling, load and driver, in the
//! combinations that shipped models avoid. Every generic check runs on them too. Those in space are in `zoo_space.rs`.

use crate::registry::model;

linkwright::mechanism! {
    /// Slots, welds, particles, struts, springs with dampers: a quick return that somebody has hung things on.
    pub planar Workshop {
        param rate [N/m] = 40 in 1..100;
        param loss [N*s/m] = 0.7;
        param offset [m] = 0.01;
        input push [N];
        gravity [m/s^2] = (0.4, -9.81);
        body crank  { mass [kg] = 0.4; inertia [kg*m^2] = 0.02; center [m] = (0.03, offset);
                      point pivot [m] = (-0.1, 0.01); point tip [m] = (0.15, 0); }
        body guide  { mass [kg] = 0.6; inertia [kg*m^2] = 0.03; point pivot [m] = (-0.4, 0); point tip [m] = (0.4, 0.02);
                      line slot = (guide.pivot, guide.tip); }
        rod coupler { mass [kg] = 0; inertia [kg*m^2] = 0; length [m] = 0.7; }
        box slider  { mass [kg] = 2; width [m] = 0.1; height [m] = 0.05; }
        disk plate  { mass [kg] = 0.3; radius [m] = 0.05; point side [m] = (0.02, -0.03); }
        particle bead { mass [kg] = 0.25; }
        disk bob    { mass [kg] = 0.5; radius [cm] = 4; }

        joint crank_pin: revolute(ground(0, 0) [m], crank.pivot);
        joint guide_pin: revolute(guide.pivot, ground(0, -0.3) [m]);
        joint block:     point_on_line(guide.slot, crank.tip);
        joint knee:      revolute(guide.tip, coupler.end);
        joint wrist:     revolute(coupler.start, slider.center);
        joint rail:      prismatic(ground(0, 0.5) [m], slider.center, axis = (4, 1), angle = 10 [deg]);
        joint weld:      fixed(plate.side, slider.origin, angle = -0.3 [rad]);
        joint ride:      point_on_line(guide.slot, bead.center);
        joint strut:     distance(plate.center, bob.center, length = 0.35 [m]);

        spring rope:   spring(ground(-0.5, 0.1) [m], bead.center, stiffness = rate, length = 0.3 [m], damping = loss);
        damper shock:  damper(crank.tip, bob.center, damping = 2 [N*s/m]);
        torsion_spring hinge: torsion_spring(knee, stiffness = 3 [N*m/rad], angle = 0.2 [rad], damping = 0.1 [N*m*s/rad]);
        force wind:    force(bob.center) = (push, -0.1 [N*s/m] * bob.center.velocity.y);
        torque brake:  torque(guide) = -0.05 [N*m*s/rad] * guide.rate;

        start { crank_pin.angle [rad] = 1; crank_pin.rate [rad/s] = 4; guide_pin.angle [rad] ~ -1;
                coupler.angle [rad] ~ 0; ride.travel [m] = 0.5; ride.speed [m/s] = 0.1;
                bob.center.x [m] ~ -0.5; bob.center.y [m] ~ 0; }
        options { emit = (penalty, projection); }
        output loss_power [W] = power(shock) + power(brake);
        output gap [m] = distance(plate.center, bob.center);
        output ride_travel [m] = ride.travel;
    }
}

linkwright::mechanism! {
    /// A pinion drives a rack and, through a gear, a wheel on a swinging arm; an equation ties a flap to them.
    pub planar Gears {
        param radius [m] = 0.05;
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        disk pinion { mass [kg] = 1; radius [m] = 0.05; }
        body rail   { mass [kg] = 0.8; inertia [kg*m^2] = 0.01; point side [m] = (0, 0.02); }
        rod arm     { mass [kg] = 0.5; length [m] = 0.12; }
        disk wheel  { mass [kg] = 0.6; radius [m] = 0.07; }
        body flap   { mass [kg] = 0.2; inertia [kg*m^2] = 0.002; center [m] = (0.02, 0.01); }
        joint axle:     revolute(ground(0, 0) [m], pinion.center);
        joint slide:    prismatic(ground(0, -0.05) [m], rail.side, axis = (2, 0));
        joint arm_pin:  revolute(ground(0, 0) [m], arm.start);
        joint wheel_pin: revolute(arm.end, wheel.center);
        joint flap_pin: revolute(arm.end, flap.origin);
        rack mesh:  rack(axle, slide, radius = radius);
        gear teeth: gear(wheel_pin, axle, ratio = -5/7);
        constraint tie: flap_pin.angle - 0.5 [rad] * sin(axle.angle) - 0.1 [rad] * cos(2 [rad/s] * time) = 0;
        torsion_spring coil: torsion_spring(axle, stiffness = 0.3 [N*m/rad]);
        torque motor: torque(axle) = drive;
        spring tension: spring(ground(1, 0) [m], rail.side, stiffness = 20 [N/m], length = 0.4 [m]);
        start { axle.angle [rad] = 0; axle.rate [rad/s] = 30; arm_pin.angle [deg] = -60; arm_pin.rate [rad/s] = 0.5; }
        output turned [rad] = axle.angle;
        output wheel_turned [rad] = wheel_pin.angle;
        output flapped [rad] = flap_pin.angle;
    }
}

linkwright::mechanism! {
    /// Two drivers and a support that shakes: time in the positions, the rows, the loads.
    pub planar Shaken {
        param stroke [m] = 0.1;
        gravity [m/s^2] = (0, -9.81);
        rod upper { mass [kg] = 1; length [m] = 0.8; }
        body lower { mass [kg] = 0.7; inertia [kg*m^2] = 0.02; center [m] = (0.25, 0.02); }
        body sled { mass [kg] = 0.4; inertia [kg*m^2] = 0.01; }
        joint shoulder: revolute(ground(stroke * sin(3 [rad/s] * time), 0.05 [m] * cos(2 [rad/s] * time)), upper.start);
        joint elbow:    revolute(upper.end, lower.origin);
        joint track:    prismatic(lower.origin, sled.center, axis = (1, 0.2), angle = 0.4 [rad]);
        drive swing: shoulder.angle = 0.3 [rad] * sin(4 [rad/s] * time) - 1 [rad];
        drive shuttle: track.travel = 0.2 [m] + 0.05 [m/s] * time;
        start { elbow.angle [rad] = 0.3; elbow.rate [rad/s] = -1; }
        expect { degrees_of_freedom = 3; }
        output torque [N*m] = swing.effort;
        output driving [W] = swing.power + shuttle.power;
    }
}

linkwright::mechanism! {
    /// Two bodies and a hinge that float; a torque between them.
    pub planar Floating {
        input drive [N*m];
        body hub { mass [kg] = 3; inertia [kg*m^2] = 0.2; point hinge [m] = (0.3, 0.1); }
        rod arm  { mass [kg] = 1; length [m] = 1.2; }
        joint hinge: revolute(hub.hinge, arm.start);
        torsion_spring coil: torsion_spring(hinge, stiffness = 2 [N*m/rad], damping = 0.1 [N*m*s/rad]);
        torque motor: torque(hinge) = drive;
        start { hub.center.x [m] = 0.2; hub.center.y [m] = -0.1; hub.angle [rad] = 0.4; hinge.angle [rad] = 1;
                hub.center.velocity.x [m/s] = 0.3; hub.center.velocity.y [m/s] = -0.2; hub.rate [rad/s] = 1; hinge.rate [rad/s] = -3; }
        expect { degrees_of_freedom = 4; }
    }
}

linkwright::mechanism! {
    /// Parallels in both orders of their places, carrying and cut: a cross-slide on a swing, a coupling of Oldham between two wheels.
    pub planar Oldham {
        param lead [m] = 0.02;
        input drive [N*m];
        gravity [m/s^2] = (0.3, -9.81);
        body swing { mass [kg] = 0.8; inertia [kg*m^2] = 0.02; center [m] = (0.1, 0.05); point pivot [m] = (-0.2, lead);
                     point seat [m] = (0.15, -0.04); }
        body rider { mass [kg] = 0.5; inertia [kg*m^2] = 0.01; center [m] = (0.03, -0.02); point foot [m] = (0.05, 0.1); }
        body cargo { mass [kg] = 0.3; inertia [kg*m^2] = 0.004; center [m] = (-0.02, 0.01); point hook [m] = (0.02, 0.06); }
        disk left  { mass [kg] = 0.6; radius [m] = 0.1; point face [m] = (0.01, 0.02); }
        disk right { mass [kg] = 0.7; radius [m] = 0.12; point face [m] = (-0.02, 0.01); }

        joint hinge:  revolute(ground(0, 0) [m], swing.pivot);
        joint cross:  parallel(swing.seat, rider.foot);
        joint table:  parallel(cargo.hook, rider.foot);
        joint axle:   revolute(ground(1, 0) [m], left.center);
        joint offset: revolute(ground(1 [m], lead), right.center);
        joint disc:   parallel(left.face, right.face);

        spring tie:  spring(ground(0.4, 0.6) [m], rider.center, stiffness = 60 [N/m], length = 0.2 [m], damping = 0.5 [N*s/m]);
        spring rope: spring(rider.foot, cargo.hook, stiffness = 40 [N/m], length = 0.1 [m], damping = 0.2 [N*s/m]);
        force push:  force(cargo.center) = (-0.4 [N*s/m] * cross.speed_1, 2 [N/m] * table.travel_2);
        torque motor: torque(axle) = drive - 0.02 [N*m*s/rad] * left.rate;

        start { hinge.angle [rad] = 0.4; hinge.rate [rad/s] = 1; cross.travel_1 [m] = 0.1; cross.speed_1 [m/s] = 0.3;
                cross.travel_2 [m] = -0.2; cross.speed_2 [m/s] = 0; table.travel_1 [m] = 0.05; table.speed_1 [m/s] = -0.2;
                table.travel_2 [m] = 0.1; table.speed_2 [m/s] = 0.1; axle.angle [rad] = 0.7; axle.rate [rad/s] = 2; }
        expect { degrees_of_freedom = 6; }
        output along [m] = disc.travel_1;
        output across [m/s] = disc.speed_2;
    }
}

linkwright::mechanism! {
    /// A table on rubber and an engine on the table, each bushing once with its places in either order; one body turns with the
    /// table, so that its bushing only moves along.
    pub planar Mounted {
        param rubber [N/m] = 900 in 100..2000;
        param twist [N*m/rad] = 6;
        input shake [N*m];
        gravity [m/s^2] = (0.2, -9.81);
        body table  { mass [kg] = 2; inertia [kg*m^2] = 0.2; center [m] = (0.02, 0.01); point left [m] = (-0.3, 0.02); point right [m] = (0.3, -0.01); }
        body engine { mass [kg] = 1.2; inertia [kg*m^2] = 0.03; point foot [m] = (0.05, -0.08); }
        body lid    { mass [kg] = 0.3; inertia [kg*m^2] = 0.004; point edge [m] = (-0.1, 0.02); }
        rod arm     { mass [kg] = 0.4; length [m] = 0.3; }
        joint slide: prismatic(table.right, lid.edge, axis = (1, 2), angle = 0.3 [rad]);
        joint elbow: revolute(engine.center, arm.start);
        bushing left:  bushing(ground(-0.3 [m], 0.05 [m] * sin(3 [rad/s] * time)), table.left, stiffness = rubber, damping = 4 [N*s/m],
                               torsional_stiffness = twist, torsional_damping = 0.1 [N*m*s/rad]);
        bushing right: bushing(table.right, ground(0.3, 0) [m], stiffness = (400, 700) [N/m], torsional_stiffness = 0);
        bushing mount: bushing(engine.foot, table.center, stiffness [N/mm] = (0.5, 0.8), damping = (3, 2) [N*s/m], torsional_stiffness [N*m] = 4,
                               torsional_damping [N*m*s] = 0.05);
        bushing pad:   bushing(table.left, lid.edge, stiffness = 60 [N/m], torsional_stiffness = 2 [N*m/rad]);
        bushing tip:   bushing(arm.end, table.left, stiffness = (20, 0) [N/m], damping [N*s/m] = 0.3, torsional_stiffness = 1 [N*m/rad]);
        torque motor:  torque(engine) = shake;
        start { table.angle [rad] = 0.1; table.rate [rad/s] = 0.3; engine.center.x [m] = 0.03; engine.center.y [m] = 0.1; engine.angle [rad] = -0.2;
                slide.travel [m] = 0.05; slide.speed [m/s] = 0.2; elbow.angle [rad] = 2; elbow.rate [rad/s] = 1; }
        expect { degrees_of_freedom = 8; }
        output loss [W] = power(left) + power(mount);
    }
}

/// As [`linkwright_models::for_each_model`], for the mechanisms here and in `zoo_space.rs`.
#[macro_export]
macro_rules! for_each_in_zoo {
    ($callback:ident) => {
        $callback! {
            everything: $crate::everything::Everything,
            workshop: $crate::zoo::Workshop,
            gears: $crate::zoo::Gears,
            shaken: $crate::zoo::Shaken,
            floating: $crate::zoo::Floating,
            oldham: $crate::zoo::Oldham,
            mounted: $crate::zoo::Mounted,
            steered: $crate::zoo_laws::Steered,
            tethered: $crate::zoo_laws::Tethered,
            powered: $crate::zoo_laws::Powered,
            bristled: $crate::zoo_laws::Bristled,
            servo: $crate::zoo_laws::Servo,
            tabled: $crate::zoo_laws::Tabled,
            assembled: $crate::zoo_parts::Assembled,
            propped: $crate::zoo_parts::Propped,
            rubbed: $crate::zoo_friction::Rubbed,
            sliding: $crate::zoo_friction::Sliding,
            rubbed_loop: $crate::zoo_friction::RubbedLoop,
            rubbed_arm: $crate::zoo_friction::RubbedArm,
            rubbed_faces: $crate::zoo_friction::RubbedFaces,
            rubbed_threads: $crate::zoo_friction::RubbedThreads,
            rubbed_shafts: $crate::zoo_friction::RubbedShafts,
            rubbed_wire: $crate::zoo_friction::RubbedWire,
            rubbing_pairs: $crate::zoo_rubbing::RubbingPairs,
            rubbing_bodies: $crate::zoo_rubbing::RubbingBodies,
            rubbing_beams: $crate::zoo_rubbing_beams::RubbingBeams,
            rubbing_wand: $crate::zoo_rubbing_beams::RubbingWand,
            rubbing_flexible_block: $crate::zoo_rubbing_beams::RubbingBlock,
            bristly: $crate::zoo_bristles::Bristly,
            bristly_loop: $crate::zoo_bristles::BristlyLoop,
            bristly_pairs: $crate::zoo_bristles::BristlyPairs,
            bristly_bodies: $crate::zoo_bristles::BristlyBodies,
            worn: $crate::zoo_hysteresis::Worn,
            roped: $crate::zoo_hysteresis::Roped,
            terrain: $crate::zoo_laws::Terrain,
            toothed: $crate::zoo_gears::Toothed,
            meshed: $crate::zoo_gears::Meshed,
            floated: $crate::zoo_gears::Floated,
            helical: $crate::zoo_gears::Helical,
            yielding_racks: $crate::zoo_meshes::YieldingRacks,
            yielding_cones: $crate::zoo_meshes::YieldingCones,
            epicycle: $crate::zoo_gears::Epicycle,
            racked: $crate::zoo_gears::Racked,
            coned: $crate::zoo_gears::Coned,
            bent: $crate::zoo_beams::Bent,
            bent_frame: $crate::zoo_beams::Frame,
            stiffened: $crate::zoo_beams::Stiffened,
            sheared: $crate::zoo_beams_thick::Sheared,
            sheared_in_space: $crate::zoo_beams_thick::ShearedInSpace,
            sagging: $crate::zoo_beams_thick::Sagging,
            bent_in_space: $crate::zoo_beams_in_space::BentInSpace,
            bent_loop: $crate::zoo_beams_in_space::BentLoop,
            twisted_in_space: $crate::zoo_beams_in_space::TwistedInSpace,
            twisted_loop: $crate::zoo_beams_in_space::TwistedLoop,
            cantilever: $crate::zoo_modal::Cantilever,
            block: $crate::zoo_modal::Block,
            winch: $crate::zoo_cables::Winch,
            hoisted: $crate::zoo_cables::Hoisted,
            loose_loop: $crate::zoo_loose::LooseLoop,
            loose_ball: $crate::zoo_loose::LooseBall,
            cammed: $crate::zoo_cams::Cammed,
            wired: $crate::zoo_curves::Wired,
            touching: $crate::zoo_contacts::Touching,
            bumping: $crate::zoo_contacts::Bumping,
            rolling: $crate::zoo_contacts::Rolling,
            crossing: $crate::zoo_contacts::Crossing,
            profiled: $crate::zoo_profiles::Profiled,
            landing: $crate::zoo_gates::Landing,
            docking: $crate::zoo_gates::Docking,
            striking: $crate::zoo_gates::Striking,
            dropping: $crate::zoo_gates::Dropping,
            gripping: $crate::zoo_gates::Gripping,
            rasping: $crate::zoo_gates::Rasping,
            gripping_in_space: $crate::zoo_gates::GrippingInSpace,
            braking: $crate::zoo_dry::Braking,
            braking_in_space: $crate::zoo_dry::BrakingInSpace,
            braking_all_ways: $crate::zoo_dry::BrakingAllWays,
            remembering: $crate::zoo_memories::Remembering,
            remembering_impacts: $crate::zoo_memories::RememberingImpacts,
            remembering_brakes: $crate::zoo_memories::RememberingBrakes,
            remembering_touches: $crate::zoo_memories::RememberingTouches,
            yielding: $crate::zoo_penalties::Yielding,
            yielding_in_space: $crate::zoo_penalties::YieldingInSpace,
            yielding_shafts: $crate::zoo_penalties::YieldingShafts,
            arm: $crate::zoo_space::Arm,
            jack: $crate::zoo_space::Jack,
            table: $crate::zoo_space::Table,
            ceiling: $crate::zoo_space::Ceiling,
            wires: $crate::zoo_space::Wires,
            shafts: $crate::zoo_space::Shafts,
            mesh: $crate::zoo_space::Mesh,
            crank: $crate::zoo_space::Crank,
            slanted: $crate::zoo_space::Slanted,
            hub: $crate::zoo_space::Hub,
            bench: $crate::zoo_space::Bench,
            snake: $crate::zoo_space::Snake,
            stage: $crate::zoo_space::Stage,
            cabin: $crate::zoo_space::Cabin,
        }
    };
}
pub use crate::for_each_in_zoo;

/// As [`for_each_in_zoo`], for a sample that has each kind of joint, law, coordinate and gate once or twice: for what depends on kinds, and whose
/// code for every mechanism would take long to build.
#[macro_export]
macro_rules! for_each_in_sample {
    ($callback:ident) => {
        $callback! {
            everything: $crate::everything::Everything,
            workshop: $crate::zoo::Workshop,
            steered: $crate::zoo_laws::Steered,
            bristled: $crate::zoo_laws::Bristled,
            rubbed_loop: $crate::zoo_friction::RubbedLoop,
            bristly_loop: $crate::zoo_bristles::BristlyLoop,
            toothed: $crate::zoo_gears::Toothed,
            stiffened: $crate::zoo_beams::Stiffened,
            bent_loop: $crate::zoo_beams_in_space::BentLoop,
            block: $crate::zoo_modal::Block,
            hoisted: $crate::zoo_cables::Hoisted,
            loose_loop: $crate::zoo_loose::LooseLoop,
            touching: $crate::zoo_contacts::Touching,
            landing: $crate::zoo_gates::Landing,
            gripping: $crate::zoo_gates::Gripping,
            braking: $crate::zoo_dry::Braking,
            remembering: $crate::zoo_memories::Remembering,
            yielding_in_space: $crate::zoo_penalties::YieldingInSpace,
            table: $crate::zoo_space::Table,
            wires: $crate::zoo_space::Wires,
            shafts: $crate::zoo_space::Shafts,
            snake: $crate::zoo_space::Snake,
            cabin: $crate::zoo_space::Cabin,
            four_bar: linkwright_models::four_bar::FourBar,
            slider_crank: linkwright_models::slider_crank::SliderCrank,
            andrews: linkwright_models::andrews::Andrews,
            n_four_bar_2: linkwright_models::n_four_bar::NFourBar2,
            bricard: linkwright_models::bricard::Bricard,
            heavy_top: linkwright_models::heavy_top::HeavyTop,
            panda: linkwright_models::panda::Panda,
            car_axis: linkwright_models::car_axis::CarAxis,
            cam_follower: linkwright_models::cam_follower::CamFollower,
            hydraulic_loader: linkwright_models::knuckle_boom_loader::HydraulicLoader,
        }
    };
}
pub use crate::for_each_in_sample;

macro_rules! implement {
    ($($name:ident: $first:tt $(:: $segment:ident)*),* $(,)?) => { model!($($first $(:: $segment)*),*); };
}
for_each_in_zoo!(implement);
