/* (w - 1, x, y, z) of the unit quaternion of a small increment (rad). */
static void @m_half_turn(const @real d[3], @real x[4])
{
    const @real square = (((d[0] * d[0]) + (d[1] * d[1])) + (d[2] * d[2])) * @0.25;
    @real series[2];
    @real factor;

    @m_series(square, series);
    factor = ((@0.5 * square) * series[1]) + @0.5;
    x[0] = square * series[0];
    x[1] = factor * d[0];
    x[2] = factor * d[1];
    x[3] = factor * d[2];
}

/* Whether an increment is beyond the direct polynomials. */
static bool @m_turns_far(const @real d[3])
{
    return (((d[0] * d[0]) + (d[1] * d[1])) + (d[2] * d[2])) > (@4 * @direct);
}

/* The unit quaternion of any increment: halved until it is small, and squared as often. */
static void @m_unit_quaternion(const @real d[3], @real x[4])
{
    @real small[3];
    int halvings = 0;
    int i;

    small[0] = d[0];
    small[1] = d[1];
    small[2] = d[2];
    while ((halvings < 64) && @m_turns_far(small)) {
        small[0] = small[0] * @0.5;
        small[1] = small[1] * @0.5;
        small[2] = small[2] * @0.5;
        halvings++;
    }
    @m_half_turn(small, x);
    for (i = 0; i < halvings; i++) {
        const @real w = @1 + x[0];

        x[1] = (x[1] + x[1]) * w;
        x[2] = (x[2] + x[2]) * w;
        x[3] = (x[3] + x[3]) * w;
        x[0] = (x[0] + x[0]) * (@2 + x[0]);
    }
    x[0] = @1 + x[0];
}

/* Quaternions turned by increments in the turned axes (rad); normalised to first order where the motion goes on from them. */
static void @m_turn_quaternions(const @real from[@nquads], const @real d[@nomegas], bool goes_on, @real to[@nquads])
{
    bool far = false;
    int i;

    for (i = 0; i < @nquaternions; i++) {
        if (@m_turns_far(&d[3 * i])) {
            far = true;
        }
    }
    for (i = 0; i < @nquaternions; i++) {
        const @real *const p = &from[4 * i];
        @real *const x = &to[4 * i];
        @real q[4];
        @real w;
        @real a;
        @real b;
        @real c;

        if (far) {
            @m_unit_quaternion(&d[3 * i], q);
        } else {
            @m_half_turn(&d[3 * i], q);
            q[0] = @1 + q[0];
        }
        w = ((p[0] * q[0]) - (p[1] * q[1])) - ((p[2] * q[2]) + (p[3] * q[3]));
        a = ((p[0] * q[1]) + (p[1] * q[0])) + ((p[2] * q[3]) - (p[3] * q[2]));
        b = ((p[0] * q[2]) + (p[2] * q[0])) + ((p[3] * q[1]) - (p[1] * q[3]));
        c = ((p[0] * q[3]) + (p[3] * q[0])) + ((p[1] * q[2]) - (p[2] * q[1]));
        if (far || goes_on) {
            const @real k = (@3 - (((w * w) + (a * a)) + ((b * b) + (c * c)))) * @0.5;

            w = w * k;
            a = a * k;
            b = b * k;
            c = c * k;
        }
        x[0] = w;
        x[1] = a;
        x[2] = b;
        x[3] = c;
    }
}

/* The rate of an increment u (rad) that belongs to the angular velocity w in the turned axes, into k. */
static void @m_inverse_differential(const @real u[3], const @real w[3], @real k[3])
{
    const @real a = (u[1] * w[2]) - (u[2] * w[1]);
    const @real b = (u[2] * w[0]) - (u[0] * w[2]);
    const @real c = (u[0] * w[1]) - (u[1] * w[0]);

    k[0] = w[0] + ((@0.5 * a) + (@twelfth * ((u[1] * c) - (u[2] * b))));
    k[1] = w[1] + ((@0.5 * b) + (@twelfth * ((u[2] * a) - (u[0] * c))));
    k[2] = w[2] + ((@0.5 * c) + (@twelfth * ((u[0] * b) - (u[1] * a))));
}
