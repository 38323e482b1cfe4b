@?leads /* v' and the multipliers, by independent velocities where these serve, else by multipliers; the pivot of the way taken. */
@?leads static @real @m_solved_@f(const @m_course_t *course, @real time, const @m_state_t *state, @real a[@nv]@lambdaparameter)
@?leads {
@?leads     @real pivot = @leading(course->model, time, state@solvearguments, a@lambdaargument);
@?leads
@?leads     if (!(pivot >= @serves)) {
@?leads         pivot = @multipliers(course->model, time, state@solvearguments, a@lambdaargument);
@?leads     }
@?leads     return pivot;
@?leads }
@?leads
/* Rates where the equations of a stage are singular: those of the first of seven positions, up to a hundred steps further along, that
   has some. */
static void @m_past_breakdown_@f(@m_course_t *course, @real time, const @m_state_t *state, @real a[@nv]@lambdaparameter)
{
    @m_state_t further;
    @real duration = @closest * course->h;
    bool found = false;
    int position;

    further = *state;
    for (position = 0; (position < 7) && !found; position++) {
        @real u[@nv];
        @real pivot;
        int i;

        for (i = 0; i < @nv; i++) {
            u[i] = duration * state->v[i];
        }
        @m_retract(state->q, u, u, true, further.q);
        duration = duration * @10;
        pivot = @solve, time, &further@stagearguments, a@lambdaargument);
        found = (pivot >= @breakdown) && @m_finite(a, @nv);
    }
    course->pivot = @0;
    if (found) {
        course->stepped_over++;
    } else {
        course->broke_down = true;
    }
}

/* The rates of a state. */
static void @m_slope_@f(@m_course_t *course, @real time, const @m_state_t *state, @m_slope_t *slope)
{
    @?rows @real lambda[@nr];
    int i;
    const @real pivot = @solve, time, state@stagearguments, slope->a@lambdaargument);

    if (pivot >= @breakdown) {
        course->pivot = (pivot < course->pivot) ? pivot : course->pivot;
    } else {
        @m_past_breakdown_@f(course, time, state, slope->a@lambdaargument);
    }
    for (i = 0; i < @nv; i++) {
        slope->v[i] = state->v[i];
        @?quaternions slope->k[i] = state->v[i];
    }
    @?internal @m_internal_rates(course->model, time, state@courseinputs, slope->a@lambdaargument, slope->z);
}

/* The rates of a stage, to which a slope leads from the beginning of the step. */
static void @m_stage_@f(@m_course_t *course, @real time, const @m_state_t *begin, @real h, const @m_slope_t *by, @m_slope_t *slope)
{
    @m_increment_t increment;
    @m_state_t state;
    @?quaternions int i;

    @m_increment_of(h, by, &increment);
    @m_moved(begin, &increment, false, &state);
    @m_slope_@f(course, time, &state, slope);
    @?quaternions for (i = @atomegas; i < @nv; i += 3) {
    @?quaternions     @m_inverse_differential(&increment.u[i], &slope->v[i], &slope->k[i]);
    @?quaternions }
}

/* A step by the classical method of Runge and Kutta (order 4). */
static void @m_rk4_@f(@m_course_t *course, @real time, const @m_state_t *begin, @m_state_t *end)
{
    const @real h = course->h;
    const @real half = @0.5 * h;
    @m_slope_t k[4];
    @m_increment_t increment;

    @m_slope_@f(course, time, begin, &k[0]);
    @m_stage_@f(course, time + half, begin, half, &k[0], &k[1]);
    @m_stage_@f(course, time + half, begin, half, &k[1], &k[2]);
    @m_stage_@f(course, time + h, begin, h, &k[2], &k[3]);
    @m_mean_increment(h, k, &increment);
    @m_moved(begin, &increment, true, end);
}

/* A step by the semi-implicit method of Euler (order 1): positions move with the velocities at its end. */
static void @m_semi_implicit_euler_@f(@m_course_t *course, @real time, const @m_state_t *begin, @m_state_t *end)
{
    const @real h = course->h;
    @m_slope_t slope;
    @m_increment_t increment;
    int i;

    @m_slope_@f(course, time, begin, &slope);
    @m_increment_of(h, &slope, &increment);
    for (i = 0; i < @nv; i++) {
        increment.u[i] = h * (begin->v[i] + increment.v[i]);
        @?counts increment.integral[i] = increment.u[i];
    }
    @m_moved(begin, &increment, true, end);
}
