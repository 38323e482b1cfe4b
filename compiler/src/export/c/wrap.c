/* Whole turns moved out of a remainder (rad) that has left [-pi, pi). */
static void @m_wrap(@real turns, @real remainder, @real to[2])
{
    @real moved;

    to[0] = turns;
    to[1] = remainder;
    if (@fabs(remainder) >= @pi) {
        moved = @floor((remainder * @turn) + @0.5);
        to[0] = turns + moved;
        to[1] = remainder - (moved * @twopi);
    }
}
