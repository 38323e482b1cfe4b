/* -1, 0 or 1 with the sign of x. */
static @real lw_sign(@real x)
{
    return (x > @0) ? @1 : ((x < @0) ? -@1 : x);
}

/* The smaller of two; the second where either is NaN. */
static @real lw_least(@real a, @real b)
{
    return (a < b) ? a : b;
}

/* The larger of two; the second where either is NaN. */
static @real lw_most(@real a, @real b)
{
    return (a > b) ? a : b;
}

/* Whether two numbers are equal. */
static bool lw_equal(@real a, @real b)
{
    return (a <= b) && (a >= b);
}

/* The number of the row of a table that x is in: how many bases from the second on are not above it, of 2^bits. */
static @real lw_cell(const @real bases[], int bits, @real x)
{
    uint32_t found = 0U;
    int bit;

    for (bit = bits - 1; bit >= 0; bit--) {
        const uint32_t higher = found | (UINT32_C(1) << (uint32_t)bit);

        found = (bases[higher] <= x) ? higher : found;
    }
    return (@real)found;
}

/* a + b s + c s^2 + d s^3, or one of its derivatives. Zero times the argument, so that what is no number gives none. */
static @real lw_cubic(int order, const @real f[4], @real s)
{
    if (order == 0) {
        return (((((f[3] * s) + f[2]) * s) + f[1]) * s) + f[0];
    }
    if (order == 1) {
        return ((((@3 * f[3]) * s) + (@2 * f[2])) * s) + f[1];
    }
    if (order == 2) {
        return ((@6 * f[3]) * s) + (@2 * f[2]);
    }
    return (@0 * s) + (@6 * f[3]);
}

/* The polynomial of a row. */
static @real lw_piece_0(const @real table[][5], @real cell, @real x)
{
    const @real *const row = table[(uint32_t)cell];

    return lw_cubic(0, &row[1], x - row[0]);
}

/* Its first derivative. */
static @real lw_piece_1(const @real table[][5], @real cell, @real x)
{
    const @real *const row = table[(uint32_t)cell];

    return lw_cubic(1, &row[1], x - row[0]);
}

/* Its second derivative. */
static @real lw_piece_2(const @real table[][5], @real cell, @real x)
{
    const @real *const row = table[(uint32_t)cell];

    return lw_cubic(2, &row[1], x - row[0]);
}

/* Its third derivative. */
static @real lw_piece_3(const @real table[][5], @real cell, @real x)
{
    const @real *const row = table[(uint32_t)cell];

    return lw_cubic(3, &row[1], x - row[0]);
}

/* The patch of a row. */
static @real lw_patch_00(const @real table[][6], @real cell, @real x, @real y)
{
    const @real *const row = table[(uint32_t)cell];
    const @real s = x - row[0];
    const @real t = y - row[1];

    return (((row[5] * t) + row[3]) * s) + ((row[4] * t) + row[2]);
}

/* Its derivative by x. */
static @real lw_patch_10(const @real table[][6], @real cell, @real x, @real y)
{
    const @real *const row = table[(uint32_t)cell];

    return (@0 * (x - row[0])) + ((row[5] * (y - row[1])) + row[3]);
}

/* Its derivative by y. */
static @real lw_patch_01(const @real table[][6], @real cell, @real x, @real y)
{
    const @real *const row = table[(uint32_t)cell];

    return (@0 * (y - row[1])) + ((row[5] * (x - row[0])) + row[4]);
}

/* Its derivative by both. */
static @real lw_patch_11(const @real table[][6], @real cell, @real x, @real y)
{
    const @real *const row = table[(uint32_t)cell];

    return (@0 * (x - row[0])) + ((@0 * (y - row[1])) + row[5]);
}

/* The bicubic patch of a row, differentiated so often. */
static @real lw_bicubic(const @real table[][18], int by_x, int by_y, @real cell, @real x, @real y)
{
    const @real *const row = table[(uint32_t)cell];
    const @real t = y - row[1];
    @real f[4];
    int k;

    for (k = 0; k < 4; k++) {
        f[k] = lw_cubic(by_y, &row[2 + (4 * k)], t);
    }
    return lw_cubic(by_x, f, x - row[0]);
}
