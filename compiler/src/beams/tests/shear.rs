//! Shapes of beams whose sections shear, against their equations, orthogonality, published frequencies and the slender limit.

use super::*;

/// A section of steel, 100 mm high, in Timoshenko's theory with κ = 5/6 and ν = 0.3.
fn thick(shapes: Shapes, length: f64, height: f64, bending: usize) -> Slender {
    let counts = Counts { axial: 2, bending, bending_z: 2, torsion: 0, quadratic: false };
    let thick = |height: f64| Thick { gyration: height * height / 12.0, softness: 2.6 * 1.2 };
    Slender::thick(shapes, length, counts, [thick(height), thick(0.5 * height)])
        .expect("is below the cut-off")
}

/// √(E h²/12 ρ) of steel.
fn by_section(height: f64) -> f64 {
    (2.1e11 * height * height / 12.0 / 7850.0).sqrt()
}

/// A cantilever by an independent computation with 30 digits; by hand Timoshenko's formula of a beam on two hinges, whose two frequencies at one shape
/// are the roots of r² s² b⁴ − (1 + k² π² (r² + s²)) b² + k⁴ π⁴.
#[test]
fn frequencies_with_shear_are_known() {
    let beam = thick(Shapes::Clamped, 1.0, 0.1, 3);
    for (number, expected) in [520.840641723, 3121.577765398, 8210.226133092].into_iter().enumerate() {
        let rate = beam.square_of_rate(2 + number, by_section(0.1).powi(2), 1.0).sqrt();
        near(rate, expected, 1e-9 * expected);
    }
    let beam = thick(Shapes::Pinned, 0.7, 0.1, MOST_MODES);
    let (r2, s2) = (0.01 / 12.0 / 0.49, 0.01 / 12.0 / 0.49 * 3.12);
    for number in 0..MOST_MODES {
        let k = (number as f64 + 1.0) * PI;
        let square = beam.square_of_rate(2 + number, 0.7_f64.powi(3), 1.0);
        let rest = r2 * s2 * square * square - (1.0 + k * k * (r2 + s2)) * square + k.powi(4);
        near(rest / k.powi(4), 0.0, 1e-12);
    }
}

/// Both equations hold along the beam, whose ends are as they are held.
#[test]
fn shapes_with_shear_solve_their_equations() {
    for shapes in [Shapes::Free, Shapes::Clamped, Shapes::Pinned] {
        let (length, height) = (0.7, 0.06);
        let beam = thick(shapes, length, height, 6);
        for (index, mode) in beam.modes.iter().enumerate().filter(|(_, mode)| mode.way.bends()) {
            let height = if mode.way == Way::Bending { height } else { 0.5 * height };
            let r2 = (height / length).powi(2) / 12.0;
            let s2 = 3.12 * r2;
            let b2 = beam.square_of_rate(index, length.powi(3), 1.0);
            let (n, psi) = (&mode.shape, mode.turn.as_ref().expect("shears"));
            for share in [0.0, 0.1, 0.37, 0.5, 0.81, 1.0] {
                let bent = n.at(share, 2) - psi.at(share, 1) + b2 * s2 * n.at(share, 0);
                near(bent / b2, 0.0, 1e-12);
                let shear = n.at(share, 1) - psi.at(share, 0);
                near((psi.at(share, 2) + shear / s2 + b2 * r2 * psi.at(share, 0)) / (b2 / s2), 0.0, 1e-12);
            }
            for end in [0.0, 1.0] {
                let (moment, shear) =
                    (psi.at(end, 1) / b2.sqrt(), (n.at(end, 1) - psi.at(end, 0)) / b2.sqrt());
                let zeros = match shapes {
                    Shapes::Pinned => [n.at(end, 0), moment],
                    Shapes::Clamped if end == 0.0 => [n.at(end, 0), psi.at(end, 0)],
                    _ => [moment, shear],
                };
                zeros.into_iter().for_each(|zero| near(zero, 0.0, 1e-12));
            }
        }
    }
}

