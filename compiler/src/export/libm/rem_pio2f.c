/* lw_rem_pio2f: what remains of a finite x beyond pi/4 after division by pi/2, in y[0], and the last two
 * bits of the quotient.
 *
 * The algorithm is from FreeBSD's msun (e_rem_pio2f.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 * Debugged and optimized by Bruce D. Evans.
 */
static uint32_t lw_rem_pio2f(float x, double *y)
{
    const double pio2 = 0x1.921fb54442d18p0; /* 1.57079632679489661923 */
    const double to_int = 0x1.8p52;
    const double inv_pio2 = 0x1.45f306dc9c883p-1; /* 6.36619772367581382433e-01 */
    const double pio2_1 = 0x1.921fb5p0; /* 1.57079631090164184570e+00 */
    const double pio2_1t = 0x1.110b4611a6263p-26; /* 1.58932547735281966916e-08 */
    const uint32_t bits = lw_bitsf(x);
    const uint32_t negative = bits >> 31U;
    const uint32_t ix = bits & 0x7FFFFFFFU;
    const double wide = (double)x;
    uint32_t quotient;

    if (ix <= 0x40E231D5U) { /* |x| <= 9pi/4 */
        int32_t n;

        if (ix <= 0x4016CBE3U) { /* |x| <= 3pi/4 */
            n = 1;
        } else if (ix <= 0x407B53D1U) { /* |x| <= 5pi/4 */
            n = 2;
        } else if (ix <= 0x40AFEDDFU) { /* |x| <= 7pi/4 */
            n = 3;
        } else {
            n = 4;
        }
        n = (negative != 0U) ? -n : n;
        y[0] = wide - ((double)n * pio2);
        quotient = (uint32_t)n;
    } else if (ix < 0x4DC90FDBU) { /* |x| < 2^28 * pi/2 */
        const double shifted = (wide * inv_pio2) + to_int; /* This rounds the quotient to an integer. */
        const double n = shifted - to_int;
        const int32_t integer = (int32_t)n;

        y[0] = wide - (n * pio2_1) - (n * pio2_1t);
        quotient = (uint32_t)integer;
    } else {
        /* |x| is an integer of 24 bits, times a power of 2. */
        const uint32_t exponent = ix >> 23U;
        const double piece = (double)lw_from_bitsf((ix & 0x007FFFFFU) | 0x4B000000U);

        quotient = lw_rem_pio2_large(&piece, 1, y, (int32_t)exponent - 150, 0U);
        if (negative != 0U) {
            y[0] = -y[0];
            quotient = 8U - quotient;
        }
    }
    return quotient & 3U;
}
