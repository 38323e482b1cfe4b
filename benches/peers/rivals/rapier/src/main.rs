//! Simulates bodies in the plane whose pins are rapier's impulse joints; each body's frame is at its centre of mass.
//!
//! ```text
//! rapier-peer FILE
//!
//! gravity x y
//! body mass inertia  x y angle  vx vy rate  torque
//! pin first second  x y  x y             places in the bodies' frames; −1 is the ground
//! spring first second  x y  x y  stiffness length
//! run end steps
//! ```
//! Prints for each run a line: steps, seconds, the angles of all bodies at the end.

use rapier2d_f64::prelude::*;
use std::time::Instant;

/// Iterations of the solver in a step: more of them leave less drift, and rapier's default leaves the most.
const ITERATIONS: usize = 4;

#[derive(Default)]
struct Definition {
    gravity: Vec<f64>,
    bodies: Vec<Vec<f64>>,
    pins: Vec<Vec<f64>>,
    springs: Vec<Vec<f64>>,
    runs: Vec<Vec<f64>>,
}

fn read(text: &str) -> Option<Definition> {
    let mut found = Definition::default();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next()?;
        let numbers: Vec<f64> = words.map(str::parse).collect::<Result<_, _>>().ok()?;
        match kind {
            "gravity" => found.gravity = numbers,
            "body" => found.bodies.push(numbers),
            "pin" => found.pins.push(numbers),
            "spring" => found.springs.push(numbers),
            "run" => found.runs.push(numbers),
            _ => return None,
        }
    }
    Some(found)
}

fn world(definition: &Definition, step: f64) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = PhysicsWorld {
        gravity: Vector::new(definition.gravity[0], definition.gravity[1]),
        ..Default::default()
    };
    world.integration_parameters.dt = step;
    world.integration_parameters.num_solver_iterations = ITERATIONS;
    world.integration_parameters.normalized_max_linear_velocity = f64::MAX;
    let ground = world.bodies.insert(RigidBodyBuilder::fixed());
    let mut handles = Vec::new();
    for body in &definition.bodies {
        let builder = RigidBodyBuilder::dynamic()
            .translation(Vector::new(body[2], body[3]))
            .rotation(body[4])
            .linvel(Vector::new(body[5], body[6]))
            .angvel(body[7])
            .additional_mass_properties(MassProperties::new(Vector::ZERO, body[0], body[1]))
            .can_sleep(false);
        let handle = world.bodies.insert(builder);
        if body[8] != 0.0 {
            world.bodies[handle].add_torque(body[8], true);
        }
        handles.push(handle);
    }
    let of = |number: f64| if number < 0.0 { ground } else { handles[number as usize] };
    for pin in &definition.pins {
        let joint = RevoluteJointBuilder::new()
            .contacts_enabled(false)
            .local_anchor1(Vector::new(pin[2], pin[3]))
            .local_anchor2(Vector::new(pin[4], pin[5]));
        world.impulse_joints.insert(of(pin[0]), of(pin[1]), joint, true);
    }
    for spring in &definition.springs {
        let joint = SpringJointBuilder::new(spring[7], spring[6], 0.0)
            .local_anchor1(Vector::new(spring[2], spring[3]))
            .local_anchor2(Vector::new(spring[4], spring[5]));
        world.impulse_joints.insert(of(spring[0]), of(spring[1]), joint, true);
    }
    (world, handles)
}

fn main() {
    let path = std::env::args().nth(1).expect("a file");
    let text = std::fs::read_to_string(path).expect("it can be read");
    let definition = read(&text).expect("lines as above");
    for run in &definition.runs {
        let (end, steps) = (run[0], run[1] as usize);
        let (mut world, handles) = world(&definition, end / steps as f64);
        let begin = Instant::now();
        (0..steps).for_each(|_| world.step());
        let passed = begin.elapsed().as_secs_f64();
        let angles: Vec<String> =
            handles.iter().map(|handle| world.bodies[*handle].rotation().angle().to_string()).collect();
        println!("{steps} {passed} {}", angles.join(" "));
    }
}
