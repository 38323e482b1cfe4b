/* lw_acos: the angle from 0 to pi whose cosine is x.
 *
 * The algorithm is from FreeBSD's msun (e_acos.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_acos(double x)
{
    const double pio2_hi = 0x1.921fb54442d18p0; /* 1.57079632679489655800e+00 */
    const double pio2_lo = 0x1.1a62633145c07p-54; /* 6.12323399573676603587e-17 */
    const uint32_t hx = lw_high_word(x);
    const uint32_t ix = hx & 0x7FFFFFFFU;
    double z;
    double s;
    double w;
    double head;
    double c;

    if (ix >= 0x3FF00000U) { /* |x| >= 1 or NaN */
        if ((lw_bits(x) & 0x7FFFFFFFFFFFFFFFU) == 0x3FF0000000000000U) {
            return ((hx >> 31U) != 0U) ? (2.0 * pio2_hi) : 0.0;
        }
        return 0.0 / (x - x); /* It is NaN. */
    }
    if (ix < 0x3FE00000U) { /* |x| < 0.5 */
        if (ix <= 0x3C600000U) { /* |x| is about 2^-57 or less */
            return pio2_hi;
        }
        return pio2_hi - (x - (pio2_lo - (x * lw_asin_r(x * x))));
    }
    if ((hx >> 31U) != 0U) { /* x <= -0.5 */
        z = (1.0 + x) * 0.5;
        s = sqrt(z);
        w = (lw_asin_r(z) * s) - pio2_lo;
        return 2.0 * (pio2_hi - (s + w));
    }
    z = (1.0 - x) * 0.5;
    s = sqrt(z);
    head = lw_clear_low_word(s);
    c = (z - (head * head)) / (s + head);
    w = (lw_asin_r(z) * s) + c;
    return 2.0 * (head + w);
}
