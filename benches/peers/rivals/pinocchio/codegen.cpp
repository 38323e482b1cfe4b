/* Pinocchio's algorithms over CasADi's expressions, as C: (q, v, gains, torques) → v̇ of a tree.
 *
 *     codegen LINKAGE NAME aba|crba
 *
 * writes NAME.c into the present folder and prints seconds, and the sizes of the memory that the function needs. */
#include <pinocchio/autodiff/casadi.hpp>

#include "model.hpp"

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <chrono>
#include <iostream>

using Scalar = casadi::SX;
using VectorX = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

static VectorX eigen(const casadi::SX &from) {
    VectorX found(from.size1());
    for (int i = 0; i < found.size(); i++)
        found[i] = from(i);
    return found;
}

template <class M> static casadi::SX casadi_of(const M &from) {
    casadi::SX found(from.rows(), from.cols());
    for (int i = 0; i < from.rows(); i++)
        for (int j = 0; j < from.cols(); j++)
            found(i, j) = from(i, j);
    return found;
}

int main(int argc, char **argv) {
    linkage::Linkage linkage;
    if (argc != 4 || !linkage::read(argv[1], linkage) || !linkage.loops.empty())
        return 1;
    std::vector<Eigen::Matrix3d> turned;
    const auto begin = std::chrono::steady_clock::now();
    const auto model = pinocchio_model(linkage, turned).cast<Scalar>();
    pinocchio::DataTpl<Scalar> data(model);
    const auto q = casadi::SX::sym("q", model.nq), v = casadi::SX::sym("v", model.nv);
    const auto gains = casadi::SX::sym("gains", 2), torques = casadi::SX::sym("torques", model.nv);
    casadi::SX a;
    if (std::string(argv[3]) == "aba") {
        a = casadi_of(pinocchio::aba(model, data, eigen(q), eigen(v), eigen(torques)));
    } else {
        pinocchio::crba(model, data, eigen(q));
        data.M.triangularView<Eigen::StrictlyLower>() = data.M.transpose().triangularView<Eigen::StrictlyLower>();
        const casadi::SX bias = casadi_of(pinocchio::nonLinearEffects(model, data, eigen(q), eigen(v)));
        // From the last link inwards, so that branches do not fill.
        std::vector<casadi_int> order;
        for (int i = model.nv - 1; i >= 0; i--)
            order.push_back(i);
        const casadi::SX mass = casadi_of(data.M), rest = torques - bias;
        casadi::SX d, lt;
        std::vector<casadi_int> p;
        casadi::SX::ldl(mass(order, order), d, lt, p, false);
        a = casadi::SX::ldl_solve(rest(order), d, lt, p)(order);
    }
    casadi::Function made(argv[2], {q, v, gains, torques}, casadi::SX::cse(std::vector<casadi::SX>{a, casadi::SX(0, 1)}));
    made.generate(std::string(argv[2]) + ".c", casadi::Dict{{"with_header", false}});
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    std::cout << passed.count() << " " << made.sz_iw() << " " << made.sz_w() << "\n";
    return 0;
}
