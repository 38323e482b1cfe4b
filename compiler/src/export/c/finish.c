/* Whether a state is neither infinite nor NaN. */
static bool @m_finite_state(const @m_state_t *state)
{
    @!internal return @m_finite(state->q, @nq) && @m_finite(state->v, @nv);
    @?internal return @m_finite(state->q, @nq) && @m_finite(state->v, @nv) && @m_finite(state->z, @nz);
}

@?rows /* Whether a row is off by more than a tenth of a radian, or what makes as much of a length. Written so that a NaN is off. */
@?rows static bool @m_is_off(const @m_model_t *model, @real time, const @real q[@nq])
@?rows {
    @?rows static const @real bounds[@nr] = @rowbounds;
    @?rows @real phi[@nr];
    @?rows int i;
    @?rows
    @?rows @m_constraints(model, time, q, phi);
    @?rows for (i = 0; i < @nr; i++) {
    @?rows     if (!(@fabs(phi[i]) <= bounds[i])) {
    @?rows         return true;
    @?rows     }
    @?rows }
    @?rows return false;
@?rows }
@?rows
/* What a step of h seconds begins with. */
static @m_status_t @m_begin(const @m_t *plant,@inputsparameter @real h, @m_course_t *course)
{
    @?rows @real rate;
    @?rows
    /* Written so that a NaN fails. */
    if (!((h > (@fabs(plant->time[0]) * @leaststep)) && isfinite(h))) {
        return @M_STEP_SIZE;
    }
    @?inputs if (!@m_finite_inputs(u)) {
    @?inputs     return @M_INPUT;
    @?inputs }
    @?rows rate = @0.1 / h;
    course->model = &plant->model;
    @?inputs course->u = u;
    course->h = h;
    @?rows course->two_alpha = rate + rate;
    @?rows course->beta_squared = rate * rate;
    course->pivot = @1;
    course->stepped_over = 0U;
    course->broke_down = false;
    return @M_OK;
}

/* The end of a step, which is taken over if it is sound. */
static @m_status_t @m_finish(@m_t *plant, const @m_course_t *course, const @real time[3], const @m_state_t *end, @real moved, @m_tick_t *tick)
{
    if (!@m_finite_state(end)) {
        return @M_NOT_FINITE;
    }
    @?rows if (@m_is_off(&plant->model, time[0], end->q)) {
    @?rows     return @M_DIVERGED;
    @?rows }
    plant->time[0] = time[0];
    plant->time[1] = time[1];
    plant->time[2] = time[2];
    plant->state = *end;
    if (tick != NULL) {
        tick->time = time[0];
        tick->pivot = course->pivot;
        tick->moved = moved;
        tick->stepped_over = course->stepped_over;
    }
    return @M_OK;
}
