@?orientations /* The first entry and the number of entries of each orientation. */
@?orientations static const int @m_orientations[@norientations][2] = @orientations;
@?orientations
@?orientations /* The square of the length of an orientation. */
@?orientations static @real @m_length_squared(const @real q[], int count)
@?orientations {
    @?orientations @real square = @0;
    @?orientations int i;
    @?orientations
    @?orientations for (i = 0; i < count; i++) {
    @?orientations     square = square + (q[i] * q[i]);
    @?orientations }
    @?orientations return square;
@?orientations }
@?orientations
/* Whether a state can be gone on from: it is finite, and orientations have a length near 1. */
static bool @m_is_state(const @m_state_t *state)
{
    @?orientations int i;
    @?orientations
    if (!@m_finite_state(state)) {
        return false;
    }
    @?orientations for (i = 0; i < @norientations; i++) {
    @?orientations     const int *const place = @m_orientations[i];
    @?orientations
    @?orientations     if (@fabs(@m_length_squared(&state->q[place[0]], place[1]) - @1) > @unit) {
    @?orientations         return false;
    @?orientations     }
    @?orientations }
    return true;
}

/* Goes on from a state at a time, of which angles of outputs know nothing. */
static void @m_go_on(@m_t *plant, const @real time[3], const @m_state_t *state)
{
    plant->time[0] = time[0];
    plant->time[1] = time[1];
    plant->time[2] = time[2];
    plant->state = *state;
    @?unwraps plant->seen = 0U;
}

@m_status_t @m_init(@m_t *plant@parametersparameter)
{
    static const @real time[3] = {@0, @0, @0};
    @?internal @m_state_t state;
    @?parameters @m_model_t model;

    if (plant == NULL) {
        return @M_NULL;
    }
    @?parameters if (@m_model_of(&model, (parameters == NULL) ? &@m_default_parameters : parameters) >= 0) {
    @?parameters     return @M_PARAMETER;
    @?parameters }
    @?phased if (parameters != NULL) {
    @?phased     @m_fix_phases(&model, @m_start.q);
    @?phased }
    @?parameters plant->model = model;
    @!parameters if (@m_model_of(&plant->model) >= 0) {
    @!parameters     return @M_PARAMETER;
    @!parameters }
    @?internal state = @m_start;
    @?internal @m_start_internal(&plant->model, state.z);
    @?internal @m_go_on(plant, time, &state);
    @!internal @m_go_on(plant, time, &@m_start);
    return @M_OK;
}

@?parameters @m_status_t @m_set_parameters(@m_t *plant, const @m_parameters_t *parameters)
@?parameters {
    @?parameters @m_model_t model;
    @?parameters
    @?parameters if ((plant == NULL) || (parameters == NULL)) {
    @?parameters     return @M_NULL;
    @?parameters }
    @?parameters if (@m_model_of(&model, parameters) >= 0) {
    @?parameters     return @M_PARAMETER;
    @?parameters }
    @?parameters @?phased @m_fix_phases(&model, @m_start.q);
    @?parameters @?phased @m_fix_phases(&model, plant->state.q);
    @?parameters plant->model = model;
    @?parameters return @M_OK;
@?parameters }
@?parameters
@m_status_t @m_set_state(@m_t *plant, @real time, const @m_state_t *state)
{
    @real clock[3] = {@0, @0, @0};
    @m_state_t unit;
    @?orientations int i;
    @?orientations int j;

    if ((plant == NULL) || (state == NULL)) {
        return @M_NULL;
    }
    if (!@m_is_state(state) || !isfinite(time)) {
        return @M_STATE;
    }
    clock[0] = time;
    unit = *state;
    @?orientations for (i = 0; i < @norientations; i++) {
    @?orientations     @real *const entries = &unit.q[@m_orientations[i][0]];
    @?orientations     const @real square = @m_length_squared(entries, @m_orientations[i][1]);
    @?orientations     const @real scale = @1 / @sqrt(square);
    @?orientations
    @?orientations     if (@fabs(square - @1) > @roundings) {
    @?orientations         for (j = 0; j < @m_orientations[i][1]; j++) {
    @?orientations             entries[j] = entries[j] * scale;
    @?orientations         }
    @?orientations     }
    @?orientations }
    @m_go_on(plant, clock, &unit);
    return @M_OK;
}

