/* What every compiled peer offers as a shared library. A state is a row of positions and velocities in the peer's own coordinates;
 * whoever gives it has converted it, so that no conversion is timed. All coordinates are reals; accelerations are the derivatives of
 * the velocities. */
#ifndef PEER_H
#define PEER_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct peer peer;

/* The mechanism that this file (or name) describes; null where the peer cannot have it. */
peer *peer_open(const char *model);
void peer_sizes(const peer *, int *positions, int *velocities);
/* The states that are evaluated from now on. */
void peer_give(peer *, int count, const double *rows);
/* A row of accelerations for each state. */
void peer_accelerations(peer *, double *rows);
/* Timed: so many evaluations, of one state after the other from `first` on. */
void peer_evaluate(peer *, int first, int count);
/* Timed: so many evaluations, of the first state, every entry of which is shifted by next to nothing times the result before. */
void peer_chain(peer *, int count);
/* Timed: steps of RK4 with the peer's own way of staying on the constraints; how many succeeded, or −1
 * where it has none. */
long peer_simulate(peer *, double step, long steps, double *row);
/* Optional: seconds for so many steps of all members. */
double peer_batch(peer *, int members, int threads, double step, long steps);

#ifdef __cplusplus
}
#endif

/* α = β of Baumgarte's terms, 1/s. */
#define PEER_RATE 10.0
/* Nothing is left of a result times this, and the processor cannot know. */
#define PEER_NEXT_TO_NOTHING 1e-60

#endif
