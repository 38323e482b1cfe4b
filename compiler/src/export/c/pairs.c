/* (cos d - 1, sin d) of a small increment. */
static void @m_versine(@real d, @real x[2])
{
    const @real z = d * d;
    @real series[2];

    @m_series(z, series);
    x[0] = z * series[0];
    x[1] = ((d * z) * series[1]) + d;
}

/* Whether an increment is beyond the direct polynomials. */
static bool @m_is_far(@real d)
{
    return (d * d) > @direct;
}

/* (cos d, sin d) of any increment: halved until it is small, and doubled as often. */
static void @m_exponential(@real d, @real x[2])
{
    @real small = d;
    @real u;
    @real s;
    int halvings = 0;
    int i;

    while ((halvings < 64) && @m_is_far(small)) {
        small = small * @0.5;
        halvings++;
    }
    @m_versine(small, x);
    u = x[0];
    s = x[1];
    for (i = 0; i < halvings; i++) {
        s = (s + s) * (@1 + u);
        u = (u + u) * (@2 + u);
    }
    x[0] = @1 + u;
    x[1] = s;
}

/* Pairs (cos, sin) turned by increments (rad); normalised to first order where the motion goes on from them. */
static void @m_turn_pairs(const @real from[@npairs], const @real d[@nrotations], bool goes_on, @real to[@npairs])
{
    @real squares = @0;
    bool far;
    int i;

    for (i = 0; i < @nrotations; i++) {
        squares = (d[i] * d[i]) + squares;
    }
    far = squares > @direct;
    for (i = 0; i < @nrotations; i++) {
        const @real c = from[2 * i];
        const @real s = from[(2 * i) + 1];
        @real by[2];
        @real cosine;
        @real sine;

        if (far) {
            @m_exponential(d[i], by);
        } else {
            @m_versine(d[i], by);
            by[0] = @1 + by[0];
        }
        cosine = (c * by[0]) - (s * by[1]);
        sine = (s * by[0]) + (c * by[1]);
        if (far || goes_on) {
            const @real k = (@3 - ((cosine * cosine) + (sine * sine))) * @0.5;

            cosine = cosine * k;
            sine = sine * k;
        }
        to[2 * i] = cosine;
        to[(2 * i) + 1] = sine;
    }
}
