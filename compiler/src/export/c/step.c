@m_status_t @m_step_@method(@m_t *plant,@inputsparameter @real h, @m_tick_t *tick)
{
    @m_course_t course;
    @m_state_t end;
    @real time[3];
    @!corrected const @real moved = @0;
    @?corrected @real moved;
    @m_status_t status;

    if (@plantnull@inputsnull) {
        return @M_NULL;
    }
    status = @m_begin(plant,@inputsargument h, &course);
    if (status != @M_OK) {
        return status;
    }
    @m_clock_after(plant->time, h, time);
    @m_@integrator_@f(&course, plant->time[0], &plant->state, &end);
    if (course.broke_down) {
        return @M_BREAKDOWN;
    }
    @?corrected moved = @m_settle(&plant->model, time[0], &end);
    return @m_finish(plant, &course, time, &end, moved, tick);
}
