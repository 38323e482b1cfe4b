/* lw_sinf: the sine of x in radians.
 *
 * The algorithm is from FreeBSD's msun (s_sinf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 * Optimized by Bruce D. Evans.
 */
static float lw_sinf(float x)
{
    const uint32_t ix = lw_bitsf(x) & 0x7FFFFFFFU;
    double y;
    float result;

    if (ix <= 0x3F490FDAU) { /* |x| <= pi/4 */
        if (ix < 0x39800000U) { /* |x| < 2^-12 */
            return x;
        }
        return lw_k_sinf((double)x);
    }
    if (ix >= 0x7F800000U) {
        return x - x; /* It is NaN. */
    }
    switch (lw_rem_pio2f(x, &y)) {
    case 0U:
        result = lw_k_sinf(y);
        break;
    case 1U:
        result = lw_k_cosf(y);
        break;
    case 2U:
        result = lw_k_sinf(-y);
        break;
    default:
        result = -lw_k_cosf(y);
        break;
    }
    return result;
}
