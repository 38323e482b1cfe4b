//! Surfaces are drawn where they are: every corner of their lines is at the distance that their kind says.

use linkwright_compiler::page::{Pose, drawing_at, scene};
use linkwright_compiler::{Compiled, compile};

const IN_THE_PLANE: &str = "planar Yard {
    body ram { mass [kg] = 1; inertia [kg*m^2] = 1; point nose [m] = (0.3, 0.1);
        surface bump: circle(ram.nose, radius [m] = 0.2);
        surface slot: hole(ram.center, radius [m] = 0.4);
        surface rail: segment(ram.center, ram.nose, radius [m] = 0.05);
        surface tip: point(ram.nose); }
    disk ball { mass [kg] = 1; radius [m] = 0.1; }
    surface slope: half_plane(line(ground(0, -5) [m], ground(3, -1) [m]));
    surface edge: segment(ground(6, -1) [m], ground(7, -1) [m]);
    surface step: polygon(ground(4, -6) [m], ground(6, -6) [m], ground(5, -4) [m]);
    contact a: between(ram.bump, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact b: between(ball.surface, ram.slot) = kelvin_voigt(stiffness [N/m] = 1);
    contact c: between(ball.surface, step) = kelvin_voigt(stiffness [N/m] = 1);
    contact d: between(ball.surface, edge) = kelvin_voigt(stiffness [N/m] = 1);
    contact e: between(ram.tip, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact f: between(ram.rail, slope) = kelvin_voigt(stiffness [N/m] = 1);
    start { ram.angle [deg] = 90; ram.center.x [m] = 1; ram.center.y [m] = 2; ball.center.x [m] = 1.1; ball.center.y [m] = 2.1; }
}";

const IN_SPACE: &str = "spatial Yard {
    sphere ball { mass [kg] = 1; radius [m] = 0.1; }
    body ram { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); point nose [m] = (0.3, 0.1, 0);
        surface knob: sphere(ram.nose, radius [m] = 0.2);
        surface rod: capsule(ram.center, ram.nose, radius [m] = 0.05);
        surface wheel: disk_rim(ram.center, axis = (0, 3, 4), radius [m] = 0.5); }
    surface slope: plane(ground(0, 0, -5) [m], axis = (0, 3, 4));
    surface cup: ball_socket(ground(3, 0, 0) [m], radius [m] = 0.6);
    surface tube: bore(ground(3, 0, 0) [m], axis = (1, 0, 0), radius [m] = 0.7, length [m] = 2);
    surface pipe: bore(ground(3, 0, 0) [m], axis = (1, 0, 0), radius [m] = 0.8);
    surface drum: cylinder(ground(0, 8, 0) [m], axis = (0, 0, 1), radius [m] = 0.3, length [m] = 1);
    contact a: between(ball.surface, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact b: between(ram.knob, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact c: between(ram.rod, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact d: between(ram.wheel, slope) = kelvin_voigt(stiffness [N/m] = 1);
    contact e: between(ball.surface, cup) = kelvin_voigt(stiffness [N/m] = 1);
    contact f: between(ball.surface, tube) = kelvin_voigt(stiffness [N/m] = 1);
    contact g: between(ball.surface, pipe) = kelvin_voigt(stiffness [N/m] = 1);
    contact h: between(ball.surface, drum) = kelvin_voigt(stiffness [N/m] = 1);
    start { ball.center.x [m] = 3; ball.center.y [m] = 0; ball.center.z [m] = 0; ram.center.x [m] = 0; ram.center.y [m] = 0; ram.center.z [m] = 1; }
}";

fn compiled(source: &str) -> Compiled {
    compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"))
}

type Point = [f64; 3];

/// Lines of a surface in the axes of what it is on, and which body that is; nothing of a point.
fn lines(compiled: &Compiled, name: &str, far: Option<Point>) -> Option<(Option<usize>, Vec<Vec<Point>>)> {
    let pose = Pose::start(compiled);
    let scene = scene::scene(compiled, &pose, std::iter::once(pose.q.as_slice()), far.into_iter());
    let surface = scene.surfaces.iter().find(|it| it.name == name)?;
    let lines = surface.lines.iter().map(|line| line.iter().map(|spot| spot.at).collect());
    Some((surface.lines[0][0].body, lines.collect()))
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn less(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn size(a: Point) -> f64 {
    dot(a, a).sqrt()
}

/// From the stretch between two places.
fn from_stretch(at: Point, [a, b]: [Point; 2]) -> f64 {
    let way = less(b, a);
    let share = (dot(less(at, a), way) / dot(way, way)).clamp(0.0, 1.0);
    size(less(at, [0, 1, 2].map(|k| a[k] + share * way[k])))
}

fn all_at(lines: &[Vec<Point>], wanted: f64, distance: impl Fn(Point) -> f64) {
    for at in lines.iter().flatten() {
        assert!((distance(*at) - wanted).abs() < 1e-12, "{at:?} is {} away, not {wanted}", distance(*at));
    }
}

#[test]
fn surfaces_in_the_plane_are_where_they_touch() {
    let yard = compiled(IN_THE_PLANE);
    let of = |name: &str| lines(&yard, name, None).unwrap_or_else(|| panic!("{name} is drawn"));
    let nose = [0.3, 0.1, 0.0];
    for (name, body, center, radius) in
        [("ram.bump", Some(0), nose, 0.2), ("ram.slot", Some(0), [0.0; 3], 0.4)]
    {
        let (on, lines) = of(name);
        assert_eq!((on, lines.len()), (body, 1));
        all_at(&lines, radius, |at| size(less(at, center)));
    }
    all_at(&of("ram.rail").1, 0.05, |at| from_stretch(at, [[0.0; 3], nose]));
    assert_eq!(of("edge").1, [[[6.0, -1.0, 0.0], [7.0, -1.0, 0.0]]]);
    assert_eq!(of("step").1[0].len(), 4);
    // A line through the ground's places, and strokes on its solid side.
    let normal = [-0.8, 0.6, 0.0];
    let height = |at: Point| dot(less(at, [0.0, -5.0, 0.0]), normal);
    let (on, slope) = of("slope");
    assert_eq!(on, None);
    all_at(&slope[..1], 0.0, height);
    assert!(slope[1..].iter().all(|stroke| height(stroke[0]).abs() < 1e-12 && height(stroke[1]) < -1e-3));
    assert!(slope.len() > 20);
    // It reaches as far as something comes.
    let length = |slope: &[Vec<Point>]| size(less(slope[0][1], slope[0][0]));
    let longer = lines(&yard, "slope", Some([60.0, 75.0, 0.0])).expect("it is drawn").1;
    assert!(length(&longer) > 90.0 && length(&slope) < 30.0, "{} {}", length(&longer), length(&slope));
    assert!(lines(&yard, "ram.tip", None).is_none(), "its body shows a point");
    let svg = drawing_at(&yard, &Pose::start(&yard)).svg;
    for name in ["ram.bump", "ram.slot", "ram.rail", "slope", "edge", "step"] {
        assert!(svg.contains(&format!("<title>{name}</title>")), "{name}");
    }
}

#[test]
fn surfaces_in_space_are_where_they_touch() {
    let yard = compiled(IN_SPACE);
    let of = |name: &str| lines(&yard, name, None).unwrap_or_else(|| panic!("{name} is drawn"));
    let nose = [0.3, 0.1, 0.0];
    for (name, center, radius) in [("ram.knob", nose, 0.2), ("cup", [3.0, 0.0, 0.0], 0.6)] {
        let (_, lines) = of(name);
        assert_eq!(lines.len(), 3);
        all_at(&lines, radius, |at| size(less(at, center)));
    }
    all_at(&of("ram.rod").1, 0.05, |at| from_stretch(at, [[0.0; 3], nose]));
    let (on, wheel) = of("ram.wheel");
    assert_eq!(on, Some(1));
    all_at(&wheel, 0.5, size);
    all_at(&wheel, 0.0, |at| dot(at, [0.0, 0.6, 0.8]));
    let slope = of("slope").1;
    let height = |at: Point| dot(less(at, [0.0, 0.0, -5.0]), [0.0, 0.6, 0.8]);
    all_at(&slope[..1], 0.0, height);
    assert!(height(slope[1][1]) > 0.1, "its normal points to the free side");
    let around = |at: Point| (at[1] * at[1] + at[2] * at[2]).sqrt();
    for (name, radius) in [("tube", 0.7), ("pipe", 0.8)] {
        all_at(&of(name).1, radius, around);
    }
    all_at(&of("tube").1, 1.0, |at| (at[0] - 3.0).abs());
    assert!(of("pipe").1.iter().flatten().any(|at| (at[0] - 3.0).abs() > 2.0), "it has no end");
    all_at(&of("drum").1, 0.3, |at| (at[0] * at[0] + (at[1] - 8.0) * (at[1] - 8.0)).sqrt());
    all_at(&of("drum").1, 0.5, |at| at[2].abs());
}

#[test]
fn a_curve_of_a_joint_is_drawn_where_its_point_is() {
    let wires = compiled(
        "planar Wires {
            body plate { mass [kg] = 1; inertia [kg*m^2] = 1; point corner [m] = (0.3, 0.1); }
            particle bead { mass [kg] = 1; } particle ring { mass [kg] = 1; }
            joint pin: revolute(ground(2, 1) [m], plate.center);
            joint wire: point_on_curve(plate.corner, bead.center, y = 2 [1/m]*wire.parameter*wire.parameter);
            joint oval: point_on_curve(ground(1, 0) [m], ring.center, x = 0.5 [m]*cos(oval.parameter/0.5 [m]), y = 0.3 [m]*sin(oval.parameter/0.5 [m]));
            start { pin.angle [deg] = 40; wire.parameter [m] = 0.2; oval.parameter [m] = 0.4; }
        }",
    );
    let (on, wire) = lines(&wires, "wire", None).expect("it is drawn");
    assert_eq!((on, wire.len()), (Some(0), 1));
    all_at(&wire, 0.0, |at| at[1] - 0.1 - 2.0 * (at[0] - 0.3) * (at[0] - 0.3));
    assert!(wire[0].len() > 20, "{}", wire[0].len());
    let (on, oval) = lines(&wires, "oval", None).expect("it is drawn");
    assert_eq!(on, None);
    all_at(&oval, 1.0, |at| ((at[0] - 1.0) / 0.5).hypot(at[1] / 0.3));
}
