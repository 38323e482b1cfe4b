/* Pinocchio behind the interface. Trees by `aba`; loops by `constraintDynamics`, or by `lcaba` where the model's name ends in
 * ":lcaba". Cut hinges are contacts of three rows: one in the plane, two along the axis in space. Springs, which the library has not,
 * are torques from the places of their ends. */
#include "../../interface/peer.h"
#include "model.hpp"

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/constrained-dynamics.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/loop-constrained-aba.hpp>

using namespace pinocchio;

struct evaluator {
    linkage::Linkage linkage;
    std::vector<Eigen::Matrix3d> turned;
    Model model;
    Data data;
    bool by_lcaba = false;
    std::vector<RigidConstraintModel, Eigen::aligned_allocator<RigidConstraintModel>> constraints;
    std::vector<RigidConstraintData, Eigen::aligned_allocator<RigidConstraintData>> memory;
    Eigen::VectorXd q, v, constant, torque;
};

static SE3 placed(const evaluator &self, int link, const Eigen::Vector3d &place) {
    const Eigen::Matrix3d turn = link < 0 ? Eigen::Matrix3d::Identity() : self.turned[link];
    return SE3(Eigen::Matrix3d::Identity(), turn.transpose() * place);
}

static struct evaluator *evaluator_open(const char *name, int *size) {
    auto self = new evaluator;
    std::string path = name;
    const size_t colon = path.rfind(":lcaba");
    if (colon != std::string::npos) {
        self->by_lcaba = true;
        path.resize(colon);
    }
    if (!linkage::read(path.c_str(), self->linkage))
        return nullptr;
    self->model = pinocchio_model(self->linkage, self->turned);
    for (const linkage::Loop &loop : self->linkage.loops)
        for (double along : {-0.5, 0.5}) {
            const double shift = self->linkage.planar ? 0.0 : along;
            SE3 places[2];
            for (int end = 0; end < 2; end++)
                places[end] = placed(*self, loop.link[end], vector(loop.place[end]) + shift * vector(loop.axis[end]));
            RigidConstraintModel row(CONTACT_3D, self->model, loop.link[0] + 1, places[0], loop.link[1] + 1, places[1], LOCAL);
            row.baumgarte_corrector_parameters().Kp = PEER_RATE * PEER_RATE;
            row.baumgarte_corrector_parameters().Kd = 2 * PEER_RATE;
            self->constraints.push_back(row);
            if (self->linkage.planar)
                break;
        }
    self->data = Data(self->model);
    for (const auto &row : self->constraints)
        self->memory.push_back(row.createData());
    if (self->by_lcaba)
        computeJointMinimalOrdering(self->model, self->data, self->constraints);
    else if (!self->constraints.empty())
        initConstraintDynamics(self->model, self->data, self->constraints, self->memory);
    self->q = self->v = self->torque = self->constant = Eigen::VectorXd::Zero(self->model.nv);
    for (int i = 0; i < self->model.nv; i++)
        self->constant[i] = self->linkage.links[i].torque;
    *size = self->model.nv;
    return self;
}

/* Torques of the springs on all hinges from their ends to the ground. */
static void add_springs(evaluator &self) {
    forwardKinematics(self.model, self.data, self.q);
    for (const linkage::Spring &spring : self.linkage.springs) {
        Eigen::Vector3d end[2];
        for (int k = 0; k < 2; k++)
            end[k] = self.data.oMi[spring.link[k] + 1].act(placed(self, spring.link[k], vector(spring.place[k])).translation());
        const Eigen::Vector3d along = end[1] - end[0];
        const Eigen::Vector3d force = spring.stiffness * (1.0 - spring.length / along.norm()) * along;
        for (int k = 0; k < 2; k++)
            for (int link = spring.link[k]; link >= 0; link = self.linkage.links[link].parent) {
                const SE3 &joint = self.data.oMi[link + 1];
                const double arm = joint.rotation().col(2).dot((end[k] - joint.translation()).cross(force));
                self.torque[link] += k ? -arm : arm;
            }
    }
}

static void evaluator_call(struct evaluator *self, const double *q, const double *v, double *a) {
    const int n = self->model.nv;
    self->q = Eigen::Map<const Eigen::VectorXd>(q, n);
    self->v = Eigen::Map<const Eigen::VectorXd>(v, n);
    self->torque = self->constant;
    if (!self->linkage.springs.empty())
        add_springs(*self);
    if (self->constraints.empty()) {
        Eigen::Map<Eigen::VectorXd>(a, n) = aba(self->model, self->data, self->q, self->v, self->torque);
    } else if (self->by_lcaba) {
        ProximalSettings settings(1e-12, 1e-8, 2);
        Eigen::Map<Eigen::VectorXd>(a, n) =
            lcaba(self->model, self->data, self->q, self->v, self->torque, self->constraints, self->memory, settings);
    } else {
        // Of redundant rows multipliers grow without bound where steps leave residuals that contradict one another; a larger μ and
        // few iterations keep them small. Tried from 1e-10 to 1e-2: these have the least error.
        ProximalSettings settings(1e-12, self->linkage.planar ? 1e-10 : 1e-2, self->linkage.planar ? 3 : 5);
        Eigen::Map<Eigen::VectorXd>(a, n) = constraintDynamics(
            self->model, self->data, self->q, self->v, self->torque, self->constraints, self->memory, settings);
    }
}

#include "../../interface/evaluator.h"
