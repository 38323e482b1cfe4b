//! The zoo's mechanisms in space have every joint in both orders of its places, and one tree that is long enough for articulated
//! bodies.

use crate::registry::{Model, compiled};
use crate::zoo_space::{
    Arm, Bench, Cabin, Ceiling, Crank, Hub, Jack, Mesh, Shafts, Slanted, Snake, Stage, Table, Wires,
};
use linkwright_compiler::equations::space::joints;
use linkwright_compiler::model::{Coordinates, Frame};
use linkwright_compiler::order::Strategy;
use mechanisms::zoo_cables::Hoisted;
use std::collections::BTreeSet;

/// How the joints of a mechanism stand in its tree: kind, what it does there, where the ground is.
fn ways<M: Model>() -> Vec<(&'static str, &'static str, &'static str)> {
    let compiled = compiled::<M>(Some(Coordinates::Tree));
    let attachments = &compiled.complete.equations.tree.attachments;
    let joints = compiled.mechanism.joints.iter().enumerate();
    let way = joints.map(|(index, joint)| {
        let carried = attachments.iter().find(|own| own.joint.is_some_and(|(id, _)| id.0 == index));
        let role = match carried.map(|own| Frame::Body(own.body)) {
            None => "cut",
            Some(frame) if frame == joint.first.frame => "carries the first",
            Some(_) => "carries the second",
        };
        let ground = match (joint.first.frame, joint.second.frame) {
            (Frame::Ground, _) => "ground first",
            (_, Frame::Ground) => "ground second",
            _ => "bodies",
        };
        (joint.word(), role, ground)
    });
    way.collect()
}

#[test]
fn a_long_tree_is_solved_by_articulated_bodies() {
    let strategy = |coordinates| compiled::<Snake>(Some(coordinates)).complete.solved.order.strategy;
    assert_eq!(strategy(Coordinates::Tree), Strategy::ArticulatedBodies);
    assert_ne!(strategy(Coordinates::Absolute), Strategy::ArticulatedBodies);
}

/// The mechanisms of `zoo_space.rs` do what they were written for: no joint carries in one direction only, and each is cut somewhere
/// (all are in absolute coordinates) with the ground on either side, or between bodies where it never is with the ground.
#[test]
fn every_joint_occurs_both_ways() {
    let all = [
        ways::<Arm>(),
        ways::<Jack>(),
        ways::<Table>(),
        ways::<Ceiling>(),
        ways::<Wires>(),
        ways::<Shafts>(),
        ways::<Mesh>(),
        ways::<Crank>(),
        ways::<Slanted>(),
        ways::<Hub>(),
        ways::<Bench>(),
        ways::<Snake>(),
        ways::<Stage>(),
        ways::<Cabin>(),
        ways::<Hoisted>(),
    ];
    let found: BTreeSet<_> = all.into_iter().flatten().collect();
    let has = |kind: &str, role: &str| found.iter().any(|way| way.0 == kind && way.1 == role);
    for joint in joints::JOINTS {
        let kind = joint.form.call.word;
        // What leaves no frame to measure from, or five freedoms, is always cut.
        let always_cut = joint.motions.is_none();
        assert!(always_cut || has(kind, "carries the first"), "{kind}: {found:?}");
        assert!(always_cut || has(kind, "carries the second"), "{kind}: {found:?}");
        assert!(!always_cut || has(kind, "cut"), "{kind}: {found:?}");
    }
    for (kind, ground) in [
        ("revolute", "ground first"),
        ("revolute", "ground second"),
        ("prismatic", "ground first"),
        ("prismatic", "ground second"),
        ("cylindrical", "ground first"),
        ("cylindrical", "ground second"),
        ("planar", "ground first"),
        ("planar", "ground second"),
        ("parallel", "bodies"),
        ("parallel", "ground second"),
        ("point_on_line", "ground first"),
        ("point_on_line", "ground second"),
        ("point_on_plane", "ground first"),
        ("point_on_plane", "ground second"),
        ("distance", "ground second"),
        ("distance", "bodies"),
        ("cord", "bodies"),
        ("fixed", "bodies"),
        ("spherical", "bodies"),
    ] {
        assert!(found.iter().any(|way| way.0 == kind && way.2 == ground), "{kind}, {ground}: {found:?}");
    }
}
