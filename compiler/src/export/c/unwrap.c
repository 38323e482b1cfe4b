/* The angle (rad) that differs from `angle` by whole turns and lies nearest to `previous`. */
static @real @m_unwrap_angle(@real angle, @real previous)
{
    return angle + (@floor(((previous - angle) * @turn) + @0.5) * @twopi);
}
