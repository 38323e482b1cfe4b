//! The dissipation b that gives a coefficient of restitution e at an impact speed v, of laws F = K dⁿ (1 + b ḋ).
//!
//! Without other forces v dv/(1 + b v) = −(K/m) dⁿ dd on the way in and on the way out, whatever K, n and m are. Both ways from and
//! to d = 0 therefore give, with x = b v,
//!   x − ln(1 + x) = −e x − ln(1 − e x),
//! which says e by x alone: 1 − e x = −W₀(−(1 + x) exp(−(1 + x))). Here x by e is found by bisection, since the difference of both sides,
//! of which the logarithm grows without bound at x = 1/e, changes its sign once.

/// Below it x is above twenty: nothing comes back, and the force at the first touch is all there is.
pub const LEAST: f64 = 0.05;

/// How b follows from e.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damping {
    Exact,
    LankaraniNikravesh,
    HuntCrossley,
    Flores,
}

impl Damping {
    pub const ALL: [Self; 4] = [Self::Exact, Self::LankaraniNikravesh, Self::HuntCrossley, Self::Flores];
    pub const WORDS: [&'static str; 4] = ["exact", "lankarani_nikravesh", "hunt_crossley", "flores"];

    /// b v.
    pub fn number(self, e: f64) -> f64 {
        match self {
            Self::Exact => exact(e),
            // J. Mech. Des. 112 (1990) 369.
            Self::LankaraniNikravesh => 0.75 * (1.0 - e * e),
            Self::HuntCrossley => 1.5 * (1.0 - e),
            // Multibody Syst. Dyn. 25 (2011) 357.
            Self::Flores => 1.6 * (1.0 - e) / e,
        }
    }
}

fn exact(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0 / e);
    // Positive below the root: near zero it is x² (1 − e²)/2 − …
    let left = |x: f64| x * (1.0 + e) - libm::log1p(x) + libm::log1p(-e * x);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if left(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// e of x by Newton's method on the same equation.
    fn restitution(x: f64) -> f64 {
        let mut y: f64 = 0.5_f64.min(0.9 / x) * x;
        for _ in 0..100 {
            let f = y + (-y).ln_1p() + x - x.ln_1p();
            y -= f / (1.0 - 1.0 / (1.0 - y));
            y = y.clamp(1e-12, 1.0 - 1e-12);
        }
        y / x
    }

    #[test]
    fn the_dissipation_gives_the_restitution() {
        for (e, x) in [
            (0.9, 0.166481950685308),
            (0.8, 0.373146203365054),
            (0.5, 1.43275053327138),
            (0.3, 3.08708198112962),
            (0.1, 9.99815939749567),
        ] {
            assert!((exact(e) - x).abs() < 1e-13 * x, "{e}: {} {x}", exact(e));
            assert!((restitution(exact(e)) - e).abs() < 1e-12);
        }
        assert_eq!(exact(1.0), 0.0);
    }

    #[test]
    fn approximations_give_another_one() {
        for (damping, half, most) in [
            (Damping::LankaraniNikravesh, 0.72524111401, 0.913176677806),
            (Damping::HuntCrossley, 0.662962200002, 0.909015741349),
            (Damping::Flores, 0.470444779327, 0.893920692663),
        ] {
            assert!((restitution(damping.number(0.5)) - half).abs() < 1e-11, "{damping:?}");
            assert!((restitution(damping.number(0.9)) - most).abs() < 1e-11, "{damping:?}");
        }
    }
}
