//! Whether moments of inertia can belong to the mass and size of their bodies: the radius of gyration √(I/m) beside the
//! places that a body has, and the density that a body of that radius would have. A moment out of proportion is most often
//! a slip of units, mm² for m².

use super::rules::at_defaults;
use crate::messages::Disproportion;
use crate::model::{Body, Frame, Mechanism, Place, Vector};

/// How often the radius of gyration may be as large as the body reaches from its centre of mass. Solid bodies have at most 1;
/// a flywheel with a small crank, or a rotor with its gear's ratio in it, has 20 to 30.
const MOST_REACHES: f64 = 50.0;
/// Mass by the cube of the radius of gyration, kg/m³, above which a body is as dense as real ones are, however small the
/// places on it: the eccentric of a rotor may be a ten-thousandth of its radius. Air has 1.2, and mm² for m² divides by 10⁹.
const LEAST_DENSITY: f64 = 1e-2;

/// Units of moments of inertia, in kg m², that are taken for one another, and what each is short of the kg m².
const UNITS: [(&str, f64); 5] =
    [("g*m^2", 1e-3), ("kg*cm^2", 1e-4), ("kg*mm^2", 1e-6), ("g*cm^2", 1e-7), ("g*mm^2", 1e-9)];

/// The places at which joints and loads attach to each body.
pub(super) fn attached(mechanism: &Mechanism) -> Vec<Vec<&Place>> {
    let mut attached = vec![Vec::new(); mechanism.bodies.len()];
    let joints = mechanism.joints.iter().flat_map(|joint| [&joint.first, &joint.second]);
    for place in joints.chain(mechanism.loads.iter().flat_map(|load| load.places())) {
        if let Frame::Body(id) = place.frame {
            attached[id.0].push(place);
        }
    }
    attached
}

/// The disproportion of a body with places off its centre, at the defaults of parameters. Too small a moment is not
/// spoken of: a ball on a long wire has one, and zero is that of a point.
pub(super) fn disproportion(
    mechanism: &Mechanism,
    body: &Body,
    attached: &[&Place],
) -> Option<Disproportion> {
    let value = |expr| at_defaults(mechanism, expr);
    let mass = value(&body.mass).filter(|mass| *mass > 0.0)?;
    let moment = body.inertia.moments.iter().filter_map(value).fold(0.0, f64::max);
    let reach = reach(mechanism, body, attached).filter(|reach| *reach > 0.0)?;
    let gyration = (moment / mass).sqrt();
    let disproportionate = gyration > MOST_REACHES * reach && mass < LEAST_DENSITY * gyration.powi(3);
    // A plate of the size of the body has about a third of m r².
    let misfit = |unit: &f64| (3.0 * moment * unit / (mass * reach * reach)).ln().abs();
    let fits = UNITS.iter().min_by(|(_, one), (_, other)| misfit(one).total_cmp(&misfit(other)));
    fits.filter(|_| disproportionate).map(|(unit, _)| Disproportion { moment, mass, gyration, reach, unit })
}

/// The largest distance from the centre of mass of what is known to be of the body, m: points, markers and lines, its shape, and
/// where joints and loads attach.
fn reach(mechanism: &Mechanism, body: &Body, attached: &[&Place]) -> Option<f64> {
    let at = |vector: &Vector| -> Option<[f64; 3]> {
        let [x, y, z] = vector.each_ref().map(|component| at_defaults(mechanism, component));
        Some([x?, y?, z?])
    };
    let center = at(&body.center)?;
    let own = body.points.iter().chain(&body.markers).map(|place| &place.at);
    let lines = body.lines.iter().flat_map(|line| [&line.from, &line.to]);
    let places = own.chain(lines).chain(attached.iter().map(|place| &place.at));
    let distances = places.filter_map(at).map(|place| {
        let [x, y, z] = [0, 1, 2].map(|axis| place[axis] - center[axis]);
        (x * x + y * y + z * z).sqrt()
    });
    // To a corner of the shape, whose centre may be elsewhere only as far as its own points tell.
    let dimensions = body.dimensions.iter().filter_map(|(name, length)| {
        let length = at_defaults(mechanism, length)?;
        Some(if *name == "radius" { length } else { length / 2.0 })
    });
    let corner = dimensions.map(|half| half * half).sum::<f64>().sqrt();
    Some(distances.fold(corner, f64::max))
}
