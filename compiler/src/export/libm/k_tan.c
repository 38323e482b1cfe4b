/* lw_k_tan: the tangent of x + y for |x| up to about pi/4, where y is the tail of x; -1 / tangent if odd is
 * 1.
 *
 * The algorithm is from FreeBSD's msun (k_tan.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright 2004 Sun Microsystems, Inc. All Rights Reserved.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_k_tan(double x, double y, uint32_t odd)
{
    static const double t[13] = {
        0x1.5555555555563p-2, /* 3.33333333333334091986e-01 */
        0x1.111111110fe7ap-3, /* 1.33333333333201242699e-01 */
        0x1.ba1ba1bb341fep-5, /* 5.39682539762260521377e-02 */
        0x1.664f48406d637p-6, /* 2.18694882948595424599e-02 */
        0x1.226e3e96e8493p-7, /* 8.86323982359930005737e-03 */
        0x1.d6d22c9560328p-9, /* 3.59207910759131235356e-03 */
        0x1.7dbc8fee08315p-10, /* 1.45620945432529025516e-03 */
        0x1.344d8f2f26501p-11, /* 5.88041240820264096874e-04 */
        0x1.026f71a8d1068p-12, /* 2.46463134818469906812e-04 */
        0x1.47e88a03792a6p-14, /* 7.81794442939557092300e-05 */
        0x1.2b80f32f0a7e9p-14, /* 7.14072491382608190305e-05 */
        -0x1.375cbdb605373p-16, /* -1.85586374855275456654e-05 */
        0x1.b2a7074bf7ad4p-16 /* 2.59073051863633712884e-05 */
    };
    const double pio4 = 0x1.921fb54442d18p-1; /* 7.85398163397448278999e-01 */
    const double pio4_lo = 0x1.1a62633145c07p-55; /* 3.06161699786838301793e-17 */
    const uint32_t hx = lw_high_word(x);
    const uint32_t negative = hx >> 31U;
    const uint32_t ix = hx & 0x7FFFFFFFU;
    double a = x;
    double b = y;
    double z;
    double w;
    double r;
    double v;
    double s;

    if (ix >= 0x3FE59428U) { /* |x| >= 0.6744 */
        if (negative != 0U) {
            a = -a;
            b = -b;
        }
        a = (pio4 - a) + (pio4_lo - b);
        b = 0.0;
    }
    z = a * a;
    w = z * z;
    /* The odd and the even terms are summed apart. */
    r = t[1] + (w * (t[3] + (w * (t[5] + (w * (t[7] + (w * (t[9] + (w * t[11])))))))));
    v = z * (t[2] + (w * (t[4] + (w * (t[6] + (w * (t[8] + (w * (t[10] + (w * t[12]))))))))));
    s = z * a;
    r = b + (z * ((s * (r + v)) + b)) + (s * t[0]);
    w = a + r;
    if (ix >= 0x3FE59428U) {
        s = 1.0 - (2.0 * (double)odd);
        v = s - (2.0 * (a + (r - ((w * w) / (w + s)))));
        return (negative != 0U) ? -v : v;
    }
    if (odd != 0U) {
        /* -1 / (a + r) alone would be wrong by up to two units in the last place. */
        const double w0 = lw_clear_low_word(w);
        const double q = -1.0 / w;
        const double q0 = lw_clear_low_word(q);

        v = r - (w0 - a);
        w = q0 + (q * (1.0 + (q0 * w0) + (q0 * v)));
    }
    return w;
}
