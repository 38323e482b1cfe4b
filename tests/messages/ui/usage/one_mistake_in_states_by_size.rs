//! Code that relies on how many coordinates, bodies and gates a mechanism has adds no messages of its own to a mistake.

use linkwright::*;

mechanism! {
    pub planar Crank {
        param length [mm] = 1000;
        input drive [N*m];
        output angle [deg] = pivot.angle;
        rod arm { mass [m] = 2; length [m] = length; }
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        torque motor: torque(pivot) = drive;
        surface floor: half_plane(line(ground(0, -5) [m], ground(1, -5) [m]));
        contact touch: between(ball.surface, floor) = rigid(restitution = 0.5);
        state charge [1] = 0;
        rate charge = -charge * 1 [1/s];
        start { pivot.angle [deg] = 30; ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; }
    }
}

trait Logged {
    fn logged(&self) -> f64;
}

impl Logged for CrankOutputs {
    fn logged(&self) -> f64 {
        self.angle_deg()
    }
}

impl Logged for CrankState {
    fn logged(&self) -> f64 {
        let [charge] = self.z;
        let [gate] = self.gates;
        charge + gate + Crank::internal(&self.z).charge
    }
}

impl From<CrankInputs> for f64 {
    fn from(inputs: CrankInputs) -> f64 {
        inputs.drive
    }
}

const FIRST: CrankState = Crank::START;
const LONG: CrankParameters = CrankParameters { length: 2.0 };

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Crank::prepare(LONG)?;
    let [cos, sin, ..] = FIRST.q;
    let rates: [f64; 4] = FIRST.v;
    let bodies: [&str; Crank::BODIES.len()] = ["arm", "ball"];
    let freedoms = [0.0; Crank::DEGREES_OF_FREEDOM];
    println!("{cos} {sin} {rates:?} {bodies:?} {freedoms:?}");
    let velocities = CrankVelocities { arm_rate: 1.0, ball_rate: 2.0, ball_x_speed: 0.0, ball_y_speed: 0.0 };
    let start = CrankState { q: [1.0, 0.0, 0.0, 1.0, 1.0, 0.0], v: velocities.into(), gates: [1.0], ..FIRST };
    let inputs = CrankInputs { drive: 1.0 };
    let (mut a, mut lambda) = ([0.0; 4], []);
    Mechanism::acceleration(&model, 0.0, &start, &inputs, &mut a, &mut lambda);
    let [arm, ball] = model.motions(0.0, &start.q, &start.v, &a);
    println!("{:?} {:?} {}", arm.position, ball.position, Crank::positions(&start.q).arm_angle.radians());
    let mut simulation = model.simulation(start).constant(inputs).step(1e-3);
    simulation.run_until(1.0, |sample| println!("{} {:?}", sample.outputs.logged(), sample.state.gates))?;
    let mut stepper = Stepper::new(model, Crank::START, Rk4);
    stepper.step(&inputs, 1e-3)?;
    println!("{} {}", stepper.state().logged(), f64::from(inputs));
    Ok(())
}
