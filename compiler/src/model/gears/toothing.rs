//! One toothing: its circles, and where its teeth stand.
//!
//! Involute teeth by the basic rack, all of the transverse section: m_t = m/cos β, tan α_t = tan α/cos β, r = m_t z/2,
//! r_b = r cos α_t (ISO 21771, sections 4 and 5). What lies further out on an external wheel lies further in on a ring.

use crate::forms::{Rim, ToothingForm};
use crate::model::{BodyId, Name, Place};

/// Which toothing of which body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToothingId {
    pub body: BodyId,
    pub index: usize,
}

/// A toothing of a body, in SI.
#[derive(Clone, Debug)]
pub struct Toothing {
    pub name: Name,
    /// `sun.rim`.
    pub text: String,
    pub form: &'static ToothingForm,
    /// Its centre, in its body.
    pub center: Place,
    /// z, a whole number; of a worm its starts, of a rack none.
    pub teeth: f64,
    /// m, of the normal section, of a worm along its axis.
    pub module: f64,
    /// α, of the normal section.
    pub pressure_angle: f64,
    /// β.
    pub helix: f64,
    /// x, in modules.
    pub shift: f64,
    /// In modules.
    pub addendum: f64,
    pub dedendum: f64,
    /// Angle of a tooth's middle in the axes of the body.
    pub first: f64,
    /// δ, half the angle of the pitch cone of a bevel gear.
    pub cone: f64,
    /// d of a worm.
    pub diameter: f64,
    /// The direction of a rack's line, in the axes of its body, of length one.
    pub along: [f64; 3],
    pub face_width: Option<f64>,
    /// Diameter of the hole in a wheel.
    pub bore: Option<f64>,
}

impl Toothing {
    pub fn is_internal(&self) -> bool {
        self.form.rim == Rim::Internal
    }

    /// A wheel or ring, whose teeth stand around an axis at one distance.
    pub fn is_cylindrical(&self) -> bool {
        matches!(self.form.rim, Rim::External | Rim::Internal)
    }

    /// γ of a worm, tan γ = z m/d.
    pub fn lead_angle(&self) -> f64 {
        libm::atan2(self.teeth * self.module, self.diameter)
    }

    /// The spur gear that a bevel gear is like at the outer end of its teeth: z/cos δ teeth, which need not be a whole number (Tredgold).
    pub fn virtual_spur(&self) -> Toothing {
        Toothing { teeth: self.teeth / libm::cos(self.cone), ..self.clone() }
    }

    /// m_t.
    pub fn transverse_module(&self) -> f64 {
        self.module / libm::cos(self.helix)
    }

    /// α_t.
    pub fn transverse_angle(&self) -> f64 {
        libm::atan(libm::tan(self.pressure_angle) / libm::cos(self.helix))
    }

    /// β_b, tan β_b = tan β cos α_t.
    pub fn base_helix(&self) -> f64 {
        libm::atan(libm::tan(self.helix) * libm::cos(self.transverse_angle()))
    }

    pub fn pitch_radius(&self) -> f64 {
        0.5 * self.transverse_module() * self.teeth
    }

    pub fn base_radius(&self) -> f64 {
        self.pitch_radius() * libm::cos(self.transverse_angle())
    }

    /// Of the circle that teeth end at. The shift moves all of the profile outwards, of a ring too.
    pub fn tip_radius(&self) -> f64 {
        let height = self.module * self.addendum;
        let shift = self.module * self.shift;
        self.pitch_radius() + shift + if self.is_internal() { -height } else { height }
    }

    /// Of the circle that teeth stand on.
    pub fn root_radius(&self) -> f64 {
        let depth = self.module * self.dedendum;
        let shift = self.module * self.shift;
        self.pitch_radius() + shift + if self.is_internal() { depth } else { -depth }
    }

    /// What is drawn of it, with names: nothing of a rack, whose line is drawn already.
    pub fn circles(&self) -> Vec<(&'static str, f64)> {
        let height = self.module * self.addendum;
        match self.form.rim {
            Rim::External | Rim::Internal => vec![
                ("base circle", self.base_radius()),
                ("pitch circle", self.pitch_radius()),
                ("tip circle", self.tip_radius()),
            ],
            Rim::Rack => Vec::new(),
            Rim::Bevel => {
                let pitch = self.pitch_radius();
                vec![("pitch circle", pitch), ("tip circle", pitch + height * libm::cos(self.cone))]
            }
            Rim::Worm => {
                let pitch = 0.5 * self.diameter;
                vec![("pitch circle", pitch), ("tip circle", pitch + height)]
            }
        }
    }

    /// The least number of teeth that is not undercut, 2 (h_a* − x) cos β/sin² α_t.
    pub fn least_teeth(&self) -> f64 {
        let sine = libm::sin(self.transverse_angle());
        2.0 * (self.addendum - self.shift) * libm::cos(self.helix) / (sine * sine)
    }

    /// Half the angle of a tooth at the pitch circle, π/2z + 2 x tan α/z: the same for the space of a ring.
    pub fn half_tooth(&self) -> f64 {
        let shift = 2.0 * self.shift * libm::tan(self.pressure_angle);
        let shift = if self.is_internal() { -shift } else { shift };
        (std::f64::consts::FRAC_PI_2 + shift) / self.teeth
    }
}

/// inv α = tan α − α.
pub fn involute(angle: f64) -> f64 {
    libm::tan(angle) - angle
}

/// The angle of an involute: Newton's method, whose steps are (inv α − y)/tan² α.
pub fn angle_of_involute(value: f64) -> Option<f64> {
    if !(0.0..=10.0).contains(&value) {
        return None;
    }
    let mut angle = libm::cbrt(3.0 * value).min(1.4);
    for _ in 0..50 {
        let tangent = libm::tan(angle);
        let step = (tangent - angle - value) / (tangent * tangent);
        angle -= step;
        if !(1e-9..1.57).contains(&angle) {
            return (value == 0.0).then_some(0.0);
        }
        if step.abs() < 1e-16 {
            break;
        }
    }
    Some(angle)
}
