/* a + b, rounded, in x[0], and what the rounding left out, exactly, in x[1] (Knuth's TwoSum). */
static void @m_two_sum(@real a, @real b, @real x[2])
{
    const @real sum = a + b;
    const @real of_b = sum - a;

    x[0] = sum;
    x[1] = (a - (sum - of_b)) + (b - of_b);
}

/* The clock after h more seconds: three numbers without overlap, whose sum is exact. */
static void @m_clock_after(const @real from[3], @real h, @real to[3])
{
    @real x[2];
    @real error;

    @m_two_sum(from[1], h, x);
    error = x[1];
    @m_two_sum(from[0], x[0], x);
    to[0] = x[0];
    to[1] = x[1];
    to[2] = @0;
    if ((error < @0) || (error > @0) || (from[2] < @0) || (from[2] > @0)) {
        @real rest;
        @real twice;

        @m_two_sum(to[1], error, x);
        @m_two_sum(x[0], x[1] + from[2], x);
        rest = x[1];
        @m_two_sum(to[0], x[0], x);
        to[0] = x[0];
        @m_two_sum(x[1], rest, x);
        to[1] = x[0];
        to[2] = x[1];
        /* Half way between two numbers the first is the even one; the third says on which side of the middle the sum is. */
        twice = to[1] + to[1];
        rest = ((to[0] + twice) - to[0]) - twice;
        if (!((rest < @0) || (rest > @0)) && (((to[1] > @0) && (to[2] > @0)) || ((to[1] < @0) && (to[2] < @0)))) {
            to[0] = to[0] + twice;
            to[1] = -to[1];
        }
    }
}
