/* lw_tan: the tangent of x in radians.
 *
 * The algorithm is from FreeBSD's msun (s_tan.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_tan(double x)
{
    const uint32_t ix = lw_high_word(x) & 0x7FFFFFFFU;
    double y[2];
    uint32_t quadrant;

    if (ix <= 0x3FE921FBU) { /* |x| <= pi/4, or little more */
        if (ix < 0x3E400000U) { /* |x| < 2^-27 */
            return x;
        }
        return lw_k_tan(x, 0.0, 0U);
    }
    if (ix >= 0x7FF00000U) {
        return x - x; /* It is NaN. */
    }
    quadrant = lw_rem_pio2(x, y);
    return lw_k_tan(y[0], y[1], quadrant & 1U);
}
