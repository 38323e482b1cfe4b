//! Code that uses everything a mechanism has adds no messages of its own to a mistake.

use linkwright::*;

mechanism! {
    /// One wrong unit.
    #[must_use]
    pub spatial Arm {
        /// Carried at the end.
        param payload [kg] = 2 in 0.5..10;
        repeat i in 0..2 { param _offset[i] [m] = 0.1; input drive[i] [N*m]; output seen[i] [rad] = hinge.angle; }
        output tip [m] = lower.end.x;
        rod upper { mass [kg] = payload; length [m] = 1; radius [m] = 0.05; }
        rod lower { mass [m] = 1; length [m] = 1; radius [m] = 0.05; }
        joint hinge: revolute(ground(0, 0, 0), upper.start, axis = (0, 0, 1));
        joint elbow: universal(upper.end, lower.start, axis = (0, 0, 1), second_axis = (0, 1, 0));
        torque motor: torque(hinge) = drive[0] + drive[1];
        options { emit = (penalty, projection, tangent); }
    }
}

fn run<M, F: Formulation<f64, M>>(model: &M, start: StateOf<M>, with: F)
where
    M: Mechanism<f64, Inputs = ArmInputs, Outputs = ArmOutputs> + Assemble<f64>,
{
    let inputs = |time: f64, _: &StateOf<M>| ArmInputs { drive_0: time, drive_1: 0.0 };
    let mut simulation = Simulation::new(model, start).formulation(with).inputs(Sampled(inputs)).step(1e-3);
    let _ = simulation.run_until(1.0, |sample| println!("{} {}", sample.outputs.tip, sample.outputs.seen_1));
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let parameters = ArmParameters { payload: 3.0, ..ArmParameters::default() };
    let model = Arm::prepare(ArmParameters { payload: 3.0, _offset_0: 0.1, _offset_1: parameters._offset_1 })?;
    assert!(model.parameters().payload > 2.0 && model == model);
    let start: ArmState = model.assemble(&Arm::START)?;
    run(&model, start, LagrangeIndex1);
    run(&model, start, Baumgarte { alpha: 10.0, beta: 10.0 });
    run(&model, start, Penalty::new(1e7));
    run(&model, start, AugmentedLagrangian::new(Penalty::new(1e7)));
    run(&model, start, NullSpace);
    let inputs = ArmInputs { drive_0: 1.0, drive_1: 0.0 };
    let mut stiff = Simulation::new(&model, start)
        .inputs(Held(|_, _: &ArmState| inputs))
        .integrator(GeneralisedAlpha::new(0.8))
        .step(1e-2);
    stiff.advance()?;
    let mut smooth = Simulation::new(&model, start)
        .inputs(Held(|_, _: &ArmState| inputs))
        .integrator(DormandPrince::tolerance(1e-8))
        .step(1e-2);
    smooth.run_until_event(1.0, &[Event::of("tip").rising()], |sample| println!("{}", sample.time))?;
    smooth.run_every(0.1, 2.0, |sample| println!("{}", sample.energy()))?;
    let (a, lambda) = (smooth.acceleration()?, smooth.multipliers()?);
    let here = Linearisation::at(&model, 0.0, &start, &inputs)?;
    let _ = here.state_space()?;
    let _ = equilibrium(&model, 0.0, &start.q, &inputs)?;
    let _ = actuation(&model, 0.0, &start, &a, &inputs, &["drive_0"])?;
    let [upper, lower] = model.motions(0.0, &start.q, &start.v, &a);
    println!("{:?} {:?}", upper.position, lower.position);
    let [hinge, _] = model.reactions(0.0, &start, &inputs, &a, &lambda);
    let [motor] = model.powers(0.0, &start, &inputs);
    println!("{:?} {motor} {}", hinge.force, model.inverse_dynamics(0.0, &start, &inputs, &a)[0]);
    println!("{} {} {}", Arm::DEGREES_OF_FREEDOM, Arm::OPERATIONS, Arm::DEFINITION);
    println!("{} {:?} {:?}", Arm::BODIES[1], Arm::REDUNDANT_ROWS, Arm::SHARED_REACTIONS);
    Ok(())
}
