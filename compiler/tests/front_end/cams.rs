//! Cams as joints and bounds of forces: what is refused, and why.

use crate::bad;

const ROUND: &str = "(0, 0), (60, 4), (120, 8), (180, 8), (240, 8), (300, 4), (360, 0)";
const HOLLOW: &str = "(0, 0), (60, 8), (120, 0), (180, 8), (240, 0), (300, 8), (360, 0)";

fn cam(knots: &str, joint: &str, rest: &str) -> String {
    format!(
        "planar Cam {{
            gravity [m/s^2] = (0, -9.81);
            table lobe(angle [deg]) [mm] = [{knots}], periodic;
            disk cam {{ mass [kg] = 1; radius [mm] = 20; }}
            body follower {{ mass [kg] = 0.3; inertia [kg*m^2] = 0; }}
            joint shaft: revolute(ground(0, 0) [m], cam.center);
            joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
            joint follow: cam(cam.center, follower.center, {joint};
            force spring: force(rail) = -30 [N];
            start {{ rail.travel [mm] ~ 40; }}
            {rest}
        }}"
    )
}

/// Its one message has this in it.
#[track_caller]
fn only(source: &str, expected: &str) {
    let found = bad(source);
    let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
    assert!(matches!(found[..], [message] if message.contains(expected)), "{found:?}, not {expected}");
}

#[test]
fn a_cam_is_a_curve_that_its_roller_follows() {
    for (knots, joint, expected) in [
        (
            HOLLOW,
            "lift = lobe, base [mm] = 10, radius [mm] = 25)",
            "the roller would not follow it there but touch at two places at once (undercutting); make the roller smaller than that, or the base larger",
        ),
        (
            ROUND,
            "lift = lobe, base [mm] = 30, radius [mm] = -2)",
            "the roller of `follow` has a radius of -2 mm: it is positive, and left out for a knife edge",
        ),
        (
            ROUND,
            "lift = lobe, base [mm] = -4)",
            "the radius of `follow` is -4 mm at 0 deg: a profile goes around its place",
        ),
        (ROUND, "lift = 3, base [mm] = 30)", "`lift` of a profile is the name of a table of the angle"),
        (
            ROUND,
            "lift = lobe, base [mm] = 30) = penalty(stiffness [N/m] = 1e6)",
            "a cam that yields is a contact: write `surface`s, a `profile` and a `circle`, and `contact follow: between(…, …) = kelvin_voigt(",
        ),
    ] {
        only(&cam(knots, joint, ""), expected);
    }
}

#[test]
fn bounds_are_of_forces_that_drivers_decide() {
    let motor = "drive motor: shaft.angle = 90 [rad/s]*time;";
    for (rest, expected) in [
        (
            format!("{motor} expect {{ rail.travel > 0 [m]; }}"),
            "`rail.travel` is a length, and a bound along the motion is that of a force or torque, such as `follow.force > 0`; of a coordinate write a range, `rail.travel in 0..8 [mm]`",
        ),
        (
            "expect { follow.force > 0; }".to_string(),
            "`follow.force` depends on how fast the mechanism moves, and no driver says so: add one, such as `drive motor: shaft.angle = 100 [rad/s]*time;`",
        ),
        (
            format!(
                "{motor} state heat [J] = 0; rate heat = 1 [W]; output warm [J] = heat; expect {{ follow.force > 0; }}"
            ),
            "`follow.force` is followed along the motion that drivers fix, and the states of this mechanism do not follow from that: leave this out of `expect`, and watch `follow.force` as an output",
        ),
        (
            format!("{motor} expect {{ follow.force > 3 [m]; }}"),
            "`follow.force` is given a length: expected N, found m",
        ),
    ] {
        only(&cam(ROUND, "lift = lobe, base [mm] = 30, radius [mm] = 5)", &rest), expected);
    }
}
