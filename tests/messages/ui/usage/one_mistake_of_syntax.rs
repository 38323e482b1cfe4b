//! Fields of statements that cannot be read, and of rounds that were given up, exist for the code that uses them.

linkwright::mechanism! {
    pub planar Pair {
        /// Two masses.
        repeat i in 0..2 { param heavy[i] [kg] = 1; rod arm[i] { mass [kg] = heavy[i] length [m] = 1; } }
        #[allow(unused)] param stiff [N/m] = ;
        input drive [N*m] = 3;
        output angle [rad] = pivot.angle;
    }
}

fn main() {
    let parameters = PairParameters { heavy_0: 1.0, heavy_1: 2.0, stiff: 3.0 };
    let model = Pair::prepare(parameters).unwrap();
    let mut simulation = linkwright::Simulation::new(&model, Pair::START)
        .inputs(linkwright::Held(|_, _: &PairState| PairInputs { drive: 1.0 }))
        .step(1e-3);
    println!("{}", simulation.sample().outputs.angle);
}
