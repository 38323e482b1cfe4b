//! What anyone may know of a kind of joint.

use super::{Form, Positional, Space};

/// A kind of joint, without its equations.
#[derive(Debug)]
pub struct JointForm {
    /// How it is written.
    pub call: Form,
    /// What it keeps, for documents.
    pub holds: &'static str,
    /// Names of its angles and of their rates.
    pub angles: &'static [[&'static str; 2]],
    /// Names of its travels and of their speeds.
    pub travels: &'static [[&'static str; 2]],
    /// How many independent motions it leaves.
    pub freedoms: usize,
    /// Whether its places stay together.
    pub keeps_place: bool,
    /// Whether its bodies do not turn against each other.
    pub keeps_orientation: bool,
    pub axes: JointAxes,
    pub spans: Spans,
    /// Whether it can pull its places together and not push them apart.
    pub only_pulls: bool,
    /// Where a body without orientation may stand.
    pub of_particle: OfParticle,
    /// How a body moves that hangs on it alone.
    pub alone: Alone,
    /// Joints that leave more freedom.
    pub freer: &'static [Freer],
    /// What its surfaces slide on, where friction can act in it.
    pub bearing: Option<Bearing>,
    /// What its arguments may not be, beyond their dimensions: the name of the one at fault, and why.
    pub refuses: Option<Refuses>,
}

impl JointForm {
    /// Whether its first place is a line.
    pub fn has_line(&self) -> bool {
        self.call.positional.contains(&Positional::Line)
    }

    /// The name of what it exerts as one quantity, if it has one.
    pub fn effort(&self) -> Option<&'static str> {
        match self.spans {
            Spans::Rod => Some("tension"),
            Spans::Outline | Spans::Curve => Some("force"),
            Spans::Nothing | Spans::Rail | Spans::Line => None,
        }
    }

    /// Whether it keeps a shift from its places: it has fewer travels than the space has dimensions.
    pub fn holds_shifts(&self, space: Space) -> bool {
        self.travels.len() < space.dimensions()
    }

    /// Whether it keeps a turn from its bodies, which particles do not have.
    pub fn holds_turns(&self) -> bool {
        self.of_particle == OfParticle::Neither
    }

    /// Whether its travel follows its angle.
    pub fn winds(&self) -> bool {
        self.freedoms < self.angles.len() + self.travels.len()
    }

    /// Whether its second body is drawn as a block on a rail.
    pub fn is_block(&self) -> bool {
        self.spans == Spans::Rail && self.keeps_orientation
    }
}

/// The surfaces of a joint that slide on each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bearing {
    /// A pin in its hole: about its one angle.
    Pin,
    /// Two pins that cross: about both angles.
    Cross,
    /// A ball in its socket: about any axis.
    Ball,
    /// The balls of a joint between shafts that keep their speed: about any axis, pressed by the torque that they hand on too.
    Knuckle,
    /// A rail: along its travel.
    Rail,
    /// A rod in a sleeve: along its travel and about its angle.
    Sleeve,
    /// One point: along its travel.
    Point,
    /// A face on a plane: along both of its travels and about its angle.
    Face,
    /// One point on a plane: along two directions of it.
    Spot,
    /// One point on a curve: along it.
    Curve,
    /// A nut on its thread: along that.
    Thread,
}

impl Bearing {
    /// Whether its surfaces turn on each other and do not shift: friction is then a torque, by a radius.
    pub fn turns(self) -> bool {
        matches!(self, Self::Pin | Self::Cross | Self::Ball | Self::Knuckle)
    }

    /// Along how many coordinates its surfaces slide; of a sleeve or face along one less where nothing says its radius.
    pub fn slides(self, radius: bool) -> usize {
        match self {
            Self::Pin | Self::Rail | Self::Point | Self::Curve | Self::Thread => 1,
            Self::Sleeve => 1 + usize::from(radius),
            Self::Face => 2 + usize::from(radius),
            Self::Cross | Self::Spot => 2,
            Self::Ball | Self::Knuckle => 3,
        }
    }

    /// Whether its surfaces shift as well as turn on each other: what turns takes part by a radius.
    pub fn turns_too(self) -> bool {
        matches!(self, Self::Sleeve | Self::Face | Self::Thread)
    }

    /// Whether friction resists the size of the sliding along all coordinates, and not each by itself.
    pub fn slides_as_one(self) -> bool {
        matches!(self, Self::Sleeve | Self::Ball | Self::Knuckle | Self::Face | Self::Spot)
    }
}

/// What lies between the places of a joint, for those who draw it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spans {
    Nothing,
    /// A rod from the one to the other, as long as the first of its arguments says.
    Rod,
    /// A rail along its axis.
    Rail,
    /// The line of the first.
    Line,
    /// A closed curve about the first, on which the second rolls.
    Outline,
    /// A curve about the first, on which the second is.
    Curve,
}

/// Whose the directions of a joint are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointAxes {
    None,
    /// One, the same in the axes of both places.
    Common,
    /// One, in the axes of the first place.
    OfFirst,
    /// Two, one of each place.
    OfEach,
}

/// Which places of a joint may be those of a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfParticle {
    Neither,
    /// The second: the first carries what the second is measured in.
    Second,
    Any,
}

/// How a body moves that hangs on a joint alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alone {
    Turns,
    Slides,
    TurnsAndSlides,
    Otherwise,
}

/// A joint that holds what another holds but for a number of turns and of shifts.
#[derive(Clone, Copy, Debug)]
pub struct Freer {
    pub turns: usize,
    pub shifts: usize,
    pub joint: &'static str,
}

/// The name of the argument at fault, and why.
pub type Refuses = fn(&Given) -> Option<(&'static str, String)>;

/// The arguments of a joint as numbers, at the defaults of parameters; `None` where they are not known.
#[derive(Clone, Debug)]
pub struct Given<'a> {
    /// Of the joint.
    pub name: &'a str,
    pub directions: Vec<Option<[f64; 3]>>,
    pub scalars: Vec<Option<f64>>,
}

/// The angle between two directions.
pub fn degrees_between(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let across = libm::sqrt(cross.iter().map(|x| x * x).sum());
    libm::atan2(across, dot).to_degrees()
}
