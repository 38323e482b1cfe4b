//! The formulations compared.

use crate::trial::{Setting, Trial, head, row, trial};
use linkwright::{
    Ali3p, Assemble, AugmentedLagrangian, Baumgarte, Formulation, GeneralisedAlpha, ImplicitTrapezoidal,
    LagrangeIndex1, NullSpace, Partitioned, Penalty, Projected, Rk4, Tangent,
};

/// All of them, one after the other, as a table. Frequencies are those of `rate` (1/s).
pub fn table<M: Assemble<f64, Inputs = ()>>(setting: &Setting<'_, M>, rate: f64) -> String {
    let mut text = head(setting.steps);
    let baumgarte = |factor: f64| Baumgarte { alpha: factor * rate, beta: factor * rate };
    let stiff = Penalty::for_model(setting.model, 0.0, &setting.start.q, 1.0 / rate);
    let stiff = Penalty { omega: rate, ..stiff };
    add(&mut text, setting, "Lagrange, index 1", LagrangeIndex1);
    for factor in [0.5, 1.0, 2.0] {
        add(&mut text, setting, &format!("Baumgarte, α = β = {}/s", factor * rate), baumgarte(factor));
    }
    let soft = Penalty::customary(setting.model, 0.0, &setting.start.q, 1.0 / rate);
    let soft = Penalty { omega: rate, ..soft };
    add(&mut text, setting, "penalty, 10⁷ M", soft);
    add(&mut text, setting, "penalty", stiff);
    add(&mut text, setting, "augmented Lagrangian, 10⁷ M", AugmentedLagrangian::new(soft));
    add(&mut text, setting, "augmented Lagrangian", AugmentedLagrangian::new(stiff));
    add(&mut text, setting, "index 1, projected", Projected::after(LagrangeIndex1));
    add(&mut text, setting, "Baumgarte, projected", Projected::after(baumgarte(1.0)));
    add(&mut text, setting, "penalty, projected", Projected::after(stiff));
    add(
        &mut text,
        setting,
        "augmented Lagrangian, projected",
        Projected::after(AugmentedLagrangian::new(stiff)),
    );
    add(&mut text, setting, "null space", NullSpace);
    add(&mut text, setting, "null space, projected", Projected::after(NullSpace));
    add(&mut text, setting, "coordinate partitioning", Partitioned::default());
    text
}

/// The implicit methods, which hold the constraints themselves.
pub fn implicit<M: Tangent<f64, Inputs = ()>>(setting: &Setting<'_, M>) -> String {
    let mut text = head(setting.steps);
    macro_rules! add {
        ($name:literal, $formulation:expr, $integrator:expr) => {
            let trials: Vec<Trial> =
                setting.steps.iter().map(|step| trial(setting, ($formulation, $integrator), *step)).collect();
            text.push_str(&row($name, &trials, setting.end));
        };
    }
    let projected = Projected::after(LagrangeIndex1);
    add!("generalised-α, ρ = 0.8", LagrangeIndex1, GeneralisedAlpha::new(0.8));
    add!("generalised-α, ρ = 0.8, projected", projected, GeneralisedAlpha::new(0.8));
    add!("implicit trapezoidal, index 2", LagrangeIndex1, ImplicitTrapezoidal::default());
    add!("implicit trapezoidal, projected", projected, ImplicitTrapezoidal::default());
    add!("ALI3-P, α = 10⁷", LagrangeIndex1, Ali3p::new(1e7));
    text
}

fn add<M, F>(text: &mut String, setting: &Setting<'_, M>, name: &str, formulation: F)
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M> + Copy,
{
    let steps = setting.steps.iter();
    let trials: Vec<Trial> = steps.map(|step| trial(setting, (formulation, Rk4), *step)).collect();
    text.push_str(&row(name, &trials, setting.end));
}
