/* A step with `take`, of which the plant keeps nothing unless all went well. */
static @m_status_t @m_begin(const @m_t *plant, @inputsparameter@real h, @m_course_t *course)
{
    @m_status_t status = @M_OK;

    /* Written so that a NaN fails. */
    if (!((h > (@fabs(plant->time[0]) * @leaststep)) && isfinite(h))) {
        status = @M_STEP_SIZE;
    }
    @?inputs else if (!@m_finite_inputs(u)) {
    @?inputs     status = @M_INPUT;
    @?inputs }
    else {
        @?rows const @real rate = @0.1 / h;

        course->model = &plant->model;
        @?inputs course->u = u;
        course->h = h;
        @?rows course->two_alpha = rate + rate;
        @?rows course->beta_squared = rate * rate;
        course->pivot = @1;
        course->stepped_over = 0U;
        course->broke_down = false;
    }
    return status;
}

/* Whether a state is neither infinite nor NaN. */
static bool @m_finite_state(const @m_state_t *state)
{
    return @m_finite(state->q, @nq) && @m_finite(state->v, @nv)@finitez;
}

@?rows /* Whether a row is off by more than a tenth of a radian, or what makes as much of a length. Written so that a NaN is off. */
@?rows static bool @m_is_off(const @m_model_t *model, @real time, const @m_state_t *state)
@?rows {
    @?rows static const @real bounds[@nr] = @rowbounds;
    @?rows @real phi[@nr];
    @?rows bool off = false;
    @?rows int i;

    @?rows @m_constraints(model, time, state->q, phi);
    @?rows for (i = 0; i < @nr; i++) {
    @?rows     if (!(@fabs(phi[i]) <= bounds[i])) {
    @?rows         off = true;
    @?rows     }
    @?rows }
    @?rows return off;
@?rows }
@?rows 
/* Ends a step: what is sound is taken over. */
static @m_status_t @m_finish(@m_t *plant, const @m_course_t *course, const @real clock[3], const @m_state_t *end, @real moved, @m_tick_t *tick)
{
    @m_status_t status = @M_OK;

    if (course->broke_down) {
        status = @M_BREAKDOWN;
    } else if (!@m_finite_state(end)) {
        status = @M_NOT_FINITE;
    } 
    @?rows else if (@m_is_off(&plant->model, clock[0], end)) {
    @?rows     status = @M_DIVERGED;
    @?rows } 
    else {
        plant->time[0] = clock[0];
        plant->time[1] = clock[1];
        plant->time[2] = clock[2];
        plant->state = *end;
        if (tick != NULL) {
            tick->time = clock[0];
            tick->pivot = course->pivot;
            tick->moved = moved;
            tick->stepped_over = course->stepped_over;
        }
    }
    return status;
}
