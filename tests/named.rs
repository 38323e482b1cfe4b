//! Coordinates by name are the entries of q and v.

use linkwright::{Angle, AssembleExt, Mechanism, Turns};
use linkwright_models::andrews::Andrews;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::slider_crank::SliderCrank;

linkwright::mechanism! {
    /// A body on a rail with a wheel whose turns are counted.
    planar Trolley {
        gravity [m/s^2] = (0, -9.81);
        body cart { mass [kg] = 2; inertia [kg*m^2] = 0.1; point hub [m] = (0, 0.1); }
        disk wheel { mass [kg] = 1; radius [m] = 0.3; }
        joint rail: prismatic(ground(0, 0) [m], cart.origin, axis = (1, 0));
        joint hub: revolute(cart.hub, wheel.center);
        constraint roll: rack(hub, rail, radius = 0.3 [m]);
        start { rail.travel [m] = 2; rail.speed [m/s] = 0.6; }
        expect { degrees_of_freedom = 1; }
    }
}

/// The index of an entry by its name.
fn at(names: &[&str], name: &str) -> usize {
    names.iter().position(|known| *known == name).unwrap_or_else(|| panic!("no {name} among {names:?}"))
}

#[test]
fn bodies_in_the_plane() {
    let state = SliderCrank::START;
    let positions = SliderCrank::positions(&state.q);
    let model = SliderCrank::<f64>::default();
    let names = model.position_names();
    let entry = |name: &str| state.q[at(names, name)];
    assert_eq!(positions.crank_angle, Angle { cos: entry("crank.cos"), sin: entry("crank.sin") });
    assert_eq!(positions.rod_angle, Angle { cos: entry("rod.cos"), sin: entry("rod.sin") });
    let model = SliderCrank::<f64>::default();
    let names = model.velocity_names();
    assert_eq!(SliderCrank::velocities(&state.v).crank_rate, state.v[at(names, "crank.rate")]);
}

#[test]
fn an_angle_is_set_in_radians() {
    let model = Andrews::default();
    let mut state = model.start();
    let mut positions = Andrews::positions(&state.q);
    positions.crank_angle = Angle::from_radians(0.3_f64);
    let others = Andrews::positions(&state.q).link_angle;
    state.q = positions.into();
    assert!((Andrews::positions(&state.q).crank_angle.radians() - 0.3_f64).abs() < 1e-15);
    assert_eq!(Andrews::positions(&state.q).link_angle, others);
}

#[test]
fn orientations_in_space() {
    let state = HeavyTop::START;
    let positions = HeavyTop::positions(&state.q);
    let model = HeavyTop::<f64>::default();
    let names = model.position_names();
    let at_w = names.iter().position(|name| name.ends_with(".orientation.w")).expect("a quaternion");
    let all: [f64; 4] = std::array::from_fn(|part| state.q[at_w + part]);
    assert_eq!(positions.tip_orientation, all);
    assert_eq!(HeavyTop::velocities(&state.v).tip_rate[..], state.v[..3]);
}

#[test]
fn travels_and_counted_turns() {
    let state = Trolley::START;
    let positions = Trolley::positions(&state.q);
    assert!((positions.rail_travel - 2.0).abs() < 1e-12);
    assert!((Trolley::velocities(&state.v).rail_speed - 0.6).abs() < 1e-12);
    let model = Trolley::<f64>::default();
    let names = model.position_names();
    let turns = at(names, "hub.turns");
    assert_eq!(positions.hub_turns, Turns { turns: state.q[turns], remainder: state.q[turns + 1] });
}

/// There and back again, to the bit.
#[test]
fn both_ways() {
    let entries = |count: usize| (0..count).map(|index| 0.1 + index as f64).collect::<Vec<_>>();
    let q: [f64; Q] = entries(Q).try_into().expect("n_q entries");
    let v: [f64; V] = entries(V).try_into().expect("n_v entries");
    const Q: usize = Trolley::START.q.len();
    const V: usize = Trolley::START.v.len();
    assert_eq!(<[f64; Q]>::from(Trolley::positions(&q)), q);
    assert_eq!(<[f64; V]>::from(Trolley::velocities(&v)), v);
    let top = HeavyTop::START;
    assert_eq!(<[f64; 4]>::from(HeavyTop::positions(&top.q)), top.q);
    assert_eq!(<[f64; 3]>::from(HeavyTop::velocities(&top.v)), top.v);
}
