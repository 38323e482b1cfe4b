/* lw_log: the natural logarithm of x.
 *
 * The algorithm is from FreeBSD's msun (e_log.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_log(double x)
{
    const double ln2_hi = 0x1.62e42feep-1; /* 6.93147180369123816490e-01 */
    const double ln2_lo = 0x1.a39ef35793c76p-33; /* 1.90821492927058770002e-10 */
    uint64_t bits = lw_bits(x);
    uint32_t hx = lw_high_word(x);
    uint32_t exponent;
    int32_t k = 0;
    double f;
    double half;
    double s;
    double r;
    double dk;

    if ((hx < 0x00100000U) || ((hx >> 31U) != 0U)) { /* x < 2^-1022 */
        if ((bits << 1U) == 0U) {
            return -1.0 / (x * x); /* It is infinite. */
        }
        if ((hx >> 31U) != 0U) {
            return 0.0 / (x - x); /* It is NaN. */
        }
        k = -54;
        bits = lw_bits(x * 0x1p54);
        hx = (uint32_t)(bits >> 32U);
    } else if (hx >= 0x7FF00000U) {
        return x;
    } else if (bits == 0x3FF0000000000000U) { /* x = 1 */
        return 0.0;
    } else {
        /* It is a normal number. */
    }

    /* x = 2^k (1 + f), where 1 + f is between the roots of 1/2 and 2. */
    hx += 0x3FF00000U - 0x3FE6A09EU;
    exponent = hx >> 20U;
    k += (int32_t)exponent - 0x3FF;
    hx = (hx & 0x000FFFFFU) + 0x3FE6A09EU;
    f = lw_from_bits(((uint64_t)hx << 32U) | (bits & 0xFFFFFFFFU)) - 1.0;
    half = 0.5 * f * f;
    s = f / (2.0 + f);
    r = lw_log_r(s * s);
    dk = (double)k;
    return (((s * (half + r)) + (dk * ln2_lo)) - half) + f + (dk * ln2_hi);
}
