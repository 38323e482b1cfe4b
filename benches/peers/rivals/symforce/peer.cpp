/* A function of SymForce's C++ behind the interface: `FUNCTION` of the file `HEADER` over `SIZE` angles. */
#include "../../interface/peer.h"

#include HEADER

struct evaluator {};

static struct evaluator *evaluator_open(const char *, int *size) {
    static evaluator self;
    *size = SIZE;
    return &self;
}

static void evaluator_call(struct evaluator *, const double *q, const double *v, double *a) {
    using Vector = Eigen::Matrix<double, SIZE, 1>;
    Eigen::Map<Vector>{a} = linkages::FUNCTION<double>(Eigen::Map<const Vector>(q), Eigen::Map<const Vector>(v));
}

#include "../../interface/evaluator.h"
