/* lw_log10: the logarithm of x to base 10.
 *
 * The algorithm is from FreeBSD's msun (e_log10.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_log10(double x)
{
    const double inv_ln10_hi = 0x1.bcb7b152p-2; /* 4.34294481878168880939e-01 */
    const double inv_ln10_lo = 0x1.b9438ca9aadd5p-36; /* 2.50829467116452752298e-11 */
    const double log10_2_hi = 0x1.34413509f6p-2; /* 3.01029995663611771306e-01 */
    const double log10_2_lo = 0x1.9fef311f12b36p-42; /* 3.69423907715893078616e-13 */
    uint64_t bits = lw_bits(x);
    uint32_t hx = lw_high_word(x);
    uint32_t exponent;
    int32_t k = 0;
    double f;
    double half;
    double s;
    double r;
    double hi;
    double lo;
    double dk;
    double y;
    double w;
    double value_hi;
    double value_lo;

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

    /* hi + lo is the natural logarithm of 1 + f. */
    hi = lw_clear_low_word(f - half);
    lo = ((f - hi) - half) + (s * (half + r));

    /* The sum of both values is the logarithm to base 10. */
    dk = (double)k;
    value_hi = hi * inv_ln10_hi;
    y = dk * log10_2_hi;
    value_lo = (dk * log10_2_lo) + ((lo + hi) * inv_ln10_lo) + (lo * inv_ln10_hi);
    w = y + value_hi;
    value_lo += (y - w) + value_hi;
    return value_lo + w;
}