/// In what moves and turns and in what bends and shears; the beam's moment of momentum is its frame's alone.
#[test]
fn shapes_with_shear_are_orthogonal() {
    for shapes in [Shapes::Free, Shapes::Clamped, Shapes::Pinned] {
        let (length, height) = (0.7, 0.06);
        let beam = thick(shapes, length, height, 6);
        let turning = beam.turning.as_ref().expect("shears");
        let rule = Rule::new(200);
        for j in 2..beam.modes.len() {
            let one = &beam.modes[j];
            let height = if one.way == Way::Bending { height } else { 0.5 * height };
            let gyration = height * height / 12.0;
            let psi = |mode: &Mode, at: f64, order: usize| {
                mode.turn.as_ref().expect("shears").at(at, order) / length
            };
            let mean =
                |of: &dyn Fn(f64) -> f64| -> f64 { rule.points().map(|(at, weight)| weight * of(at)).sum() };
            near(turning.first[j], gyration * mean(&|at| psi(one, at, 0)), 1e-14);
            // Nothing by its parity, and no rounding.
            assert!(
                turning.first[j] == 0.0 || turning.first[j].abs() > 1e-9,
                "{shapes:?} {j}: {}",
                turning.first[j]
            );
            near(beam.first[1 + j], mean(&|at| one.shape.at(at, 0)), 1e-13);
            if shapes == Shapes::Free {
                let moment = |at: f64| (at - 0.5) * length * one.shape.at(at, 0) + gyration * psi(one, at, 0);
                near(mean(&moment), 0.0, 1e-13);
                assert_eq!(beam.second[0][1 + j] + turning.first[j], 0.0);
            }
            for k in (2..beam.modes.len()).filter(|k| beam.modes[*k].way == one.way) {
                let other = &beam.modes[k];
                near(
                    beam.second[1 + j][1 + k],
                    mean(&|at| one.shape.at(at, 0) * other.shape.at(at, 0)),
                    1e-13,
                );
                let turns = mean(&|at| gyration * psi(one, at, 0) * psi(other, at, 0));
                near(turning.second[j][k], turns, 1e-13);
                let expected = if j == k { beam.moved(j) } else { 0.0 };
                near(beam.second[1 + j][1 + k] + turning.second[j][k], expected, 1e-15);
                if shapes != Shapes::Pinned {
                    near(beam.moved(j), 1.0, 1e-14);
                }
                let shear = |mode: &Mode, at: f64| mode.shape.at(at, 1) / length - psi(mode, at, 0);
                let stiff = |at: f64| {
                    psi(one, at, 1) * psi(other, at, 1) / (length * length)
                        + shear(one, at) * shear(other, at) / (3.12 * gyration)
                };
                let expected = if j == k { one.stiffness } else { 0.0 };
                near(length * mean(&stiff), expected, 1e-11 * (one.stiffness * other.stiffness).sqrt());
            }
        }
    }
}

/// Thin ones are Euler's and Bernoulli's, with an error of the order of the thickness squared.
#[test]
fn shear_of_thin_beams_is_nothing() {
    for shapes in [Shapes::Free, Shapes::Clamped, Shapes::Pinned] {
        let limit = slender(shapes, 0.7, 2, 4);
        let off = |height: f64| {
            let beam = thick(shapes, 0.7, height, 4);
            let places = [0.0, 0.2, 0.5, 0.9, 1.0].into_iter();
            let worst = |mode: usize| {
                let [one, other] = [&beam, &limit].map(|beam| beam.modes[mode].shape.clone());
                let slope = |at: f64| {
                    let x = limit.from + 0.7 * at;
                    0.01 * (beam.slopes(x)[mode] - limit.slopes(x)[mode]).abs()
                };
                let shape = |at: f64| (one.at(at, 0) - other.at(at, 0)).abs();
                places.clone().map(|at| shape(at) + slope(at)).fold(0.0, f64::max)
            };
            (2..6).map(worst).fold(0.0, f64::max)
        };
        let [thin, thinner] = [off(0.7e-2), off(0.7e-3)];
        assert!(thin < 0.05 && (thinner / thin - 0.01).abs() < 1e-3, "{shapes:?}: {thin} {thinner}");
    }
}

/// Above the cut-off there are other shapes.
#[test]
fn modes_above_the_cut_off_are_refused() {
    let counts = Counts { axial: 0, bending: 12, bending_z: 0, torsion: 0, quadratic: false };
    let thick = Thick { gyration: 0.01, softness: 3.0 };
    for (shapes, below) in [(Shapes::Free, 3), (Shapes::Clamped, 4)] {
        let beyond = Slender::thick(shapes, 1.0, counts, [thick; 2]).expect_err("is beyond");
        assert_eq!((beyond.way, beyond.below), (Way::Bending, below));
    }
}
