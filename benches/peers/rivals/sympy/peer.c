/* A function of SymPy's C behind the interface: `FUNCTION` over `SIZE` angles, from a file of its own. */
#include "../../interface/peer.h"
#include <stddef.h>

void FUNCTION(const double *q, const double *v, double *a);

struct evaluator {
    int size;
};

static struct evaluator *evaluator_open(const char *model, int *size) {
    static struct evaluator self = {SIZE};
    (void)model;
    *size = SIZE;
    return &self;
}

static void evaluator_call(struct evaluator *self, const double *q, const double *v, double *a) {
    (void)self;
    FUNCTION(q, v, a);
}

#include "../../interface/evaluator.h"
