//! The functions of every mechanism in double precision, generated once, here: an unoptimised program takes from a library what that has
//! generated for the same types. By themselves each of the programs that run all mechanisms would generate them again, tens of megabytes.

use crate::registry::Model;
use crate::zoo;
use linkwright::{
    AssembleExt, project_position, project_velocity, reciprocal_condition, retract, smallest_pivot,
};

/// What a program may call of one mechanism.
fn functions<M: Model>() -> Vec<*const ()> {
    macro_rules! of {
        ($($function:ident),* $(,)?) => { vec![$(M::$function as *const ()),*] };
    }
    let mut all = of!(
        // `Mechanism`
        mass_matrix,
        constraints,
        constraint_jacobian,
        nu,
        gamma,
        forces,
        friction_forces,
        kinetic_energy,
        potential_energy,
        acceleration,
        acceleration_baumgarte,
        null_space,
        null_space_baumgarte,
        internal_rates,
        assignments,
        guards,
        grips,
        bounds,
        strikes,
        outputs,
        unwrap,
        // `Assemble`
        factor_jacobian,
        dependent_velocities,
        row_scales,
        factor,
        system,
        solve,
        condition_residual,
        condition_cosines,
        condition_jacobian,
        condition_bias,
        condition_drift,
        row_cosines,
        start_targets,
        fix_phases,
        // `AssembleExt`
        start,
        assemble,
        project,
        // `Report`
        motions,
        reactions,
        inverse_dynamics,
        powers,
        driver_efforts,
        // `Model`
        standard,
        prepared,
    );
    all.extend([
        project_position::<f64, M> as *const (),
        project_velocity::<f64, M> as *const (),
        smallest_pivot::<f64, M> as *const (),
        reciprocal_condition::<f64, M> as *const (),
        retract::<f64, M::Q, M::V> as *const (),
    ]);
    all
}

/// Where they are.
pub fn instances() -> Vec<*const ()> {
    macro_rules! of_all {
        ($($name:ident: $model:path),* $(,)?) => { [$(functions::<$model>()),*].concat() };
    }
    [linkwright_models::for_each_model!(of_all), zoo::for_each_in_zoo!(of_all)].concat()
}
