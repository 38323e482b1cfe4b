//! Teeth on axes that move against each other, in the plane.
//!
//! With d from the first centre to the second (of a ring from its centre to the wheel's), a = |d| and ψ its direction, cos α_w = R/a, R = |r_b2 ± r_b1|:
//! u = r_b1(θ₁ − ψ) ± r_b2(θ₂ − ψ) less whole pitches, and each side of a tooth has the play j = ±R (inv α_w − inv α₀) beyond half the backlash, α₀ where
//! teeth without play touch on both sides (an involute is unwound from its base circle: Litvin & Fuentes, Gear Geometry and Applied Theory, 2004, 10.2).
//! Rates are algebraic: ψ̇ = d × ḋ/a² and j̇ = ± sin α_w ȧ, so that the force on a centre has the direction of its line of action.

use super::vector::{self, Pair as Turn};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::model::Rotor;
use crate::model::gears::{Mesh, Pair, involute};
use crate::symbolic::{Compare, On, Scalar};

/// What the distance and the direction of the centres make of a pair.
pub struct MovingAxes<'g> {
    /// u without the error: of (−½, ½] pitches.
    pub turned: Moving<'g>,
    /// j.
    pub play: Moving<'g>,
    /// a.
    pub distance: Scalar<'g>,
    /// (cos ψ, sin ψ).
    centres: On<'g, Turn>,
}

impl<'g> MovingAxes<'g> {
    pub fn of(laws: &Laws<'g>, pair: &Pair, mesh: &Mesh) -> Self {
        let (g, plane) = (laws.g, laws.plane());
        let [first, second] = pair.on.map(|id| &laws.mechanism.toothing(id).center);
        let ring_is_second = mesh.sense < 0.0 && pair.wheel == 0;
        let [from, to] = if ring_is_second { [second, first] } else { [first, second] };
        let [x, y] = plane.difference_in_world(laws, from, to);
        let square = x.value().square() + y.value().square();
        let distance = square.sqrt();
        let centres = g.on([(x.value() / distance).bare, (y.value() / distance).bare]);

        // Of base circles that reach each other there is no line of action: α is taken for zero, and no root of less.
        let reach = (mesh.base[1] + mesh.sense * mesh.base[0]).abs();
        let beyond = square - reach * reach;
        let apart = g.zero().compare(Compare::Less, beyond);
        let tangent = apart.select(apart.select(beyond, g.one()).sqrt(), g.zero());
        let unwound = tangent / reach - tangent.atan2(g.number(reach));
        let slack = mesh.sense * reach * (unwound - involute(mesh.working_angle.unwrap_or(0.0)));
        let mut play = (mesh.sense * (tangent / square)) * (x.value() * &x + y.value() * &y);
        play.jet.value = slack.bare;

        let rotors = pair.on.map(|id| Rotor::Body(id.body));
        let [one, other] = rotors.map(|rotor| laws.kinematics().rotor_rate(laws, rotor));
        let radii = [mesh.base[0], mesh.sense * mesh.base[1]];
        let mut turned = radii[0] * one + radii[1] * other - (radii[0] + radii[1]) * y.atan2(&x);
        let mut axes = MovingAxes { turned: turned.clone(), play, distance, centres };
        let teeth = |which: usize| {
            let turn = axes.against_centres(laws.kinematics().rotor_pair(laws, rotors[which]));
            turn.times(pair.teeth[which] as u64)
        };
        let (one, other) = (teeth(0), teeth(1));
        let other = if mesh.sense < 0.0 { other.opposite() } else { other };
        let facing = [libm::cos(pair.constant), -libm::sin(pair.constant)].map(|part| g.number(part).bare);
        let [cosine, sine] = one.turned(other).turned(facing).parts();
        turned.jet.value = ((mesh.base[0] / pair.teeth[0]) * sine.atan2(cosine)).bare;
        axes.turned = turned;
        axes
    }

    /// (cos, sin) of an angle against the line of centres.
    pub fn against_centres(&self, angle: On<'g, Turn>) -> On<'g, Turn> {
        angle.turned(self.centres.opposite())
    }
}

impl<'g> On<'g, Turn> {
    /// (cos, sin) of an angle so many times, by squares: 2 log₂ n products.
    pub fn times(self, mut count: u64) -> Self {
        let (mut power, mut result) = (self, None);
        while count > 0 {
            if count % 2 == 1 {
                result = Some(result.map_or(power, |result: Self| result.turned(power)));
            }
            count /= 2;
            if count > 0 {
                power = power.twice();
            }
        }
        result.unwrap_or_else(|| vector::unturned(self.g))
    }

    /// (c² − s², 2 c s).
    fn twice(self) -> Self {
        let [c, s] = self.parts();
        self.g.on([(c * c - s * s).bare, (2.0 * c * s).bare])
    }
}
