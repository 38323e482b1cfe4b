//! Tables by the names of what emitted code uses itself, and one in a file beside this one.

mod f64 {}
mod table {}

linkwright::mechanism! {
    /// It has the name of the module that its own tables are in.
    #[allow(non_camel_case_types)]
    pub planar tables {
        param value [N] = 2;
        param cell [1] = 0.1;
        table value(cell [m]) [N] = [(0, 0), (1, 3)];
        table cell(row) = [(0, 0), (1, 4)], linear;
        table tables(angle [deg]) [mm] = file("cam.csv"), columns = (angle, lift), periodic;
        table f64(a, b) [N] = grid((0, 1), (0, 1), [(0, 1), (2, 3)]);
        disk wheel { mass [kg] = 1; radius [m] = 0.1; }
        body follower { mass [kg] = 0.3; inertia [kg*m^2] = 1e-3; }
        joint shaft: revolute(ground(0, 0), wheel.center);
        joint rail: prismatic(ground(0, 0.2) [m], follower.center, axis = (0, 1));
        constraint follow: rail.travel = tables(shaft.angle);
        force push: force(rail) = value(rail.travel)*cell(cell) + value + f64(cell, rail.travel/1 [m]);
        start { shaft.angle [deg] = 90; }
        output lifted [m] = rail.travel;
        output steep [m/rad] = tables.slope(shaft.angle);
    }
}

fn main() {
    let model = tables::<::core::primitive::f64>::default();
    let outputs: tablesOutputs = model.outputs(0.0, &tables::START, &());
    assert!((outputs.lifted - 0.004).abs() < 1e-12, "{outputs:?}");
    assert!((outputs.steep - 0.0).abs() > 1e-3, "{outputs:?}");
}

use linkwright::Mechanism;
