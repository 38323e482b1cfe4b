/* lw_atan2: the angle from -pi to pi of the direction (x, y).
 *
 * The algorithm is from FreeBSD's msun (e_atan2.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_atan2(double y, double x)
{
    const double pi = 0x1.921fb54442d18p1; /* 3.1415926535897931160E+00 */
    const double pi_lo = 0x1.1a62633145c07p-53; /* 1.2246467991473531772E-16 */
    const uint64_t bits_x = lw_bits(x) & 0x7FFFFFFFFFFFFFFFU;
    const uint64_t bits_y = lw_bits(y) & 0x7FFFFFFFFFFFFFFFU;
    const uint32_t ix = (uint32_t)(bits_x >> 32U);
    const uint32_t iy = (uint32_t)(bits_y >> 32U);
    const uint32_t left = lw_high_word(x) >> 31U; /* It is 1 if x is negative. */
    double z;

    if ((lw_is_nan(x) != 0U) || (lw_is_nan(y) != 0U)) {
        return x + y;
    }
    if (lw_bits(x) == 0x3FF0000000000000U) { /* x = 1 */
        return lw_atan(y);
    }
    if (bits_y == 0U) {
        z = (left != 0U) ? pi : 0.0;
    } else if (bits_x == 0U) {
        z = pi / 2.0;
    } else if (ix == 0x7FF00000U) {
        if (iy == 0x7FF00000U) {
            z = (left != 0U) ? (3.0 * pi / 4.0) : (pi / 4.0);
        } else {
            z = (left != 0U) ? pi : 0.0;
        }
    } else if (((ix + 0x04000000U) < iy) || (iy == 0x7FF00000U)) { /* |y/x| > 2^64 */
        z = pi / 2.0;
    } else {
        if ((left != 0U) && ((iy + 0x04000000U) < ix)) { /* |y/x| < 2^-64 */
            z = 0.0;
        } else {
            z = lw_atan(fabs(y / x));
        }
        if (left != 0U) {
            z = pi - (z - pi_lo);
        }
    }
    return ((lw_bits(y) >> 63U) != 0U) ? -z : z;
}
