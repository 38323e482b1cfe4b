//! Mechanisms that ship with Linkwright: textbook systems and published benchmarks, one file each, with source, data
//! and expected result.
#![warn(missing_docs)]

pub mod andrews;
pub mod car_axis;
pub mod change_point_four_bar;
pub mod double_pendulum;
pub mod four_bar;
pub mod general_four_bar;
pub mod jansen_leg;
pub mod klann_leg;
pub mod n_four_bar;
pub mod planetary_gear_train;
pub mod quick_return;
pub mod simple_pendulum;
pub mod slider_crank;
pub mod tree_pendulum;

/// Calls a macro with every shipped model, `name: path::to::Type`, so that no test forgets one.
///
/// ```text
/// macro_rules! names { ($($name:ident: $model:path),* $(,)?) => { [$(stringify!($name)),*] } }
/// let names = linkwright_models::for_each_model!(names);
/// ```
#[macro_export]
macro_rules! for_each_model {
    ($callback:ident) => {
        $callback! {
            simple_pendulum: $crate::simple_pendulum::SimplePendulum,
            double_pendulum: $crate::double_pendulum::DoublePendulum,
            four_bar: $crate::four_bar::FourBar,
            general_four_bar: $crate::general_four_bar::GeneralFourBar,
            parametric_four_bar: $crate::general_four_bar::ParametricFourBar,
            n_four_bar_2: $crate::n_four_bar::NFourBar2,
            n_four_bar_10: $crate::n_four_bar::NFourBar10,
            n_four_bar_40: $crate::n_four_bar::NFourBar40,
            change_point_four_bar: $crate::change_point_four_bar::ChangePointFourBar,
            slider_crank: $crate::slider_crank::SliderCrank,
            quick_return: $crate::quick_return::QuickReturn,
            andrews: $crate::andrews::Andrews,
            andrews_iftomm: $crate::andrews::AndrewsIftomm,
            planetary_gear_train: $crate::planetary_gear_train::PlanetaryGearTrain,
            jansen_leg: $crate::jansen_leg::JansenLeg,
            klann_leg: $crate::klann_leg::KlannLeg,
            car_axis: $crate::car_axis::CarAxis,
            tree_pendulum: $crate::tree_pendulum::TreePendulum,
        }
    };
}
