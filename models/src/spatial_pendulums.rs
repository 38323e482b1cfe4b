//! One bar on one joint, for every kind of joint in space.
//!
//! Source: Project Chrono's unit tests `utest_JOINT_*` and the MSC ADAMS models beside them (projectchrono/chrono @7689fbc0,
//! data/testing/joints): 1 kg, centre 2 m from the joint, moments of inertia 0.04 kg m² along the bar and 0.1 across,
//! g = 9.80665 m/s² along −z, at rest, 5 s: Revolute_Case01, Spherical_Case01, Cylindrical_Case01 and Case02,
//! Prismatic_Case01, Universal_Case01, Distance_Case01. The other kinds are ours, with the same bar. Expected: revolute,
//! spherical, cylindrical (Case02) and universal swing alike, θ̈ = (2 g/4.1) cos θ below the horizontal; a prismatic or
//! cylindrical joint along z falls freely, a screw along z of pitch p with z̈ = −g/(1 + 4.1 (2π/p)²); the distance's bar
//! swings as a point, θ̈ = (g/2) cos θ; the planar one falls and keeps its spin; all keep their energy.
//!
//! The joint's second place is the bar's; its reaction is the opposite of ADAMS', which is that on the ground.

macro_rules! pendulum {
    (
        $(#[$documentation:meta])*
        $name:ident, $freedoms:literal,
        bar { $($bar:tt)* }
        joint { $($joint:tt)* }
        start { $($start:tt)* }
    ) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub spatial $name {
                gravity [m/s^2] = (0, 0, -9.80665);
                body bar { mass [kg] = 1; $($bar)* }
                $($joint)*
                start  { $($start)* }
                expect { degrees_of_freedom = $freedoms; }
                output x [m] = bar.center.x;
                output y [m] = bar.center.y;
                output z [m] = bar.center.z;
                output velocity_x [m/s] = bar.center.velocity.x;
                output velocity_y [m/s] = bar.center.velocity.y;
                output velocity_z [m/s] = bar.center.velocity.z;
            }
        }
    };
}

pendulum! {
    /// Bar on a revolute about y (Revolute_Case01), released from the horizontal.
    RevolutePendulum, 1,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { marker hinge [m] = (0, 0, 0), about_x [deg] = -90;
            joint pivot: revolute(hinge, bar.origin); }
    start { pivot.angle [rad] = 0; pivot.rate [rad/s] = 0; }
}

pendulum! {
    /// Bar on a spherical joint (Spherical_Case01), released from the horizontal.
    SphericalPendulum, 3,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: spherical(ground(0, 0, 0) [m], bar.origin); }
    start { bar.orientation = (1, 0, 0, 0); bar.rate.x [rad/s] = 0; bar.rate.y [rad/s] = 0; bar.rate.z [rad/s] = 0; }
}

pendulum! {
    /// Bar on a vertical cylindrical joint (Cylindrical_Case01): it falls without turning.
    VerticalCylindricalPendulum, 2,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: cylindrical(ground(0, 0, 0) [m], bar.origin, axis = (0, 0, 1)); }
    start { pivot.travel [m] = 0; pivot.speed [m/s] = 0; pivot.angle [rad] = 0; pivot.rate [rad/s] = 0; }
}

pendulum! {
    /// Bar on a cylindrical joint along y (Cylindrical_Case02): it swings and does not slide.
    CylindricalPendulum, 2,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { marker hinge [m] = (0, 0, 0), about_x [deg] = -90;
            joint pivot: cylindrical(hinge, bar.origin); }
    start { pivot.travel [m] = 0; pivot.speed [m/s] = 0; pivot.angle [rad] = 0; pivot.rate [rad/s] = 0; }
}

pendulum! {
    /// Bar on a vertical prismatic joint (Prismatic_Case01): it falls.
    PrismaticPendulum, 1,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: prismatic(ground(0, 0, 0) [m], bar.origin, axis = (0, 0, 1)); }
    start { pivot.travel [m] = 0; pivot.speed [m/s] = 0; }
}

