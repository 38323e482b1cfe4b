//! Loads: forces and torques on the bodies, by their laws. Gravity and gyroscopic torques are in `system`.

use crate::friction::Friction;
use crate::kinematics::{Kinematics, Place};
use crate::law::{Law, Scratch};
use crate::mesh::Mesh;
use crate::number::{Number, Taylor};
use crate::penalty::Penalty;
use crate::quantity::{Pull, Quantity, nearest, of_point};
use crate::rubbing::Rubbing;
use crate::vector::{dot, norm, times};

#[derive(Clone, Debug)]
pub(crate) struct Load {
    pub name: String,
    pub acts: Acts,
}

#[derive(Clone, Debug)]
pub(crate) enum Acts {
    /// Components along the world's axes at a place, N.
    Force { place: Place, components: [Law; 3] },
    /// `value` along a direction of the world at a place, N.
    Directed { place: Place, direction: [Law; 3], value: Law },
    /// Components along the world's axes on a body, N m.
    Torque { body: usize, components: [Law; 3] },
    /// An effort along a quantity: a torque along an angle, a force along a travel.
    Effort { along: Quantity, value: Law },
    /// The same along an expression of positions.
    Along { expression: Law, value: Law },
    /// −k (f − f₀) − c ḟ along a length or an angle.
    Spring { along: Quantity, stiffness: f64, rest: f64, damping: f64 },
    /// −k f − c ḟ along each way of a bushing.
    Bushing(Vec<Way>),
    /// In place of the rows of a joint.
    Penalty(Box<Penalty>),
    /// A force along each of several gaps.
    Contact(Vec<[Law; 2]>),
    /// The tension max(0, k s(l − l₀)/l₀ + c s′ d(l − l₀)/dt) while l > l₀, against l − l₀.
    Cable(Box<Cable>),
    /// Teeth that give.
    Mesh(Box<Mesh>),
    /// Against the sliding in a joint, by what its multipliers press.
    Friction(Box<Friction>),
    /// The same where a contact presses.
    Rubbing(Box<Rubbing>),
}

/// One of the ways that a bushing is moved or turned, f = Σ factor · quantity.
#[derive(Clone, Debug)]
pub(crate) struct Way {
    pub terms: Vec<(f64, Quantity)>,
    /// Whether it is an angle, in (−π, π].
    pub wrapped: bool,
    /// The whole gap in which it moves freely.
    pub gap: f64,
    pub stiffness: f64,
    pub damping: f64,
}

impl Way {
    pub fn along(&self, at: &Kinematics) -> Taylor {
        let terms = self.terms.iter().map(|(factor, quantity)| quantity.jet(at).along.scaled(*factor));
        let mut along = terms.fold(Taylor::constant(0.0), Taylor::plus);
        if self.wrapped {
            along.value = nearest(along.value, 0.0);
        }
        along
    }

    fn beyond(&self, value: f64) -> f64 {
        value - value.clamp(-0.5 * self.gap, 0.5 * self.gap)
    }

    pub fn effort(&self, along: Taylor) -> f64 {
        -self.stiffness * self.beyond(along.value) - self.damping * along.rate
    }

    pub fn energy(&self, at: &Kinematics) -> f64 {
        0.5 * self.stiffness * self.beyond(self.along(at).value).powi(2)
    }
}

/// An elastic cable that only pulls.
#[derive(Clone, Debug)]
pub(crate) struct Cable {
    /// The sum of the distances from place to place, m.
    pub run: Law,
    /// Its own length, of positions and time, with `run` less it, m.
    pub own: Law,
    pub stretch: Option<Law>,
    pub stiffness: f64,
    pub damping: f64,
    pub pay_out: Option<Law>,
    pub smooth: f64,
}

impl Load {
    /// The forces and torques that it exerts, body by body.
    pub fn evaluate(
        &self,
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
        mut add: impl FnMut(Pull),
    ) {
        match &self.acts {
            Acts::Force { place, components } => {
                let force = [0, 1, 2].map(|k| components[k].value(at, inputs, scratch));
                add(at_place(at, place, force));
            }
            Acts::Directed { place, direction, value } => {
                let direction = [0, 1, 2].map(|k| direction[k].value(at, inputs, scratch));
                let value = value.value(at, inputs, scratch);
                add(at_place(at, place, times(value / norm(direction), direction)));
            }
            Acts::Torque { body, components } => {
                let torque = [0, 1, 2].map(|k| components[k].value(at, inputs, scratch));
                add(Pull::on(Some(*body), [0.0; 3], torque));
            }
            Acts::Effort { along, value } => {
                let value = value.value(at, inputs, scratch);
                pulled(along.jet(at).pulls, value, add);
            }
            Acts::Along { expression, value } => {
                let value = value.value(at, inputs, scratch);
                expression.jet(at, scratch, |pull| pulled([pull], value, &mut add));
            }
            Acts::Spring { along, stiffness, rest, damping } => {
                let jet = along.jet(at);
                let effort = -stiffness * (jet.along.value - rest) - damping * jet.along.rate;
                pulled(jet.pulls, effort, add);
            }
            Acts::Bushing(ways) => {
                for way in ways {
                    let effort = way.effort(way.along(at));
                    for (factor, quantity) in &way.terms {
                        pulled(quantity.jet(at).pulls, factor * effort, &mut add);
                    }
                }
            }
            Acts::Penalty(penalty) => penalty.evaluate(at, add),
            Acts::Contact(meetings) => {
                for [gap, force] in meetings {
                    let force = force.value(at, inputs, scratch);
                    gap.jet(at, scratch, |pull| pulled([pull], force, &mut add));
                }
            }
            Acts::Cable(cable) => cable.evaluate(at, inputs, scratch, add),
            Acts::Mesh(mesh) => mesh.evaluate(at, inputs, scratch, add),
            Acts::Friction(friction) => friction.evaluate(at, inputs, scratch, add),
            Acts::Rubbing(rubbing) => rubbing.evaluate(at, inputs, scratch, add),
        }
    }
}

