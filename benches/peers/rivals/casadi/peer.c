/* A function of CasADi's C behind the interface: `FUNCTION` of the file `SOURCE`, over `SIZE` angles. */
#include "../../interface/peer.h"
#include <stdlib.h>

#include SOURCE

struct evaluator {
    double gains[2], torques[SIZE], lambda[4 * SIZE];
    casadi_int integers[INTEGERS + 1];
    double work[WORK + 1];
};

static struct evaluator *evaluator_open(const char *model, int *size) {
    (void)model;
    struct evaluator *self = (struct evaluator *)calloc(1, sizeof *self);
    self->gains[0] = 2 * PEER_RATE;
    self->gains[1] = PEER_RATE * PEER_RATE;
    *size = SIZE;
    return self;
}

static void evaluator_call(struct evaluator *self, const double *q, const double *v, double *a) {
    const double *arguments[8] = {q, v, self->gains, self->torques};
    double *results[8] = {a, self->lambda};
    FUNCTION(arguments, results, self->integers, self->work, 0);
}

#include "../../interface/evaluator.h"
