/* The mechanism `@name`, written out by Linkwright @version.
 *
 * C99, without allocation, recursion or state of its own. All values are in SI units; units of the definition are told beside them.
 * Compiled without contraction of products and sums (-ffp-contract=off) it gives the bits of the Rust of the same definition; with
 * options that let NaNs and infinities be taken for impossible (-ffast-math) it loses its checks.
 *
 *     static @m_t plant;
 *
 *     @m_init(&plant@initnull);
 *     for (;;) {
@?inputs  *         @m_inputs_t inputs = { ... };
@?inputs  *
 *         if (@m_step_rk4(&plant,@inputsexample @0.001, NULL) != @M_OK) { ... } the state stays the last good one
 *     }
 */
#ifndef @M_H
#define @M_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of positions, velocities, constraint rows, internal states, and degrees of freedom. */
#define @M_POSITIONS @nq
#define @M_VELOCITIES @nv
#define @M_ROWS @nr
#define @M_INTERNAL @nz
#define @M_DEGREES_OF_FREEDOM @freedoms
@sizes
/* What the entries of positions, velocities, constraint rows and internal states are. */
@indices
/* What a function did. */
typedef int32_t @m_status_t;

@statuses
/* The text of a status. */
const char *@m_status_text(@m_status_t status);

@structs
/* A state. */
typedef struct @m_state_t {
    /* Positions: lengths (m), orientations as cosine and sine or as quaternions w, x, y, z, counted angles as turns and rest (rad). */
    @real q[@M_POSITIONS];
    /* Velocities: m/s, rad/s. */
    @real v[@M_VELOCITIES];
    @?internal /* Internal states of laws. */
    @?internal @real z[@M_INTERNAL];
} @m_state_t;

/* The mechanism with its parameters. */
typedef struct @m_model_t {
    @?parameters @m_parameters_t parameters;
    @?phases /* Phases of couplings. */
    @?phases @real phases[@nphases];
    @?constants /* What depends on parameters alone. */
    @?constants @real constants[@nconstants];
    @!some /* It has no parameters. */
    @!some uint32_t empty;
} @m_model_t;

/* A mechanism that is moved by the inputs of each tick: plain data, which may be copied. */
typedef struct @m_t {
    @m_model_t model;
    /* The time (s): the first, and two that keep what its rounding leaves out. */
    @real time[3];
    @m_state_t state;
    @?unwraps /* The outputs last read, whose angles the next ones continue, and whether there are some. */
    @?unwraps @m_outputs_t last;
    @?unwraps uint32_t seen;
} @m_t;

/* What happened in a step. */
typedef struct @m_tick_t {
    /* The time at its end (s). */
    @real time;
    /* The smallest relative pivot of its stages: one is well posed, zero a singular position that was stepped over. */
    @real pivot;
    /* How far the correction moved a coordinate at most (m or rad). */
    @real moved;
    /* Stages at singular positions that were stepped over. */
    uint32_t stepped_over;
} @m_tick_t;

/* What is to be kept of a state. */
typedef struct @m_saved_t {
    /* Of the definition; of the format. */
    uint64_t fingerprint;
    uint32_t version;
    uint32_t size;
    @real time[3];
    @m_state_t state;
} @m_saved_t;

@?parameters /* The parameters that the definition declares. */
@?parameters extern const @m_parameters_t @m_default_parameters;
@?parameters
/* The start, assembled for the default parameters. */
extern const @m_state_t @m_start;

@?parameters /* The mechanism with these parameters, or with those that the definition declares where the pointer is null, at the start and time zero.
@?parameters  * @M_PARAMETER where one is not finite or out of its bounds, or a mass is not positive; nothing has changed then. */
@!parameters /* The mechanism at the start and time zero. */
@m_status_t @m_init(@m_t *plant@parametersparameter);

@?parameters /* Goes on with other parameters; otherwise as @m_init. What they put off the constraints is brought back by the steps, or at once by
@?parameters  * @m_assemble where there is one. */
@?parameters @m_status_t @m_set_parameters(@m_t *plant, const @m_parameters_t *parameters);
@?parameters
@?parameters /* The name of the first parameter, or of what follows from parameters, that is not what it must be; NULL if all are. */
@?parameters const char *@m_wrong_parameter(const @m_parameters_t *parameters);
@?parameters
/* Goes on from another state and time (s). Orientations are brought to length one.
 * @M_STATE where it is not finite, or an orientation is far from length one; nothing has changed then. */
@m_status_t @m_set_state(@m_t *plant, @real time, const @m_state_t *state);

/* One step of h seconds, the inputs held over it. After any other status than @M_OK state and time stay what they were: @M_STEP_SIZE,
 * @M_INPUT, @M_NOT_FINITE, @M_BREAKDOWN, @M_DIVERGED. What happened is written to `tick` where that is not NULL.
 *
 * rk4: the classical method of Runge and Kutta, order 4. semi_implicit_euler: order 1, one evaluation.
@?rows  * Constraints are kept by Baumgarte's terms with a time constant of ten steps.
@?corrects  * Functions that end in _corrected keep them by one step of Newton's iteration at the end of each step.
 */
@m_status_t @m_step_rk4(@m_t *plant,@inputsparameter @real h, @m_tick_t *tick);
@m_status_t @m_step_semi_implicit_euler(@m_t *plant,@inputsparameter @real h, @m_tick_t *tick);
@?corrects @m_status_t @m_step_rk4_corrected(@m_t *plant,@inputsparameter @real h, @m_tick_t *tick);
@?corrects @m_status_t @m_step_semi_implicit_euler_corrected(@m_t *plant,@inputsparameter @real h, @m_tick_t *tick);

@?corrects /* Brings the present state to the constraints by iteration: after other parameters, or for a state that was measured.
@?corrects  * @M_ASSEMBLY where that fails; nothing has changed then. */
@?corrects @m_status_t @m_assemble(@m_t *plant);
@?corrects
@?outputs /* The outputs at the present state with these inputs; angles among them continue those last read. */
@?outputs @m_status_t @m_read_outputs(@m_t *plant,@inputsparameter @m_outputs_t *outputs);
@?outputs
/* What is to be kept of the present state, to go on from it to the bit.
 * @M_OTHER_MODEL where it is of another definition, version or size; @M_STATE where it is damaged; nothing has changed then. */
@m_status_t @m_save(const @m_t *plant, @m_saved_t *saved);
@m_status_t @m_restore(@m_t *plant, const @m_saved_t *saved, size_t size);

/* The equations. These functions check nothing: no pointer may be null. */

@functions
#ifdef __cplusplus
}
#endif

#endif
