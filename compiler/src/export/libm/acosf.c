/* lw_acosf: the angle from 0 to pi whose cosine is x.
 *
 * The algorithm is from FreeBSD's msun (e_acosf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_acosf(float x)
{
    const float pio2_hi = 0x1.921fb4p0F; /* 1.5707962513e+00 */
    const float pio2_lo = 0x1.4442dp-24F; /* 7.5497894159e-08 */
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    float z;
    float s;
    float w;
    float head;
    float c;

    if (ix >= 0x3F800000U) { /* |x| >= 1 or NaN */
        if (ix == 0x3F800000U) {
            return ((bits >> 31U) != 0U) ? (2.0F * pio2_hi) : 0.0F;
        }
        return 0.0F / (x - x); /* It is NaN. */
    }
    if (ix < 0x3F000000U) { /* |x| < 0.5 */
        if (ix <= 0x32800000U) { /* |x| <= 2^-26 */
            return pio2_hi;
        }
        return pio2_hi - (x - (pio2_lo - (x * lw_asin_rf(x * x))));
    }
    if ((bits >> 31U) != 0U) { /* x <= -0.5 */
        z = (1.0F + x) * 0.5F;
        s = sqrtf(z);
        w = (lw_asin_rf(z) * s) - pio2_lo;
        return 2.0F * (pio2_hi - (s + w));
    }
    z = (1.0F - x) * 0.5F;
    s = sqrtf(z);
    head = lw_from_bitsf(lw_bitsf(s) & 0xFFFFF000U);
    c = (z - (head * head)) / (s + head);
    w = (lw_asin_rf(z) * s) + c;
    return 2.0F * (head + w);
}
