/* lw_tanf: the tangent of x in radians.
 *
 * The algorithm is from FreeBSD's msun (s_tanf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 * Optimized by Bruce D. Evans.
 */
static float lw_tanf(float x)
{
    const uint32_t ix = lw_bitsf(x) & 0x7FFFFFFFU;
    double y;
    uint32_t quadrant;

    if (ix <= 0x3F490FDAU) { /* |x| <= pi/4 */
        if (ix < 0x39800000U) { /* |x| < 2^-12 */
            return x;
        }
        return lw_k_tanf((double)x, 0U);
    }
    if (ix >= 0x7F800000U) {
        return x - x; /* It is NaN. */
    }
    quadrant = lw_rem_pio2f(x, &y);
    return lw_k_tanf(y, quadrant & 1U);
}
