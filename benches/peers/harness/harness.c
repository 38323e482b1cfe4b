/* Loads the peers of one mechanism into one process and takes turns in slices of about 20 µs, on one core, with a clock beside them.
 *
 *     harness check PEER LIBRARY MODEL STATES ACCELERATIONS            accelerations of all states to a file
 *     harness time SECONDS OUT (PEER LIBRARY MODEL STATES)…            samples in ns: evaluations, chains, steps; cycles of a ns
 *     harness simulate PEER LIBRARY MODEL STATES STEP STEPS TIMES OUT  seconds, least of so many times, and the last state
 *     harness batch PEER LIBRARY MODEL STATES MEMBERS THREADS STEP STEPS TIMES OUT
 *
 * Files of states and results are raw doubles. Samples are rows of text: peer, kind, ns of each slice. */
#define _GNU_SOURCE
#include "../interface/peer.h"
#include <dlfcn.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define SLICE 20e3
#define MOST 16
#define SAMPLES 4000
#define STEP 1e-7
#define LEAST_STEPS 20
/* What takes longer than this, ns, has its turn less often, so that the others have theirs; but in each of the first rounds. */
#define SHARE 200e3
#define FIRST 5

struct loaded {
    const char *name;
    peer *self;
    int positions, velocities, count, next;
    double *rows;
    __typeof__(peer_open) *open;
    __typeof__(peer_sizes) *sizes;
    __typeof__(peer_give) *give;
    __typeof__(peer_accelerations) *accelerations;
    __typeof__(peer_evaluate) *evaluate;
    __typeof__(peer_chain) *chain;
    __typeof__(peer_simulate) *simulate;
    __typeof__(peer_batch) *batch;
};

static void fail(const char *what, const char *which) {
    fprintf(stderr, "%s: %s\n", which, what ? what : "failed");
    exit(1);
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * time.tv_sec + time.tv_nsec;
}

static void *symbol(void *library, const char *name, const char *path) {
    void *found = dlsym(library, name);
    if (!found && strcmp(name, "peer_batch"))
        fail(name, path);
    return found;
}

/* Peer, library, model, states. Each library keeps its symbols to itself. */
static struct loaded load(char **arguments) {
    struct loaded one = {.name = arguments[0]};
    void *library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
    if (!library)
        fail(dlerror(), arguments[0]);
    one.open = symbol(library, "peer_open", arguments[1]);
    one.sizes = symbol(library, "peer_sizes", arguments[1]);
    one.give = symbol(library, "peer_give", arguments[1]);
    one.accelerations = symbol(library, "peer_accelerations", arguments[1]);
    one.evaluate = symbol(library, "peer_evaluate", arguments[1]);
    one.chain = symbol(library, "peer_chain", arguments[1]);
    one.simulate = symbol(library, "peer_simulate", arguments[1]);
    one.batch = symbol(library, "peer_batch", arguments[1]);
    one.self = one.open(arguments[2]);
    if (!one.self)
        fail("does not open its model", arguments[0]);
    one.sizes(one.self, &one.positions, &one.velocities);
    FILE *file = fopen(arguments[3], "rb");
    if (!file)
        fail("no states", arguments[0]);
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    one.rows = aligned_alloc(64, (size + 63) / 64 * 64);
    one.count = size / sizeof(double) / (one.positions + one.velocities);
    if (!one.count || fread(one.rows, 1, size, file) != (size_t)size || size % (sizeof(double) * (one.positions + one.velocities)))
        fail("states of another size", arguments[0]);
    fclose(file);
    one.give(one.self, one.count, one.rows);
    return one;
}

static void write_all(const char *path, const double *values, size_t count) {
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(values, sizeof(double), count, file) != count)
        fail("cannot be written", path);
    fclose(file);
}

static int check(char **arguments) {
    struct loaded one = load(arguments);
    double *a = calloc((size_t)one.count * one.velocities, sizeof(double));
    one.accelerations(one.self, a);
    write_all(arguments[4], a, (size_t)one.count * one.velocities);
    return 0;
}

/* An addition that waits for the one before, one cycle. */
#if defined(__x86_64__)
#define ADD "add %0, %0\n\t"
#else
#define ADD "add %0, %0, %0\n\t"
#endif
#define FOUR ADD ADD ADD ADD
#define SIXTEEN FOUR FOUR FOUR FOUR

/* Cycles of a nanosecond: a chain that no compiler can shorten. */
static double cycles(void) {
    double least = 1e300;
    for (int i = 0; i < 4; i++) {
        double begin = now();
        unsigned long x = 1;
        for (int k = 0; k < 250; k++)
            __asm__ volatile(SIXTEEN : "+r"(x));
        double passed = now() - begin;
        least = passed < least ? passed : least;
    }
    return 4000.0 / least;
}

enum kind { EVALUATION, CHAIN, STEPS };
static const char *const KINDS[] = {"evaluation", "chain", "step"};

