//! Names of the user that are units, letters of emitted code, words of the language, or not ASCII.

linkwright::mechanism! {
    planar Größe {
        param m [kg] = 1;
        param q [m] = 1;
        param höhe [m] = 1;
        param scalar [1] = 1;
        input lambda [N];
        input u [N*m];
        rod v { mass [kg] = m; length [m] = q; }
        rod constants { mass [kg] = 1; length [m] = höhe; }
        rod 腕 { mass [kg] = 1; length [m] = scalar * 1 [m]; }
        particle out { mass [kg] = 1; }
        joint kg: revolute(ground(0, 0) [m], v.start);
        joint rad: revolute(v.end, constants.start);
        joint parameters: revolute(constants.end, 腕.start);
        joint phases: revolute(腕.end, out.center);
        torque target: torque(kg) = u;
        force f64: force(腕.end) = (lambda, 0);
        start { kg.angle [rad] = 0.5; rad.angle [rad] = 0.1; parameters.angle [rad] = 0.2; }
        options { emit = (penalty, projection, null_space, tangent); }
        output a [m] = v.end.x;
        output a0 [m] = constants.end.y;
        output ω [rad/s] = kg.rate;
        output result [m] = 腕.end.y;
    }
}

fn main() {
    let model: Größe = Größe::prepare(GrößeParameters { höhe: 2.0, ..Default::default() }).expect("positive");
    let inputs = GrößeInputs { lambda: 1.0, u: 2.0 };
    let outputs: GrößeOutputs =
        linkwright::Mechanism::outputs(&model, 0.0, &Größe::START, &inputs);
    assert!((outputs.a - 0.5_f64.cos()).abs() < 1e-12 && outputs.ω == 0.0);
    assert_eq!(Größe::<f64>::BODIES, ["v", "constants", "腕", "out"]);
}
