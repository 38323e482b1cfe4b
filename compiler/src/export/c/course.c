/* What the stages of a step have in common, and what they find. */
typedef struct @m_course_t {
    const @m_model_t *model;
    @?inputs const @m_inputs_t *u;
    @real h;
    @?rows @real two_alpha;
    @?rows @real beta_squared;
    @real pivot;
    uint32_t stepped_over;
    bool broke_down;
} @m_course_t;

/* The rates of a state: its velocities, their derivatives, those of internal states. */
typedef struct @m_slope_t {
    @real v[@nv];
    @real a[@nv];
    @?internal @real z[@nz];
    @?quaternions /* The rate of the increment that leads to the stage. */
    @?quaternions @real k[@nv];
} @m_slope_t;

/* An increment of the state: of positions by `u`, of velocities, of internal states. */
typedef struct @m_increment_t {
    @real u[@nv];
    @?counts @real integral[@nv];
    @real v[@nv];
    @?internal @real z[@nz];
} @m_increment_t;

/* That of one slope. */
static void @m_increment_of(@real h, const @m_slope_t *slope, @m_increment_t *by)
{
    int i;

    for (i = 0; i < @nv; i++) {
        by->u[i] = h * slope->@rate[i];
        @?counts by->integral[i] = h * slope->v[i];
        by->v[i] = h * slope->a[i];
    }
    @?internal for (i = 0; i < @nz; i++) {
    @?internal     by->z[i] = h * slope->z[i];
    @?internal }
}

/* The state that lies an increment from `from`. */
static void @m_moved(const @m_state_t *from, const @m_increment_t *by, bool goes_on, @m_state_t *to)
{
    int i;

    @m_retract(from->q, by->u, by->@integral, goes_on, to->q);
    for (i = 0; i < @nv; i++) {
        to->v[i] = from->v[i] + by->v[i];
    }
    @?internal for (i = 0; i < @nz; i++) {
    @?internal     to->z[i] = from->z[i] + by->z[i];
    @?internal }
}