@?outputs @m_status_t @m_read_outputs(@m_t *plant,@inputsparameter @m_outputs_t *outputs)
@?outputs {
    @?outputs @?inputs if ((plant == NULL) || (u == NULL) || (outputs == NULL)) {
    @?outputs @!inputs if ((plant == NULL) || (outputs == NULL)) {
    @?outputs     return @M_NULL;
    @?outputs }
    @?outputs @m_outputs(&plant->model, plant->time[0], &plant->state@uargument, outputs);
    @?unwraps if (plant->seen != 0U) {
@unwraps
    @?unwraps }
    @?stated else {
    @?stated     @real targets[@ntargets];
    @?stated     @real rates[@ntargets];
    @?stated
    @?stated     @m_start_targets(&plant->model, targets, rates);
@unwrapsstart
    @?stated }
    @?unwraps plant->last = *outputs;
    @?unwraps plant->seen = 1U;
    @?outputs return @M_OK;
@?outputs }
@?outputs
@?corrects @m_status_t @m_assemble(@m_t *plant)
@?corrects {
    @?corrects @m_state_t state;
    @?corrects int iteration;
    @?corrects
    @?corrects if (plant == NULL) {
    @?corrects     return @M_NULL;
    @?corrects }
    @?corrects state = plant->state;
    @?corrects for (iteration = 0; iteration < 50; iteration++) {
    @?corrects     const @real moved = @m_settle(&plant->model, plant->time[0], &state);
    @?corrects
    @?corrects     if (!@m_finite_state(&state)) {
    @?corrects         return @M_ASSEMBLY;
    @?corrects     }
    @?corrects     if ((moved <= (@still * (@1 + @m_most(state.q, @nq)))) && !@m_is_off(&plant->model, plant->time[0], state.q)) {
    @?corrects         plant->state = state;
    @?corrects         return @M_OK;
    @?corrects     }
    @?corrects }
    @?corrects return @M_ASSEMBLY;
@?corrects }
@?corrects
@m_status_t @m_save(const @m_t *plant, @m_saved_t *saved)
{
    if ((plant == NULL) || (saved == NULL)) {
        return @M_NULL;
    }
    saved->fingerprint = @m_fingerprint;
    saved->version = 1U;
    saved->size = (uint32_t)sizeof(*saved);
    saved->time[0] = plant->time[0];
    saved->time[1] = plant->time[1];
    saved->time[2] = plant->time[2];
    saved->state = plant->state;
    return @M_OK;
}

@m_status_t @m_restore(@m_t *plant, const @m_saved_t *saved, size_t size)
{
    if ((plant == NULL) || (saved == NULL)) {
        return @M_NULL;
    }
    if ((size != sizeof(*saved)) || (saved->size != (uint32_t)sizeof(*saved))) {
        return @M_OTHER_MODEL;
    }
    if ((saved->version != 1U) || (saved->fingerprint != @m_fingerprint)) {
        return @M_OTHER_MODEL;
    }
    /* Three numbers are a clock where they are finite and do not overlap. */
    if (!@m_finite(saved->time, 3) || !@m_same(saved->time[0] + saved->time[1], saved->time[0])
        || !@m_same(saved->time[1] + saved->time[2], saved->time[1]) || !@m_is_state(&saved->state)) {
        return @M_STATE;
    }
    @m_go_on(plant, saved->time, &saved->state);
    return @M_OK;
}

const char *@m_status_text(@m_status_t status)
{
    static const char *const texts[] = {
@texts
    };

    return ((status >= @M_OK) && (status <= @M_NULL)) ? texts[status] : "unknown status";
}
