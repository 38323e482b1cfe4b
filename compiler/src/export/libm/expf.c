/* lw_expf: e^x.
 *
 * The algorithm is from FreeBSD's msun (e_expf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_expf(float x)
{
    const float ln2_hi = 0x1.62e4p-1F; /* 6.9314575195e-01 */
    const float ln2_lo = 0x1.7f7d1cp-20F; /* 1.4286067653e-06 */
    const float inv_ln2 = 0x1.715476p0F; /* 1.4426950216e+00 */
    const float p1 = 0x1.55551ep-3F; /* 1.6666625440e-1 */
    const float p2 = -0x1.6aa42ap-9F; /* -2.7667332906e-3 */
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    const uint32_t negative = bits >> 31U;
    float r = x;
    float hi = x;
    float lo = 0.0F;
    float rr;
    float c;
    float y;
    int32_t k = 0;

    if (ix > 0x7F800000U) {
        return x; /* It is NaN. */
    }
    if ((ix >= 0x42B17218U) && (negative == 0U)) { /* x >= 88.722839 */
        return x * 0x1p127F; /* It is infinite. */
    }
    if ((ix >= 0x42CFF1B5U) && (negative != 0U)) { /* x <= -103.972084 */
        return 0.0F;
    }
    if (ix > 0x3EB17218U) { /* |x| > 0.5 ln2 */
        float n;

        if (ix > 0x3F851592U) { /* |x| > 1.5 ln2 */
            n = (inv_ln2 * x) + ((negative != 0U) ? -0.5F : 0.5F);
            k = (int32_t)n;
        } else {
            k = 1 - (2 * (int32_t)negative);
        }
        n = (float)k;
        hi = x - (n * ln2_hi); /* The product is exact. */
        lo = n * ln2_lo;
        r = hi - lo;
    } else if (ix <= 0x39000000U) { /* |x| <= 2^-13 */
        return 1.0F + x;
    } else {
        /* No multiple of ln2 is subtracted. */
    }
    rr = r * r;
    c = r - (rr * (p1 + (rr * p2)));
    y = 1.0F + ((((r * c) / (2.0F - c)) - lo) + hi);
    return (k == 0) ? y : lw_scalbnf(y, k);
}
