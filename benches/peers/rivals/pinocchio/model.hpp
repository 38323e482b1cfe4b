/* Pinocchio's model of a linkage, in any scalars. */
#pragma once
#include "../../interface/linkage.hpp"

#include <pinocchio/multibody.hpp>
#include <pinocchio/spatial.hpp>

inline Eigen::Vector3d vector(const linkage::V3 &v) { return {v[0], v[1], v[2]}; }

inline Eigen::Matrix3d matrix(const linkage::M3 &m) {
    Eigen::Matrix3d found;
    found << m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8];
    return found;
}

/* A turn that brings z onto the axis of a link: joints about z are the library's fastest. */
inline Eigen::Matrix3d onto(const Eigen::Vector3d &axis) {
    return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

/* Frames of joints have z along the hinge; `turned` brings a link's axes into them. */
inline pinocchio::Model pinocchio_model(const linkage::Linkage &from, std::vector<Eigen::Matrix3d> &turned) {
    pinocchio::Model model;
    model.gravity.linear(vector(from.gravity));
    for (size_t i = 0; i < from.links.size(); i++) {
        const linkage::Link &link = from.links[i];
        const Eigen::Matrix3d own = onto(vector(link.axis));
        const Eigen::Matrix3d before = link.parent < 0 ? Eigen::Matrix3d::Identity() : turned[link.parent];
        turned.push_back(own);
        const pinocchio::SE3 placement(before.transpose() * matrix(link.axes) * own, before.transpose() * vector(link.place));
        const auto joint = model.addJoint(link.parent + 1, pinocchio::JointModelRZ(), placement, "joint_" + std::to_string(i));
        const Eigen::Matrix3d tensor = own.transpose() * matrix(link.tensor) * own;
        const pinocchio::Inertia inertia(link.mass, own.transpose() * vector(link.center), tensor);
        model.appendBodyToJoint(joint, inertia, pinocchio::SE3::Identity());
    }
    return model;
}
