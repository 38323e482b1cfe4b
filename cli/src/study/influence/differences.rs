//! Derivatives by differences of what has to be computed anew for each value of a parameter: central ones with Richardson's
//! extrapolation, on one side where the other does not assemble or is out of bounds, and how far they can be off.

use super::Parameter;
use crate::study::methods::AnyEngine;
use crate::study::runs::on_all_cores;
use crate::with_engine;

/// The first step, of a parameter's size.
const RELATIVE: f64 = 1e-3;
/// Later ones of the first.
const FINER: [f64; 3] = [1.0, 1.0 / 16.0, 1.0 / 256.0];
/// An error that is small enough, in parts of the value or of what the parameter as a whole does to it.
const SETTLED: f64 = 1e-7;

/// How a derivative was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    Exact,
    Differences,
    OneSided,
}

impl How {
    pub fn text(self) -> &'static str {
        match self {
            How::Exact => "exact",
            How::Differences => "differences",
            How::OneSided => "one-sided differences",
        }
    }
}

/// A derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    pub value: f64,
    /// How far it can be off, by the differences with twice the step; zero of an exact one.
    pub error: f64,
    pub how: How,
}

impl Slope {
    pub fn exact(value: f64) -> Slope {
        Slope { value, error: 0.0, how: How::Exact }
    }

    /// In other units.
    pub fn times(self, factor: f64) -> Slope {
        Slope { value: factor * self.value, error: factor.abs() * self.error, ..self }
    }
}

/// A parameter that is varied: its place, and the step, SI.
pub struct Varied {
    pub index: usize,
    pub step: f64,
}

impl Varied {
    pub fn of(parameter: &Parameter) -> Varied {
        Varied { index: parameter.index, step: parameter.step }
    }
}

/// The first step of a parameter, SI: a thousandth of its value, of a zero one of its bounds or its unit.
pub fn step(value: f64, bounds: Option<(f64, f64)>, unit: f64) -> f64 {
    let width = bounds.map_or(0.0, |(least, most)| most - least);
    let size = [value.abs(), width, unit].into_iter().find(|size| *size > 0.0);
    RELATIVE * size.unwrap_or(1.0)
}

/// Values with other parameters.
pub type Evaluate<'e> = dyn Fn(&AnyEngine, &[f64]) -> Result<Vec<f64>, String> + Sync + 'e;

/// Of each parameter the derivatives of all values, which are `base` where nothing is changed; or why there are none.
pub fn slopes(
    engine: &AnyEngine,
    varied: &[Varied],
    base: &[f64],
    evaluate: &Evaluate,
) -> Vec<Result<Vec<Slope>, String>> {
    let mut found: Vec<Result<Vec<Slope>, String>> = vec![Err(String::new()); varied.len()];
    let rounds = FINER.iter().map(|finer| (*finer, &CENTRAL[..]));
    let one_sided = FINER.iter().flat_map(|finer| [(*finer, &ONE_SIDED[..]), (-*finer, &ONE_SIDED[..])]);
    for (factor, offsets) in rounds.chain(one_sided) {
        let is_central = offsets.len() == CENTRAL.len();
        let open: Vec<usize> = (0..varied.len())
            .filter(|k| match &found[*k] {
                Err(_) => true,
                Ok(slopes) => is_central && !settled(slopes, base, varied[*k].step),
            })
            .collect();
        let jobs: Vec<(usize, f64)> = open
            .iter()
            .flat_map(|k| offsets.iter().map(|offset| (*k, offset * factor * varied[*k].step)))
            .collect();
        let values = on_all_cores(engine, jobs.len(), &|engine, job| {
            let (k, change) = jobs[job];
            let mut parameters = with_engine!(engine, |engine| engine.parameters().to_vec());
            parameters[varied[k].index] += change;
            let values = evaluate(engine, &parameters)?;
            match values.iter().all(|value| value.is_finite()) {
                true => Ok(values),
                false => Err("what comes of it is no finite number".to_string()),
            }
        });
        for (k, values) in open.into_iter().zip(values.chunks(offsets.len())) {
            let step = factor * varied[k].step;
            let values: Result<Vec<&Vec<f64>>, &String> = values.iter().map(Result::as_ref).collect();
            match (values, &mut found[k]) {
                (Ok(values), known) => {
                    let new = (0..base.len()).map(|index| {
                        let at: Vec<f64> = values.iter().map(|values| values[index]).collect();
                        if is_central {
                            central(base[index], &at, step)
                        } else {
                            one_sided_of(base[index], &at, step)
                        }
                    });
                    let new: Vec<Slope> = new.collect();
                    match known {
                        Ok(known) => {
                            for (known, new) in known.iter_mut().zip(new) {
                                if new.error < known.error {
                                    *known = new;
                                }
                            }
                        }
                        Err(_) => *known = Ok(new),
                    }
                }
                // The first message is that of the plainest step.
                (Err(message), Err(known)) if known.is_empty() => known.clone_from(message),
                (Err(_), _) => {}
            }
        }
    }
    found
}

