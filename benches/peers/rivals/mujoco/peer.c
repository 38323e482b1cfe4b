/* MuJoCo behind the interface: mj_forward on joint angles, and its own RK4. The model is a file of MJCF. */
#include "../../interface/peer.h"
#include <mujoco/mujoco.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct peer {
    mjModel *model;
    mjData *data;
    double *given;
    int count;
};

static volatile double next_to_nothing = PEER_NEXT_TO_NOTHING;

peer *peer_open(const char *model) {
    char error[1000] = "";
    mjModel *loaded = mj_loadXML(model, NULL, error, sizeof error);
    if (!loaded) {
        fprintf(stderr, "%s\n", error);
        return NULL;
    }
    peer *self = calloc(1, sizeof(peer));
    self->model = loaded;
    self->data = mj_makeData(loaded);
    return self;
}

void peer_sizes(const peer *self, int *positions, int *velocities) {
    *positions = self->model->nq;
    *velocities = self->model->nv;
}

void peer_give(peer *self, int count, const double *rows) {
    size_t size = sizeof(double) * count * (self->model->nq + self->model->nv);
    self->given = realloc(self->given, size);
    memcpy(self->given, rows, size);
    self->count = count;
}

static void set(const mjModel *model, mjData *data, const double *row) {
    memcpy(data->qpos, row, sizeof(double) * model->nq);
    memcpy(data->qvel, row + model->nq, sizeof(double) * model->nv);
}

/* From zero, so that the solver of the soft rows does not start where another state ended. */
void peer_accelerations(peer *self, double *rows) {
    const mjModel *model = self->model;
    for (int i = 0; i < self->count; i++) {
        mj_resetData(model, self->data);
        set(model, self->data, self->given + (size_t)i * (model->nq + model->nv));
        mj_forward(model, self->data);
        memcpy(rows + (size_t)i * model->nv, self->data->qacc, sizeof(double) * model->nv);
    }
}

void peer_evaluate(peer *self, int first, int count) {
    int at = first % self->count;
    for (int i = 0; i < count; i++) {
        set(self->model, self->data, self->given + (size_t)at * (self->model->nq + self->model->nv));
        mj_forward(self->model, self->data);
        if (++at == self->count)
            at = 0;
    }
}

void peer_chain(peer *self, int count) {
    const mjModel *model = self->model;
    mjData *data = self->data;
    set(model, data, self->given);
    for (int i = 0; i < count; i++) {
        mj_forward(model, data);
        double shift = next_to_nothing * data->qacc[0];
        for (int k = 0; k < model->nq; k++)
            data->qpos[k] += shift;
        for (int k = 0; k < model->nv; k++)
            data->qvel[k] += shift;
    }
}

long peer_simulate(peer *self, double step, long steps, double *row) {
    mjModel *model = self->model;
    mjData *data = self->data;
    double kept = model->opt.timestep;
    model->opt.timestep = step;
    data->time = 0.0;
    mju_zero(data->qacc_warmstart, model->nv);
    set(model, data, row);
    long done = 0;
    for (; done < steps; done++) {
        mj_step(model, data);
        if (data->warning[mjWARN_BADQACC].number || data->warning[mjWARN_BADQVEL].number)
            break;
    }
    memcpy(row, data->qpos, sizeof(double) * model->nq);
    memcpy(row + model->nq, data->qvel, sizeof(double) * model->nv);
    model->opt.timestep = kept;
    return done;
}

/* What a thread of a batch does: its members one after the other, each through all steps, like the library's own rollouts. */
struct share {
    const peer *self;
    const mjModel *model;
    int members;
    long steps;
};

static void *roll(void *argument) {
    struct share *share = argument;
    mjData *data = mj_makeData(share->model);
    for (int member = 0; member < share->members; member++) {
        mj_resetData(share->model, data);
        set(share->model, data, share->self->given);
        for (long step = 0; step < share->steps; step++)
            mj_step(share->model, data);
    }
    mj_deleteData(data);
    return NULL;
}

double peer_batch(peer *self, int members, int threads, double step, long steps) {
    mjModel *model = mj_copyModel(NULL, self->model);
    model->opt.timestep = step;
    pthread_t thread[64];
    struct share share[64];
    struct timespec begin, end;
    if (threads > 64)
        threads = 64;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (int i = 0; i < threads; i++) {
        int mine = members / threads + (i < members % threads);
        share[i] = (struct share){self, model, mine, steps};
        pthread_create(&thread[i], NULL, roll, &share[i]);
    }
    for (int i = 0; i < threads; i++)
        pthread_join(thread[i], NULL);
    clock_gettime(CLOCK_MONOTONIC, &end);
    mj_deleteModel(model);
    return end.tv_sec - begin.tv_sec + 1e-9 * (end.tv_nsec - begin.tv_nsec);
}
