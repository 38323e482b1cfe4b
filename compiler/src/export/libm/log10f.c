/* lw_log10f: the logarithm of x to base 10.
 *
 * The algorithm is from FreeBSD's msun (e_log10f.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static float lw_log10f(float x)
{
    const float inv_ln10_hi = 0x1.bccp-2F; /* 4.3432617188e-01 */
    const float inv_ln10_lo = -0x1.09d5b2p-15F; /* -3.1689971365e-05 */
    const float log10_2_hi = 0x1.3441p-2F; /* 3.0102920532e-01 */
    const float log10_2_lo = 0x1.a84fb6p-21F; /* 7.9034151668e-07 */
    uint32_t ix = lw_bitsf(x);
    uint32_t exponent;
    int32_t k = 0;
    float f;
    float half;
    float s;
    float r;
    float hi;
    float lo;
    float dk;

    if ((ix < 0x00800000U) || ((ix >> 31U) != 0U)) { /* x < 2^-126 */
        if ((ix << 1U) == 0U) {
            return -1.0F / (x * x); /* It is infinite. */
        }
        if ((ix >> 31U) != 0U) {
            return 0.0F / (x - x); /* It is NaN. */
        }
        k = -25;
        ix = lw_bitsf(x * 0x1p25F);
    } else if (ix >= 0x7F800000U) {
        return x;
    } else if (ix == 0x3F800000U) { /* x = 1 */
        return 0.0F;
    } else {
        /* It is a normal number. */
    }

    /* x = 2^k (1 + f), where 1 + f is between the roots of 1/2 and 2. */
    ix += 0x3F800000U - 0x3F3504F3U;
    exponent = ix >> 23U;
    k += (int32_t)exponent - 0x7F;
    f = lw_from_bitsf((ix & 0x007FFFFFU) + 0x3F3504F3U) - 1.0F;
    half = 0.5F * f * f;
    s = f / (2.0F + f);
    r = lw_log_rf(s * s);

    /* hi + lo is the natural logarithm of 1 + f. */
    hi = lw_from_bitsf(lw_bitsf(f - half) & 0xFFFFF000U);
    lo = ((f - hi) - half) + (s * (half + r));
    dk = (float)k;
    return (dk * log10_2_lo) + ((lo + hi) * inv_ln10_lo) + (lo * inv_ln10_hi) + (hi * inv_ln10_hi)
        + (dk * log10_2_hi);
}
