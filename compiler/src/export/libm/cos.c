/* lw_cos: the cosine of x in radians.
 *
 * The algorithm is from FreeBSD's msun (s_cos.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_cos(double x)
{
    const uint32_t ix = lw_high_word(x) & 0x7FFFFFFFU;
    double y[2];
    double result;

    if (ix <= 0x3FE921FBU) { /* |x| <= pi/4, or little more */
        if (ix < 0x3E46A09EU) { /* |x| < 2^-27 * sqrt(2) */
            return 1.0;
        }
        return lw_k_cos(x, 0.0);
    }
    if (ix >= 0x7FF00000U) {
        return x - x; /* It is NaN. */
    }
    switch (lw_rem_pio2(x, y)) {
    case 0U:
        result = lw_k_cos(y[0], y[1]);
        break;
    case 1U:
        result = -lw_k_sin(y[0], y[1], 1U);
        break;
    case 2U:
        result = -lw_k_cos(y[0], y[1]);
        break;
    default:
        result = lw_k_sin(y[0], y[1], 1U);
        break;
    }
    return result;
}
