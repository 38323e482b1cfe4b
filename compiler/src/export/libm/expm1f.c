/* lw_expm1f: e^x - 1.
 *
 * The algorithm is from FreeBSD's msun (s_expm1f.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_expm1f(float x)
{
    const float ln2_hi = 0x1.62e3p-1F; /* 6.9313812256e-01 */
    const float ln2_lo = 0x1.2fefa2p-17F; /* 9.0580006145e-06 */
    const float inv_ln2 = 0x1.715476p0F; /* 1.4426950216e+00 */
    const float q1 = -0x1.1110dp-5F; /* -3.3333212137e-2 */
    const float q2 = 0x1.9e602p-10F; /* 1.5807170421e-3 */
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    const uint32_t negative = bits >> 31U;
    float r = x;
    float c = 0.0F;
    float half;
    float rr;
    float r1;
    float t;
    float e;
    float y;
    int32_t k = 0;

    if (ix >= 0x4195B844U) { /* |x| >= 27 ln2 or NaN */
        if (ix > 0x7F800000U) {
            return x;
        }
        if (negative != 0U) {
            return -1.0F;
        }
        if (ix > 0x42B17217U) { /* x > log(FLT_MAX) */
            return x * 0x1p127F; /* It is infinite. */
        }
    }
    if (ix > 0x3EB17218U) { /* |x| > 0.5 ln2 */
        float n;
        float hi;
        float lo;

        if (ix < 0x3F851592U) { /* |x| < 1.5 ln2 */
            k = 1 - (2 * (int32_t)negative);
        } else {
            n = (inv_ln2 * x) + ((negative != 0U) ? -0.5F : 0.5F);
            k = (int32_t)n;
        }
        n = (float)k;
        hi = x - (n * ln2_hi); /* The product is exact. */
        lo = n * ln2_lo;
        r = hi - lo;
        c = (hi - r) - lo;
    } else if (ix < 0x33000000U) { /* |x| < 2^-25 */
        return x;
    } else {
        /* No multiple of ln2 is subtracted. */
    }
    half = 0.5F * r;
    rr = r * half;
    r1 = 1.0F + (rr * (q1 + (rr * q2)));
    t = 3.0F - (r1 * half);
    e = rr * ((r1 - t) / (6.0F - (r * t)));
    if (k == 0) {
        return r - ((r * e) - rr);
    }
    e = (r * (e - c)) - c;
    e -= rr;
    /* e^x is about 2^k (r - e + 1). */
    if (k == -1) {
        return (0.5F * (r - e)) - 0.5F;
    }
    if (k == 1) {
        if (r < -0.25F) {
            return -2.0F * (e - (r + 0.5F));
        }
        return 1.0F + (2.0F * (r - e));
    }
    if ((k < 0) || (k > 56)) {
        y = (r - e) + 1.0F;
        if (k == 128) {
            y = y * 2.0F * 0x1p127F;
        } else {
            y = y * lw_pow2f(k);
        }
        y = y - 1.0F;
    } else if (k < 23) {
        y = ((r - e) + (1.0F - lw_pow2f(-k))) * lw_pow2f(k);
    } else {
        y = ((r - (e + lw_pow2f(-k))) + 1.0F) * lw_pow2f(k);
    }
    return y;
}
