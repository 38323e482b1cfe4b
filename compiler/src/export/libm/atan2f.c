/* lw_atan2f: the angle from -pi to pi of the direction (x, y).
 *
 * The algorithm is from FreeBSD's msun (e_atan2f.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_atan2f(float y, float x)
{
    const float pi = 0x1.921fb6p1F; /* 3.1415927410e+00 */
    const float pi_lo = -0x1.777a5cp-24F; /* -8.7422776573e-08 */
    const uint32_t ix = lw_bitsf(x) & 0x7FFFFFFFU;
    const uint32_t iy = lw_bitsf(y) & 0x7FFFFFFFU;
    const uint32_t left = lw_bitsf(x) >> 31U; /* It is 1 if x is negative. */
    float z;

    if ((ix > 0x7F800000U) || (iy > 0x7F800000U)) {
        return x + y; /* It is NaN. */
    }
    if (lw_bitsf(x) == 0x3F800000U) { /* x = 1 */
        return lw_atanf(y);
    }
    if (iy == 0U) {
        z = (left != 0U) ? pi : 0.0F;
    } else if (ix == 0U) {
        z = pi / 2.0F;
    } else if (ix == 0x7F800000U) {
        if (iy == 0x7F800000U) {
            z = (left != 0U) ? (3.0F * pi / 4.0F) : (pi / 4.0F);
        } else {
            z = (left != 0U) ? pi : 0.0F;
        }
    } else if (((ix + 0x0D000000U) < iy) || (iy == 0x7F800000U)) { /* |y/x| > 2^26 */
        z = pi / 2.0F;
    } else {
        if ((left != 0U) && ((iy + 0x0D000000U) < ix)) { /* |y/x| < 2^-26 */
            z = 0.0F;
        } else {
            z = lw_atanf(fabsf(y / x));
        }
        if (left != 0U) {
            z = pi - (z - pi_lo);
        }
    }
    return ((lw_bitsf(y) >> 31U) != 0U) ? -z : z;
}
