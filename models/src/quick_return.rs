//! Quick-return mechanism with rigid parts, the forces on it and the torque that keeps its crank speed.
//!
//! Source: the conference paper on the flexible quick return, Tables 1 and 2 and equations (24)–(26). Data: crank with a
//! flywheel, 150 mm; guide, 400 mm, on which the crank's tip slides; coupler, 350 mm; slider on y = 0.2 m; no gravity.
//! The start (Table 2) has the crank perpendicular to the guide, at 2π − asin ¾ = 5.435123228198 rad, where the slider is
//! at its return point; the stroke is 0.6 m. Expected at 15 rad/s: torque (26) between +2027.1328 N m at 0.363409 s and
//! −1719.0391 N m at 0.377939 s, torque (25) up to 17.1428571 N m, and under torque (26) a constant crank speed.
//!
//! The laws below are plain functions, for a crank that turns at a constant speed.

use core::f64::consts::{PI, TAU};
use linkwright::{AssembleExt, AssemblyError, Kinematics, Motion, Real};

linkwright::mechanism! {
    /// Quick-return mechanism, rigid parts.
    ///
    /// Inputs are the torque on the crank and the cutting force on the slider along +x; see [`slider_force`] and
    /// [`ConstantSpeed`] for those of the source. The slider's stroke is 0.6 m.
    pub planar QuickReturn {
        const GUIDE [m] = 0.4;
        /// Moment of inertia of crank and flywheel about the crank's centre.
        param flywheel [kg*m^2] = 1.26069 in 1e-3..100;
        /// Torque on the crank, counter-clockwise.
        input drive [N*m];
        /// Force on the slider, along +x: against the forward stroke.
        input cutting [N];

        body crank   { mass [kg] = 0.368; inertia [kg*m^2] = flywheel;
                       point pivot [m] = (-0.075, 0); point tip [m] = (0.075, 0); }
        body guide   { mass [kg] = 0.551; inertia [kg*m^2] = 0.00735;
                       point pivot [m] = (-GUIDE/2, 0); point tip [m] = (GUIDE/2, 0);
                       line slot = (guide.pivot, guide.tip); }
        body coupler { mass [kg] = 0.105; inertia [kg*m^2] = 0.00107;
                       point start [m] = (-0.175, 0); point end [m] = (0.175, 0); }
        body slider  { mass [kg] = 2.206; inertia [kg*m^2] = 0.00184; }

        joint crank_pin: revolute(ground(0, 0) [m], crank.pivot);
        joint guide_pin: revolute(ground(0, -0.2) [m], guide.pivot);
        joint block:     point_on_line(guide.slot, crank.tip);
        joint knee:      revolute(guide.tip, coupler.end);
        joint wrist:     revolute(coupler.start, slider.center);
        joint rail:      prismatic(ground(0, 0.2) [m], slider.center, axis = (1, 0));

        force motor: torque(crank_pin) = drive;
        force cut:   force(slider.center, direction = (1, 0)) = cutting;

        start   { crank_pin.angle [rad] = 360 [deg] - asin(3/4); crank_pin.rate [rad/s] = 15;
                  guide_pin.angle [rad] ~ 0.7; coupler.angle [rad] ~ -0.4; rail.travel [m] ~ -0.02; }
        options { coordinates = auto; redundant = refuse; }
        expect  { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; guide_pin.angle in 41..139 [deg]; }
        output angle [rad] = crank_pin.angle;
        output rate [rad/s] = crank_pin.rate;
        output stroke [m] = slider.center.x;
        output speed [m/s] = slider.center.velocity.x;
    }
}

/// Crank angle at the start, 2π − asin ¾ rad.
pub const START_ANGLE: f64 = 5.435123228198105;

/// Masses (kg) and moments of inertia (kg m²) of crank, guide, coupler and slider, without the crank's inertia, which
/// does no work at constant speed. The same numbers as in the definition.
const PARTS: [(f64, f64); 4] = [(0.368, 0.0), (0.551, 0.00735), (0.105, 0.00107), (2.206, 0.00184)];

/// Force on the slider along +x, N, after `time` seconds at a constant crank speed (rad/s): equation (24).
///
/// Every forward stroke, which runs to −x over π + 2 asin ¾ of the crank, meets 100 N with smooth flanks: the rise takes
/// 15 %, the fall 25 % of it. Otherwise 0.1 N.
pub fn slider_force(time: f64, crank_speed: f64) -> f64 {
    const LEAST: f64 = 0.1;
    const MOST: f64 = 100.0;
    let since = modulo(time, TAU / crank_speed);
    let active = (PI + 2.0 * Real::asin(0.75_f64)) / crank_speed;
    let (rise, fall) = (0.15 * active, 0.25 * active);
    let share = if since < rise {
        0.5 * (1.0 - Real::cos(PI * since / rise))
    } else if since <= active - fall {
        1.0
    } else if since <= active {
        0.5 * (1.0 + Real::cos(PI * (since - (active - fall)) / fall))
    } else {
        0.0
    };
    LEAST + (MOST - LEAST) * share
}

