/* lw_rem_pio2: what remains of a finite x beyond pi/4 after division by pi/2, in y[0] + y[1], and the last
 * two bits of the quotient.
 *
 * The algorithm is from FreeBSD's msun (e_rem_pio2.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Optimized by Bruce D. Evans.
 */
static uint32_t lw_rem_pio2(double x, double *y)
{
    const double pio2_1 = 0x1.921fb544p0; /* 1.57079632673412561417e+00 */
    const double pio2_1t = 0x1.0b4611a626331p-34; /* 6.07710050650619224932e-11 */
    const uint32_t hx = lw_high_word(x);
    const uint32_t ix = hx & 0x7FFFFFFFU;
    int32_t n; /* The multiple of pi/2 near |x|, or 0 if that is not the whole reduction. */
    uint32_t quotient;

    if ((ix == 0x3FF921FBU) || (ix == 0x400921FBU) || (ix == 0x4012D97CU) || (ix == 0x401921FBU)) {
        n = 0; /* Near a multiple, digits cancel. */
    } else if (ix <= 0x4002D97CU) { /* |x| <= 3pi/4 */
        n = 1;
    } else if (ix <= 0x400F6A7AU) { /* |x| <= 5pi/4 */
        n = 2;
    } else if (ix <= 0x4015FDBCU) { /* |x| <= 7pi/4 */
        n = 3;
    } else if (ix <= 0x401C463BU) { /* |x| <= 9pi/4 */
        n = 4;
    } else {
        n = 0;
    }

    if (n != 0) {
        double multiple;
        double z;
        double tail;

        n = ((hx >> 31U) != 0U) ? -n : n;
        multiple = (double)n;
        z = x - (multiple * pio2_1);
        tail = multiple * pio2_1t;
        y[0] = z - tail;
        y[1] = (z - y[0]) - tail;
        quotient = (uint32_t)n;
    } else if (ix < 0x413921FBU) { /* |x| < 2^20 * pi/2 */
        quotient = lw_rem_pio2_medium(x, y);
    } else {
        /* |x| is cut into pieces of 24 bits. */
        const uint32_t exponent = ix >> 20U;
        double z = lw_from_bits((lw_bits(x) & 0x000FFFFFFFFFFFFFU) | 0x4160000000000000U);
        double pieces[3];
        int32_t used = 3;
        int32_t i;

        for (i = 0; i < 2; i++) {
            pieces[i] = (double)(int32_t)z;
            z = (z - pieces[i]) * 0x1p24;
        }
        pieces[2] = z;
        /* No piece is negative, and the first is not 0. */
        while (pieces[used - 1] <= 0.0) {
            used--;
        }
        quotient = lw_rem_pio2_large(pieces, used, y, (int32_t)exponent - 1046, 1U);
        if ((hx >> 31U) != 0U) {
            y[0] = -y[0];
            y[1] = -y[1];
            quotient = 8U - quotient;
        }
    }
    return quotient & 3U;
}