pendulum! {
    /// Bar on a universal joint (Universal_Case01), released from the horizontal: it swings about the arm in the ground.
    UniversalPendulum, 2,
    bar { inertia [kg*m^2] = (0.1, 0.1, 0.04); center [m] = (0, 0, -2); }
    joint { marker hinge [m] = (0, 0, 0), about_x [deg] = 90;
            joint pivot: universal(hinge, bar.origin, axis = (1, 0, 0), second_axis = (0, 1, 0)); }
    start { pivot.angle_1 [rad] = 0; pivot.rate_1 [rad/s] = 0; pivot.angle_2 [rad] = 0; pivot.rate_2 [rad/s] = 0; }
}

pendulum! {
    /// Bar whose centre is held at 2 m from a point (Distance_Case01): it swings as a point mass and does not turn.
    DistancePendulum, 5,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); }
    joint { joint string: distance(ground(0, 0, 0) [m], bar.center, length = 2 [m]); }
    start { bar.center.x [m] = 0; bar.center.z [m] = 0; bar.center.y [m] ~ 2; bar.orientation = (1, 0, 0, 0);
            bar.center.velocity.x [m/s] = 0; bar.center.velocity.z [m/s] = 0;
            bar.rate.x [rad/s] = 0; bar.rate.y [rad/s] = 0; bar.rate.z [rad/s] = 0; }
}

pendulum! {
    /// Bar on a vertical screw of 1.5 m a turn: it screws itself down with z̈ = −g/(1 + 4.1 (2π/p)²).
    ScrewPendulum, 1,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: screw(ground(0, 0, 0) [m], bar.origin, axis = (0, 0, 1), pitch = 1.5 [m]); }
    start { pivot.angle [rad] = 0; pivot.rate [rad/s] = 0; }
}

pendulum! {
    /// Bar that slides on the plane y = 0, thrown up with a spin: a parabola, at a constant rate.
    PlanarPendulum, 3,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); }
    joint { joint pivot: planar(ground(0, 0, 0) [m], bar.center, axis = (0, 1, 0)); }
    start { bar.center.x [m] = 0; bar.center.z [m] = 0; pivot.angle [rad] = 0.3;
            bar.center.velocity.x [m/s] = 0.5; bar.center.velocity.z [m/s] = 2; pivot.rate [rad/s] = 3; }
}

pendulum! {
    /// Bar on a constant-velocity joint with a horizontal shaft: it sways and cannot twist.
    ConstantVelocityPendulum, 2,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: constant_velocity(ground(0, 0, 0) [m], bar.origin, axis = (1, 0, 0)); }
    start { bar.orientation ~ (1, 0, 0, 0); bar.center.y [m] = 0; bar.center.z [m] = 0;
            bar.rate.y [rad/s] = 0; bar.rate.z [rad/s] = 0.5; }
}

pendulum! {
    /// Bar with its end on a wire that slopes down: it slides and swings.
    PointOnLinePendulum, 4,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { line wire = (ground(0, 0, 0) [m], ground(3, 1, -1) [m]);
            joint pivot: point_on_line(wire, bar.origin); }
    start { pivot.travel [m] = 0; pivot.speed [m/s] = 0.2; bar.orientation = (1, 0, 0, 0);
            bar.rate.x [rad/s] = 0.3; bar.rate.y [rad/s] = 0; bar.rate.z [rad/s] = 0.5; }
}

pendulum! {
    /// Bar with its end on a sloping plane: it slides and swings.
    PointOnPlanePendulum, 5,
    bar { inertia [kg*m^2] = (0.04, 0.1, 0.1); center [m] = (2, 0, 0); }
    joint { joint pivot: point_on_plane(ground(0, 0, 0) [m], bar.origin, axis = (0.2, -0.1, 1)); }
    start { bar.origin.x [m] = 0; bar.origin.y [m] = 0; bar.orientation = (1, 0, 0, 0);
            bar.origin.velocity.x [m/s] = 0.1; bar.origin.velocity.y [m/s] = -0.2;
            bar.rate.x [rad/s] = 0.3; bar.rate.y [rad/s] = 0; bar.rate.z [rad/s] = 0.5; }
}
