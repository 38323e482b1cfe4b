//! What is named when a loop does not close, and loops that close though they were once said not to.

use crate::put_together;

/// A four-bar that closes with its rocker from 57 to 122 degrees, on either side.
#[test]
fn a_guess_out_of_reach_is_met_as_well_as_can_be() {
    for (guess, nearest) in [(46.789, 57.0), (50.0, 57.0), (90.0, 90.0), (150.0, 122.0)] {
        let start = put_together(&format!(
            "planar Closable {{
                rod crank   {{ mass [kg] = 1; length [m] = 0.742245195; }}
                rod coupler {{ mass [kg] = 1; length [m] = 2.810760918; }}
                rod rocker  {{ mass [kg] = 1; length [m] = 1.579509311; }}
                joint pin:   revolute(ground(0, 0) [m], crank.start);
                joint knee:  revolute(crank.end, coupler.start);
                joint wrist: revolute(coupler.end, rocker.end);
                joint foot:  revolute(ground(2.421823800, 0) [m], rocker.start);
                start {{ foot.angle [deg] ~ {guess}; }}
            }}"
        ));
        let start = start.unwrap_or_else(|message| panic!("{guess}: {message}"));
        let q = &start.assembly.q;
        let pairs = q.chunks(2).map(|pair| pair[1].atan2(pair[0]).to_degrees());
        assert!(
            pairs.clone().any(|angle| (angle - nearest).abs() < 1.0),
            "{guess}: {:?}",
            pairs.collect::<Vec<_>>()
        );
    }
}

fn in_space(crank_axis: &str, knee: &str) -> String {
    format!(
        "spatial Loop {{
            body crank   {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1);
                            marker far [m] = (1, 0, 0), axis = {crank_axis}, reference = (1, 0, 0); }}
            body coupler {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point far [m] = (2, 0, 0); }}
            body rocker  {{ mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point far [m] = (1.5, 0, 0); }}
            joint pin:   revolute(ground(0, 0, 0) [m], crank.origin, axis = (0, 0, 1));
            joint knee:  revolute(crank.far, coupler.origin, axis = {knee});
            joint wrist: revolute(coupler.far, rocker.far, axis = (0, 0, 1));
            joint foot:  revolute(ground(2, 0, 0) [m], rocker.origin, axis = (0, 0, 1));
            start {{ pin.angle [deg] ~ 60; }}
            options {{ redundant = drop; }}
        }}"
    )
}

#[test]
fn an_axis_off_parallel_is_named_in_degrees() {
    assert!(put_together(&in_space("(0, 0, 1)", "(0, 0, 1)")).is_ok());
    let tilted = in_space("(0, sin(0.1 [deg]), cos(0.1 [deg]))", "(0, 0, 1)");
    let message = put_together(&tilted).expect_err("the axes are not parallel");
    for part in [
        "\"wrist\" is still 0.1 degrees off its direction",
        "On \"crank\" the axes of \"knee\" and \"pin\" are 0.1 degrees off parallel",
    ] {
        assert!(message.contains(part), "{message}");
    }
    assert!(!message.contains("cannot close") && !message.contains("SI"), "{message}");
}

#[test]
fn an_axis_beside_a_marker_is_explained() {
    let message = put_together(&in_space("(0, 1, 0)", "(0, 1, 0)")).expect_err("the axes are not parallel");
    assert!(
        message.contains(
            "The `axis` of \"knee\" is read in the axes of its places, those of the marker `crank.far`"
        ),
        "{message}"
    );
}
