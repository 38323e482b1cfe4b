/* lw_rem_pio2_medium: what remains of x after division by pi/2, in y[0] + y[1], and the last two bits of
 * the quotient, for |x| up to 2^20 * pi/2.
 *
 * The algorithm is from FreeBSD's msun (e_rem_pio2.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Optimized by Bruce D. Evans.
 */
static uint32_t lw_rem_pio2_medium(double x, double *y)
{
    const double to_int = 0x1.8p52;
    const double inv_pio2 = 0x1.45f306dc9c883p-1; /* 6.36619772367581382433e-01 */
    const double pio2_1 = 0x1.921fb544p0; /* 1.57079632673412561417e+00 */
    const double pio2_1t = 0x1.0b4611a626331p-34; /* 6.07710050650619224932e-11 */
    const double pio2_2 = 0x1.0b4611a6p-34; /* 6.07710050630396597660e-11 */
    const double pio2_2t = 0x1.3198a2e037073p-69; /* 2.02226624879595063154e-21 */
    const double pio2_3 = 0x1.3198a2ep-69; /* 2.02226624871116645580e-21 */
    const double pio2_3t = 0x1.b839a252049c1p-104; /* 8.47842766036889956997e-32 */
    const double shifted = (x * inv_pio2) + to_int; /* This rounds the quotient to an integer. */
    const double n = shifted - to_int;
    const int32_t quotient = (int32_t)n;
    const uint32_t ex = (lw_high_word(x) >> 20U) & 0x7FFU;
    double r = x - (n * pio2_1);
    double w = n * pio2_1t; /* These are 85 bits of the product. */
    double y0 = r - w;
    double t;

    if (ex > (((lw_high_word(y0) >> 20U) & 0x7FFU) + 16U)) {
        /* 118 bits are needed. */
        t = r;
        w = n * pio2_2;
        r = t - w;
        w = (n * pio2_2t) - ((t - r) - w);
        y0 = r - w;
        if (ex > (((lw_high_word(y0) >> 20U) & 0x7FFU) + 49U)) {
            /* 151 bits are needed, which is enough for every x. */
            t = r;
            w = n * pio2_3;
            r = t - w;
            w = (n * pio2_3t) - ((t - r) - w);
            y0 = r - w;
        }
    }
    y[0] = y0;
    y[1] = (r - y0) - w;
    return (uint32_t)quotient & 3U;
}
