/* lw_logf: the natural logarithm of x.
 *
 * The algorithm is from FreeBSD's msun (e_logf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_logf(float x)
{
    const float ln2_hi = 0x1.62e3p-1F; /* 6.9313812256e-01 */
    const float ln2_lo = 0x1.2fefa2p-17F; /* 9.0580006145e-06 */
    uint32_t ix = lw_bitsf(x);
    uint32_t exponent;
    int32_t k = 0;
    float f;
    float half;
    float s;
    float r;
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
    dk = (float)k;
    return (((s * (half + r)) + (dk * ln2_lo)) - half) + f + (dk * ln2_hi);
}
