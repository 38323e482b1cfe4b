/* h (a + (b - a) / 3 + (c - a) / 3 + (d - a) / 6). */
static @real @m_mean(@real h, @real a, @real b, @real c, @real d)
{
    @real sum = (@third * (b - a)) + a;

    sum = (@third * (c - a)) + sum;
    sum = (@sixth * (d - a)) + sum;
    return sum * h;
}

/* The increment of a step: the mean of its slopes. */
static void @m_mean_increment(@real h, const @m_slope_t k[4], @m_increment_t *by)
{
    int i;

    for (i = 0; i < @nv; i++) {
        by->u[i] = @m_mean(h, k[0].@rate[i], k[1].@rate[i], k[2].@rate[i], k[3].@rate[i]);
        @?counts by->integral[i] = @m_mean(h, k[0].v[i], k[1].v[i], k[2].v[i], k[3].v[i]);
        by->v[i] = @m_mean(h, k[0].a[i], k[1].a[i], k[2].a[i], k[3].a[i]);
    }
    @?internal for (i = 0; i < @nz; i++) {
    @?internal     by->z[i] = @m_mean(h, k[0].z[i], k[1].z[i], k[2].z[i], k[3].z[i]);
    @?internal }
}
