//! Four-bars: inverse dynamics against ADAMS' and the exact torque, the general one with literals and parameters, the
//! change point.

use super::{Table, Worst, baumgarte, run};
use linkwright::{AssembleExt, Mechanism, Simulation};
use linkwright_compiler::compile;
use linkwright_models::change_point_four_bar::ChangePointFourBar;
use linkwright_models::general_four_bar::{GeneralFourBar, ParametricFourBar};

linkwright::mechanism! {
    /// Four-bar of multibody-state-estimation, its crank driven as θ = 1.2 (1 − cos 2t).
    planar DrivenFourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 2; length [m] = 2; }
        rod rocker  { mass [kg] = 4; length [m] = sqrt(13); }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(ground(4, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        drive swing: a.angle = 1.2 [rad] * (1 - cos(2 [rad/s] * time));
        start  { coupler.angle [deg] ~ 90; rocker.angle [deg] ~ 146; }
        expect { degrees_of_freedom = 1; }
        output torque [N*m] = swing.effort;
    }
}

/// MBDS/multibody-state-estimation, InverseDynamics_4bars; the exact torque at 1e-9, ADAMS' at its 0.0085 N m.
#[test]
fn inverse_dynamics() {
    let reference = Table::new(include_str!("../../data/mbds_fourbar_inverse_dynamics_adams.csv"));
    let model = DrivenFourBar::<f64>::default();
    let (mut exact, mut adams, mut output) = (Worst::default(), Worst::default(), Worst::default());
    let mut near = DrivenFourBar::START.q;
    for row in 0..reference.rows.len() {
        let time = reference.get(row, "t");
        for part in 1..=10 {
            // Towards it in small steps, so that the branch is kept.
            let earlier = time - 0.1 + 0.01 * f64::from(part);
            near = model.kinematics(earlier.max(0.0), &near, &[]).expect("the crank swings freely").q;
        }
        let found = model.kinematics(time, &near, &[]).expect("the crank swings freely");
        let (mut a, mut lambda) = ([0.0; DrivenFourBar::START.v.len()], [0.0; 3]);
        model.acceleration(time, &found.state(), &(), &mut a, &mut lambda);
        let [[effort, _power]] = model.driver_efforts(time, &found.q, &found.v, &lambda);
        exact.see(effort, reference.get(row, "tau_exact"));
        adams.see(effort, -reference.get(row, "torque_adams"));
        output.see(model.outputs(time, &found.state(), &()).torque, effort);
    }
    exact.below(1e-9, "inverse dynamics, exact torque");
    adams.below(9e-3, "inverse dynamics, ADAMS' torque");
    output.below(1e-12, "inverse dynamics, the output named effort");
}

#[test]
fn parameters_describe_the_same_four_bar() {
    let mut traces = [Vec::new(), Vec::new()];
    run(&GeneralFourBar::<f64>::default(), GeneralFourBar::START, (10.0, 1e-3), 2.0, 50, |_, sample| {
        let outputs = sample.outputs;
        traces[0].push([outputs.tracer_x, outputs.tracer_y, outputs.rocking, sample.energy()]);
    })
    .expect("the four-bar turns");
    run(
        &ParametricFourBar::<f64>::default(),
        ParametricFourBar::START,
        (10.0, 1e-3),
        2.0,
        50,
        |_, sample| {
            let outputs = sample.outputs;
            traces[1].push([outputs.trace_x, outputs.trace_y, outputs.rocking, sample.energy()]);
        },
    )
    .expect("the four-bar turns");
    let (mut difference, mut energy) = (Worst::default(), Worst::default());
    assert_eq!(traces[0].len(), 41);
    for (literal, parametric) in traces[0].iter().zip(&traces[1]) {
        for (a, b) in literal.iter().zip(parametric) {
            difference.see(*a, *b);
        }
        energy.see(literal[3], traces[0][0][3]);
    }
    difference.below(1e-10, "literals against parameters");
    energy.below(1e-7, "general four-bar, energy");
}

/// With other parameters the assembly at run time finds a start, which meets what `start` states.
#[test]
fn other_parameters_are_assembled_at_run_time() {
    let mut parameters = *ParametricFourBar::<f64>::default().parameters();
    parameters.crank_length = 0.45;
    parameters.coupler_length = 1.05;
    parameters.start_rate = -2.0;
    let model = ParametricFourBar::prepare(parameters).expect("within bounds");
    let start = model.assemble(&ParametricFourBar::START).expect("the loop closes");
    let crank = model.motions(0.0, &start.q, &start.v, &[0.0; ParametricFourBar::START.v.len()])[0];
    assert!((crank.rate + 2.0).abs() < 1e-12);
    assert!((crank.orientation[1] - 40_f64.to_radians().sin()).abs() < 1e-12);
    let simulation = Simulation::new(&model, start);
    let residual = simulation.constraint_residual();
    assert!(residual.position < 1e-12 && residual.velocity < 1e-12, "{residual:?}");

    parameters.crank_length = 0.001;
    let error = ParametricFourBar::prepare(parameters).expect_err("out of bounds");
    assert_eq!(error.what, "crank_length");
}

/// A start at the change point is refused: the rows depend on one another there.
#[test]
fn change_point() {
    for (exact, refused) in [("= 90", false), ("= 180", true)] {
        let source = ChangePointFourBar::SOURCE.replacen("= 90", exact, 1);
        assert!(source.contains(exact));
        match compile(source.parse().expect("tokens"), None) {
            Ok(_) => assert!(!refused, "start {exact}"),
            Err(errors) => {
                let messages: Vec<&str> = errors.iter().map(|error| error.message.as_str()).collect();
                assert!(
                    refused
                        && messages
                            .iter()
                            .any(|text| text.contains("change point: crank, coupler and rocker in line")),
                    "{messages:#?}"
                );
            }
        }
    }
}

/// It turns quickly through the change point, along its own branch, with its energy.
#[test]
fn through_the_change_point() {
    let model = ChangePointFourBar::<f64>::default();
    let mut simulation =
        Simulation::new(&model, ChangePointFourBar::START).formulation(baumgarte(10.0)).step(1e-4);
    let energy = simulation.energy();
    let (mut worst, mut furthest) = (Worst::default(), 0.0_f64);
    simulation
        .run_until(0.8, |sample| {
            worst.see(sample.energy(), energy);
            furthest = furthest.max(sample.outputs.crank_angle);
        })
        .expect("it passes");
    assert!(furthest > 190_f64.to_radians(), "{furthest}");
    worst.below(1e-4, "change point, energy");
}