/* ns of one call in a slice of so many. */
static double slice(struct loaded *one, enum kind kind, int calls) {
    double row[one->positions + one->velocities];
    memcpy(row, one->rows, sizeof row);
    double begin = now();
    if (kind == EVALUATION)
        one->evaluate(one->self, one->next, calls);
    else if (kind == CHAIN)
        one->chain(one->self, calls);
    else {
        long good = one->simulate(one->self, STEP, calls, row);
        if (good >= 0 && good != calls)
            fail("a step failed", one->name);
        if (good < 0)
            return 0.0;
    }
    double passed = now() - begin;
    if (kind == EVALUATION)
        one->next = (one->next + calls) % one->count;
    return passed / calls;
}

static int measure(int argc, char **arguments) {
    double seconds = atof(arguments[0]);
    struct loaded all[MOST];
    int count = (argc - 2) / 4, samples = 0;
    if (count > MOST)
        fail("too many peers", "harness");
    static double ns[MOST][3][SAMPLES], clock[SAMPLES];
    int calls[MOST][3], period[MOST][3];
    for (int i = 0; i < count; i++) {
        all[i] = load(arguments + 2 + 4 * i);
        for (int kind = 0; kind < 3; kind++) {
            slice(&all[i], kind, 3);
            double once = slice(&all[i], kind, 20);
            if (once == 0.0) {
                calls[i][kind] = 0;
                continue;
            }
            calls[i][kind] = once * 200 < SLICE ? (int)(SLICE / slice(&all[i], kind, 200)) + 1 : (int)(SLICE / once) + 1;
            /* What a simulation does once is none of its steps. */
            if (kind == STEPS && calls[i][kind] < LEAST_STEPS)
                calls[i][kind] = LEAST_STEPS;
            period[i][kind] = (int)(once * calls[i][kind] / SHARE) + 1;
        }
    }
    double begin = now();
    while (samples < SAMPLES && (samples < 10 || now() - begin < 1e9 * seconds)) {
        for (int kind = 0; kind < 3; kind++)
            for (int i = 0; i < count; i++) {
                /* What was called before has filled the caches with its own. */
                int few = calls[i][kind] / 4;
                ns[i][kind][samples] = NAN;
                if (!calls[i][kind] || (samples >= FIRST && samples % period[i][kind]))
                    continue;
                if (few)
                    slice(&all[i], kind, few);
                ns[i][kind][samples] = slice(&all[i], kind, calls[i][kind]);
            }
        clock[samples] = cycles();
        samples++;
    }
    FILE *out = fopen(arguments[1], "w");
    if (!out)
        fail("cannot be written", arguments[1]);
    for (int i = 0; i < count; i++)
        for (int kind = 0; kind < 3; kind++) {
            if (!calls[i][kind])
                continue;
            fprintf(out, "%s %s", all[i].name, KINDS[kind]);
            for (int k = 0; k < samples; k++)
                fprintf(out, " %.4g", ns[i][kind][k]);
            fprintf(out, "\n");
        }
    fprintf(out, "- clock");
    for (int k = 0; k < samples; k++)
        fprintf(out, " %.4g", clock[k]);
    fprintf(out, "\n");
    return fclose(out);
}

static int simulate(char **arguments) {
    struct loaded one = load(arguments);
    double step = atof(arguments[4]), least = 1e300;
    long steps = atol(arguments[5]);
    int width = one.positions + one.velocities;
    double *result = calloc(width + 2, sizeof(double));
    for (int times = atoi(arguments[6]); times > 0; times--) {
        memcpy(result + 2, one.rows, sizeof(double) * width);
        double begin = now();
        result[1] = one.simulate(one.self, step, steps, result + 2);
        double passed = 1e-9 * (now() - begin);
        least = passed < least ? passed : least;
    }
    result[0] = least;
    write_all(arguments[7], result, width + 2);
    return 0;
}

static int batch(char **arguments) {
    struct loaded one = load(arguments);
    if (!one.batch)
        fail("has no batches", one.name);
    double least = 1e300;
    for (int times = atoi(arguments[8]); times > 0; times--) {
        double seconds = one.batch(one.self, atoi(arguments[4]), atoi(arguments[5]), atof(arguments[6]), atol(arguments[7]));
        least = seconds < least ? seconds : least;
    }
    write_all(arguments[9], &least, 1);
    return 0;
}

static void pin(void) {
    cpu_set_t allowed, one;
    sched_getaffinity(0, sizeof allowed, &allowed);
    int last = 0;
    for (int i = 0; i < CPU_SETSIZE; i++)
        last = CPU_ISSET(i, &allowed) ? i : last;
    CPU_ZERO(&one);
    CPU_SET(last, &one);
    sched_setaffinity(0, sizeof one, &one);
}

int main(int argc, char **argv) {
    if (argc >= 7 && !strcmp(argv[1], "check"))
        return check(argv + 2);
    if (argc == 12 && !strcmp(argv[1], "batch"))
        return batch(argv + 2);
    pin();
    if (argc >= 8 && argc % 4 == 0 && !strcmp(argv[1], "time"))
        return measure(argc - 2, argv + 2);
    if (argc == 10 && !strcmp(argv[1], "simulate"))
        return simulate(argv + 2);
    fprintf(stderr, "see the head of harness.c\n");
    return 2;
}
