use linkwright::*;
use linkwright_models::four_bar::*;
fn main() {
    let model = FourBar::<f64>::default();
    println!("{:?} dof {} ops {}", FourBar::START, FourBar::DEGREES_OF_FREEDOM, FourBar::OPERATIONS);
    let start = model.assemble(&FourBar::START).unwrap();
    println!("{start:?}");
    let mut sim = Simulation::new(&model, start).formulation(Baumgarte { alpha: 10.0, beta: 10.0 }).step(1e-3);
    let e0 = sim.energy();
    let end = sim.run_until(10.0, |_s| {}).unwrap();
    println!("{end:?} drift {} residual {:?} {:?}", sim.energy() - e0, sim.constraint_residual(), sim.status());
    println!("{}", FourBar::COORDINATES);
}