/// What is left of `value` after whole periods, from zero to the period: by functions that bare metal has.
fn modulo(value: f64, period: f64) -> f64 {
    value - period * Real::floor(value / period)
}

/// The mechanism with its crank turning at a constant speed from [`START_ANGLE`] on: its motion and the torque it needs.
///
/// ```
/// use linkwright_models::quick_return::{ConstantSpeed, QuickReturn};
///
/// let model = QuickReturn::default();
/// let mut law = ConstantSpeed::new(&model, 15.0);
/// let torque = law.torque(0.1).expect("the crank can turn freely");
/// assert!(torque.is_finite());
/// ```
#[derive(Clone, Debug)]
pub struct ConstantSpeed<'m> {
    model: &'m QuickReturn,
    crank_speed: f64,
    /// Crank angle and position last found, from which the next is sought.
    near: (f64, [f64; QuickReturn::START.q.len()]),
}

/// Positions, velocities and accelerations of the quick return.
type QuickReturnKinematics = Kinematics<[f64; QuickReturn::START.q.len()], [f64; QuickReturn::START.v.len()]>;

impl<'m> ConstantSpeed<'m> {
    /// The crank at `crank_speed`, rad/s, not zero.
    pub fn new(model: &'m QuickReturn, crank_speed: f64) -> Self {
        ConstantSpeed { model, crank_speed, near: (START_ANGLE, QuickReturn::START.q) }
    }

    /// Crank speed, rad/s.
    pub fn crank_speed(&self) -> f64 {
        self.crank_speed
    }

    /// The motion of the whole mechanism at `time`, s.
    ///
    /// # Errors
    /// As [`AssembleExt::kinematics`].
    pub fn kinematics(&mut self, time: f64) -> Result<QuickReturnKinematics, AssemblyError> {
        /// The crank is turned no further than this in one assembly, rad, so that none lands on another branch.
        const LARGEST_TURN: f64 = 0.2;
        let target = START_ANGLE + self.crank_speed * time;
        let (from, mut near) = self.near;
        // The position repeats itself: the short way round will do.
        let turn = modulo(target - from + PI, TAU) - PI;
        let parts = Real::floor(turn.abs() / LARGEST_TURN) + 1.0;
        for part in 1..parts as u32 {
            let position = target - turn * (1.0 - f64::from(part) / parts);
            let motion = Motion { position, rate: self.crank_speed, acceleration: 0.0 };
            near = self.model.kinematics(time, &near, &[motion])?.q;
        }
        let motion = Motion { position: target, rate: self.crank_speed, acceleration: 0.0 };
        let kinematics = self.model.kinematics(time, &near, &[motion])?;
        self.near = (target, kinematics.q);
        Ok(kinematics)
    }

    /// Crank torque that balances the slider force, N m: M₁ = −f₄ ẋ₄/ω, equation (25).
    ///
    /// # Errors
    /// As [`kinematics`](ConstantSpeed::kinematics).
    pub fn torque_without_inertia(&mut self, time: f64) -> Result<f64, AssemblyError> {
        let kinematics = self.kinematics(time)?;
        let [.., slider] = self.model.motions(time, &kinematics.q, &kinematics.v, &kinematics.a);
        Ok(-slider_force(time, self.crank_speed) * slider.velocity[0] / self.crank_speed)
    }

    /// Crank torque that keeps the crank speed of the rigid mechanism constant, N m:
    /// M₁ = \[−f₄ ẋ₄ + Σ ṙ_i·m_i r̈_i + Σ θ̇_i J_i θ̈_i\]/ω, equation (26).
    ///
    /// # Errors
    /// As [`kinematics`](ConstantSpeed::kinematics).
    pub fn torque(&mut self, time: f64) -> Result<f64, AssemblyError> {
        let kinematics = self.kinematics(time)?;
        let bodies = self.model.motions(time, &kinematics.q, &kinematics.v, &kinematics.a);
        let mut power = -slider_force(time, self.crank_speed) * bodies[3].velocity[0];
        for ((mass, inertia), body) in PARTS.iter().zip(&bodies) {
            let [velocity, acceleration] = [body.velocity, body.acceleration];
            power += mass * (velocity[0] * acceleration[0] + velocity[1] * acceleration[1])
                + inertia * body.rate * body.angular_acceleration;
        }
        Ok(power / self.crank_speed)
    }
}
