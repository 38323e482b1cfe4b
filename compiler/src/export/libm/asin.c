/* lw_asin: the angle from -pi/2 to pi/2 whose sine is x.
 *
 * The algorithm is from FreeBSD's msun (e_asin.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_asin(double x)
{
    const double pio2_hi = 0x1.921fb54442d18p0; /* 1.57079632679489655800e+00 */
    const double pio2_lo = 0x1.1a62633145c07p-54; /* 6.12323399573676603587e-17 */
    const uint32_t hx = lw_high_word(x);
    const uint32_t ix = hx & 0x7FFFFFFFU;
    double z;
    double s;
    double r;
    double result;

    if (ix >= 0x3FF00000U) { /* |x| >= 1 or NaN */
        if ((lw_bits(x) & 0x7FFFFFFFFFFFFFFFU) == 0x3FF0000000000000U) {
            return x * pio2_hi;
        }
        return 0.0 / (x - x); /* It is NaN. */
    }
    if (ix < 0x3FE00000U) { /* |x| < 0.5 */
        if ((ix >= 0x00100000U) && (ix < 0x3E500000U)) { /* 2^-1022 <= |x| < 2^-26 */
            return x;
        }
        return x + (x * lw_asin_r(x * x));
    }
    z = (1.0 - fabs(x)) * 0.5;
    s = sqrt(z);
    r = lw_asin_r(z);
    if (ix >= 0x3FEF3333U) { /* |x| > 0.975 */
        result = pio2_hi - ((2.0 * (s + (s * r))) - pio2_lo);
    } else {
        /* f + c is the root of z. */
        const double f = lw_clear_low_word(s);
        const double c = (z - (f * f)) / (s + f);

        result = (0.5 * pio2_hi)
            - (((2.0 * s * r) - (pio2_lo - (2.0 * c))) - ((0.5 * pio2_hi) - (2.0 * f)));
    }
    return ((hx >> 31U) != 0U) ? -result : result;
}