/// Where the values are computed, in steps.
const CENTRAL: [f64; 4] = [1.0, 0.5, -0.5, -1.0];
const ONE_SIDED: [f64; 3] = [1.0, 0.5, 0.25];

/// D(h) = (y(h) − y(−h))/2h is off by h² and more: (4 D(h/2) − D(h))/3 is off by h⁴. What it is surely not off by is
/// what it differs from D(h/2). Slopes of both sides, which differ by S(h) = (y(h) − 2 y + y(−h))/h, meet as h vanishes unless there is
/// a kink, of 2 S(h/2) − S(h).
fn central(base: f64, at: &[f64], step: f64) -> Slope {
    let [coarse, fine] = [(at[0] - at[3]) / (2.0 * step), (at[1] - at[2]) / step];
    let [sides, nearer] = [(at[0] - 2.0 * base + at[3]) / step, (at[1] - 2.0 * base + at[2]) / (0.5 * step)];
    let value = (4.0 * fine - coarse) / 3.0;
    let error = (value - fine).abs() + 0.5 * (2.0 * nearer - sides).abs();
    Slope { value, error, how: How::Differences }
}

/// The same with D(h) = (4 y(h/2) − y(h) − 3 y)/h.
fn one_sided_of(base: f64, at: &[f64], step: f64) -> Slope {
    let coarse = (4.0 * at[1] - at[0] - 3.0 * base) / step;
    let fine = (4.0 * at[2] - at[1] - 3.0 * base) / (0.5 * step);
    let value = (4.0 * fine - coarse) / 3.0;
    Slope { value, error: (value - fine).abs(), how: How::OneSided }
}

fn settled(slopes: &[Slope], base: &[f64], step: f64) -> bool {
    let size = step / RELATIVE;
    slopes
        .iter()
        .zip(base)
        .all(|(slope, base)| slope.error * size <= SETTLED * (slope.value.abs() * size).max(base.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    type Function = fn(f64) -> f64;

    fn by(function: Function, at: f64, step: f64) -> [Slope; 2] {
        let values = |offsets: &[f64]| offsets.iter().map(|k| function(at + k * step)).collect::<Vec<f64>>();
        [
            central(function(at), &values(&CENTRAL), step),
            one_sided_of(function(at), &values(&ONE_SIDED), step),
        ]
    }

    #[test]
    fn smooth_functions_have_small_errors() {
        let cases: [(Function, f64, f64); 3] = [
            (f64::exp, 1.0, 1_f64.exp()),
            (f64::sin, 0.7, 0.7_f64.cos()),
            (f64::sqrt, 2.0, 0.5 / 2_f64.sqrt()),
        ];
        for (function, at, expected) in cases {
            for slope in by(function, at, 1e-3 * at) {
                assert!((slope.value - expected).abs() < 1e-8, "{slope:?} {expected}");
                assert!((slope.value - expected).abs() <= slope.error + 1e-12, "{slope:?} {expected}");
                assert!(slope.error < 1e-5, "{slope:?}");
            }
        }
    }

    #[test]
    fn kinks_are_seen() {
        let [slope, _] = by(f64::abs, 0.0, 1e-3);
        assert!(slope.error >= 0.99, "{slope:?}: slopes are −1 and 1");
        let [slope, _] = by(|x| (x - 0.4e-3).max(0.0), 0.0, 1e-3);
        assert!(slope.error > 0.05, "{slope:?}");
    }

    #[test]
    fn steps_have_the_size_of_the_parameter() {
        assert_eq!(step(-0.2, Some((-1.0, 1.0)), 1e-3), 2e-4);
        assert_eq!(step(0.0, Some((-1.0, 1.0)), 1e-3), 2e-3);
        assert_eq!(step(0.0, None, 1e-3), 1e-6);
    }
}
