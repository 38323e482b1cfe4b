/* The interface for a peer that is a function (q, v) → v̇ over as many angles as rates: states, chains, and RK4.
 *
 * Whoever includes it defines first
 *     struct evaluator;                                                      what the function needs
 *     static struct evaluator *evaluator_open(const char *model, int *size); null where it cannot
 *     static void evaluator_call(struct evaluator *, const double *q, const double *v, double *a);
 * as C or C++, and `PEER_POSITIONS` 2 where it takes cosine and sine of each angle: steps it then has none. */
#include "peer.h"
#include <stdlib.h>
#include <string.h>

#ifndef PEER_POSITIONS
#define PEER_POSITIONS 1
#endif
#define PEER_WIDTH (PEER_POSITIONS + 1)

struct peer {
    struct evaluator *evaluator;
    int size, count;
    double *given, *a, *work;
};

static volatile double peer_next_to_nothing = PEER_NEXT_TO_NOTHING;

static double *peer_numbers(size_t count) {
    return (double *)aligned_alloc(64, (count * sizeof(double) + 63) / 64 * 64);
}

peer *peer_open(const char *model) {
    int size = 0;
    struct evaluator *evaluator = evaluator_open(model, &size);
    if (!evaluator)
        return NULL;
    peer *self = (peer *)calloc(1, sizeof(peer));
    self->evaluator = evaluator;
    self->size = size;
    self->a = peer_numbers(size);
    self->work = peer_numbers(8 * (size_t)size);
    return self;
}

void peer_sizes(const peer *self, int *positions, int *velocities) { *positions = PEER_POSITIONS * (*velocities = self->size); }

void peer_give(peer *self, int count, const double *rows) {
    free(self->given);
    self->given = peer_numbers(PEER_WIDTH * (size_t)self->size * count);
    memcpy(self->given, rows, sizeof(double) * PEER_WIDTH * self->size * count);
    self->count = count;
}

void peer_accelerations(peer *self, double *rows) {
    for (int i = 0; i < self->count; i++) {
        const double *q = self->given + PEER_WIDTH * (size_t)self->size * i;
        evaluator_call(self->evaluator, q, q + PEER_POSITIONS * self->size, rows + (size_t)self->size * i);
    }
}

void peer_evaluate(peer *self, int first, int count) {
    int at = first % self->count;
    for (int i = 0; i < count; i++) {
        const double *q = self->given + PEER_WIDTH * (size_t)self->size * at;
        evaluator_call(self->evaluator, q, q + PEER_POSITIONS * self->size, self->a);
        if (++at == self->count)
            at = 0;
    }
}

void peer_chain(peer *self, int count) {
    int n = self->size;
    double *q = self->work;
    memcpy(q, self->given, sizeof(double) * PEER_WIDTH * n);
    for (int i = 0; i < count; i++) {
        evaluator_call(self->evaluator, q, q + PEER_POSITIONS * n, self->a);
        double shift = peer_next_to_nothing * self->a[0];
        for (int k = 0; k < PEER_WIDTH * n; k++)
            q[k] += shift;
    }
}

long peer_simulate(peer *self, double h, long steps, double *row) {
    if (PEER_POSITIONS != 1)
        return -1;
    int n = self->size;
    double *q = row, *v = row + n;
    double *at = self->work, *w = at + n, *a = w + n, *dq = a + n, *dv = dq + n;
    static const double along[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    for (long step = 0; step < steps; step++) {
        for (int stage = 0; stage < 4; stage++) {
            double d = along[stage] * h;
            for (int i = 0; i < n; i++) {
                at[i] = q[i] + (stage ? d * w[i] : 0.0);
                w[i] = v[i] + (stage ? d * a[i] : 0.0);
            }
            evaluator_call(self->evaluator, at, w, a);
            for (int i = 0; i < n; i++) {
                dq[i] = (stage ? dq[i] : 0.0) + weight[stage] * w[i];
                dv[i] = (stage ? dv[i] : 0.0) + weight[stage] * a[i];
            }
        }
        for (int i = 0; i < n; i++) {
            q[i] += h * dq[i];
            v[i] += h * dv[i];
            if (!(v[i] - v[i] == 0.0))
                return step;
        }
    }
    return steps;
}