impl Load {
    /// ż of the deflections of a friction that remembers.
    pub fn bending(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> Vec<f64> {
        match &self.acts {
            Acts::Friction(friction) => friction.bending(at, inputs, scratch),
            Acts::Rubbing(rubbing) => rubbing.bending(at, inputs, scratch),
            _ => Vec::new(),
        }
    }

    /// Effort times rate, and force times velocity, W.
    pub fn power(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        match &self.acts {
            Acts::Effort { along, value } => value.value(at, inputs, scratch) * along.jet(at).along.rate,
            Acts::Along { expression, value } => {
                value.value(at, inputs, scratch) * expression.course(at, scratch).rate
            }
            Acts::Contact(meetings) => {
                let power =
                    |[gap, force]: &[Law; 2]| force.value(at, inputs, scratch) * gap.course(at, scratch).rate;
                meetings.iter().map(power).sum()
            }
            Acts::Spring { along, stiffness, rest, damping } => {
                let along = along.jet(at).along;
                -(stiffness * (along.value - rest) + damping * along.rate) * along.rate
            }
            Acts::Bushing(ways) => {
                let power = |way: &Way| {
                    let along = way.along(at);
                    way.effort(along) * along.rate
                };
                ways.iter().map(power).sum()
            }
            Acts::Penalty(penalty) => penalty.power(at),
            Acts::Friction(friction) => friction.power(at, inputs, scratch),
            Acts::Rubbing(rubbing) => rubbing.power(at, inputs, scratch),
            Acts::Force { place, .. } | Acts::Directed { place, .. } => {
                let mut force = [0.0; 3];
                self.evaluate(at, inputs, scratch, |pull| force = pull.linear);
                dot(force, at.point(place).velocity)
            }
            Acts::Torque { .. } | Acts::Cable(_) | Acts::Mesh(_) => {
                let mut power = 0.0;
                self.evaluate(at, inputs, scratch, |pull| {
                    let frame = at.frame(pull.body);
                    power += dot(pull.linear, frame.velocity) + dot(pull.angular, frame.spin);
                });
                power
            }
        }
    }
}

fn at_place(at: &Kinematics, place: &Place, force: [f64; 3]) -> Pull {
    let point = at.point(place);
    of_point(&point, force)
}

pub(crate) fn pulled(pulls: impl IntoIterator<Item = Pull>, effort: f64, mut add: impl FnMut(Pull)) {
    for pull in pulls {
        add(pull.scaled(effort));
    }
}

impl Cable {
    fn evaluate(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch, mut add: impl FnMut(Pull)) {
        let run = self.run.course(at, scratch);
        let own = self.own.value(at, inputs, scratch);
        let stretch = run.value - own;
        // s and s′, rounded by a parabola across the width.
        let half = 0.5 * self.smooth;
        let (beyond, taut) = if stretch > half {
            (stretch, 1.0)
        } else if stretch <= -half {
            (0.0, 0.0)
        } else {
            ((stretch + half) * (stretch + half) / (2.0 * self.smooth), stretch / self.smooth + 0.5)
        };
        let mut tension = self.stiffness * beyond / own;
        if self.damping != 0.0 {
            let rate = match (&self.pay_out, &self.stretch) {
                (Some(rate), _) => run.rate - rate.value(at, inputs, scratch),
                (None, Some(stretch)) => stretch.course(at, scratch).rate,
                (None, None) => run.rate,
            };
            tension += self.damping * taut * rate;
        }
        // What winds it up by positions feels it: the force acts along l − l₀ where l₀ is of positions.
        let along = self.stretch.as_ref().unwrap_or(&self.run);
        let effort = -tension.max(0.0);
        along.jet(at, scratch, |pull| pulled([pull], effort, &mut add));
    }
}
