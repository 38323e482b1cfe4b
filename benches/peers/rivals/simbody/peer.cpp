/* Simbody behind the interface: a state realised to the stage of accelerations, and its Runge–Kutta–Merson of fixed steps with
 * projection onto the constraints. Cut hinges are two planes for a point in the plane, and two balls along the axis in space. */
#include "../../interface/linkage.hpp"
#include "../../interface/peer.h"

#include <Simbody.h>

using namespace SimTK;

static Vec3 vector(const linkage::V3 &v) { return {v[0], v[1], v[2]}; }

static Mat33 matrix(const linkage::M3 &m) { return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]}; }

static Rotation rotation(const linkage::M3 &m) { return Rotation(matrix(m), true); }

struct peer {
    linkage::Linkage linkage;
    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    std::vector<MobilizedBody> bodies;
    State state;
    std::vector<double> given;
    int count = 0, size = 0;

    MobilizedBody &body(int number) { return number < 0 ? matter.updGround() : bodies[number]; }
};

static volatile double next_to_nothing = PEER_NEXT_TO_NOTHING;

static void build(peer &self) {
    for (const linkage::Link &link : self.linkage.links) {
        // The hinge is about z of both frames.
        const Rotation own(UnitVec3(vector(link.axis)), ZAxis);
        const Vec3 center = vector(link.center);
        const Mat33 tensor = matrix(link.tensor);
        Inertia about_center(tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(0, 2), tensor(1, 2));
        const MassProperties mass(link.mass, center, about_center.shiftFromMassCenter(center, link.mass));
        const Transform outside(rotation(link.axes) * own, vector(link.place));
        self.bodies.push_back(MobilizedBody::Pin(self.body(link.parent), outside, Body::Rigid(mass), Transform(own)));
        if (link.torque != 0.0)
            Force::MobilityConstantForce(self.forces, self.bodies.back(), 0, link.torque);
    }
    Force::UniformGravity(self.forces, self.matter, vector(self.linkage.gravity));
    for (const linkage::Loop &loop : self.linkage.loops)
        if (self.linkage.planar) {
            for (const UnitVec3 &normal : {UnitVec3(1, 0, 0), UnitVec3(0, 1, 0)}) {
                const double height = dot(normal, vector(loop.place[0]));
                Constraint::PointInPlane(self.body(loop.link[0]), normal, height, self.body(loop.link[1]), vector(loop.place[1]));
            }
        } else {
            for (double along : {-0.5, 0.5})
                Constraint::Ball(
                    self.body(loop.link[0]), vector(loop.place[0]) + along * vector(loop.axis[0]), self.body(loop.link[1]),
                    vector(loop.place[1]) + along * vector(loop.axis[1]));
        }
    for (const linkage::Spring &spring : self.linkage.springs)
        Force::TwoPointLinearSpring(
            self.forces, self.body(spring.link[0]), vector(spring.place[0]), self.body(spring.link[1]), vector(spring.place[1]),
            spring.stiffness, spring.length);
    self.state = self.system.realizeTopology();
    self.system.realizeModel(self.state);
}

peer *peer_open(const char *model) {
    auto self = new peer;
    if (!linkage::read(model, self->linkage))
        return nullptr;
    self->size = self->linkage.links.size();
    try {
        build(*self);
    } catch (const std::exception &error) {
        fprintf(stderr, "%s\n", error.what());
        return nullptr;
    }
    return self;
}

void peer_sizes(const peer *self, int *positions, int *velocities) { *positions = *velocities = self->size; }

void peer_give(peer *self, int count, const double *rows) {
    self->given.assign(rows, rows + 2 * self->size * count);
    self->count = count;
}

static void set(peer *self, const double *row) {
    for (int i = 0; i < self->size; i++) {
        self->state.updQ()[i] = row[i];
        self->state.updU()[i] = row[self->size + i];
    }
}

void peer_accelerations(peer *self, double *rows) {
    for (int i = 0; i < self->count; i++) {
        set(self, &self->given[2 * self->size * i]);
        self->system.realize(self->state, Stage::Acceleration);
        for (int k = 0; k < self->size; k++)
            rows[self->size * i + k] = self->state.getUDot()[k];
    }
}

void peer_evaluate(peer *self, int first, int count) {
    for (int i = 0; i < count; i++) {
        set(self, &self->given[2 * self->size * ((first + i) % self->count)]);
        self->system.realize(self->state, Stage::Acceleration);
    }
}

void peer_chain(peer *self, int count) {
    set(self, self->given.data());
    for (int i = 0; i < count; i++) {
        self->system.realize(self->state, Stage::Acceleration);
        const double shift = next_to_nothing * self->state.getUDot()[0];
        self->state.updQ() += shift;
        self->state.updU() += shift;
    }
}

long peer_simulate(peer *self, double step, long steps, double *row) {
    set(self, row);
    self->state.setTime(0);
    RungeKuttaMersonIntegrator integrator(self->system);
    integrator.setFixedStepSize(step);
    integrator.setAllowInterpolation(false);
    integrator.setConstraintTolerance(1e-10);
    const double end = step * steps;
    try {
        integrator.initialize(self->state);
        while (integrator.getTime() < end - 0.5 * step)
            integrator.stepTo(end, end);
    } catch (const std::exception &) {
        return 0;
    }
    for (int i = 0; i < self->size; i++) {
        row[i] = integrator.getState().getQ()[i];
        row[self->size + i] = integrator.getState().getU()[i];
    }
    return steps;
}
