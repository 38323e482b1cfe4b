/* lw_atanf: the angle from -pi/2 to pi/2 whose tangent is x.
 *
 * The algorithm is from FreeBSD's msun (s_atanf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_atanf(float x)
{
    /* The arctangents of 0.5, 1, 1.5 and infinity, in two parts. */
    static const float hi[4] = {
        0x1.dac67p-2F, /* 4.6364760399e-01 */
        0x1.921fb4p-1F, /* 7.8539812565e-01 */
        0x1.f730bcp-1F, /* 9.8279368877e-01 */
        0x1.921fb4p0F /* 1.5707962513e+00 */
    };
    static const float lo[4] = {
        0x1.586ed2p-28F, /* 5.0121582440e-09 */
        0x1.4442dp-25F, /* 3.7748947079e-08 */
        0x1.281f68p-25F, /* 3.4473217170e-08 */
        0x1.4442dp-24F /* 7.5497894159e-08 */
    };
    static const float a[5] = {
        0x1.555552p-2F, /* 3.3333328366e-01 */
        -0x1.99953p-3F, /* -1.9999158382e-01 */
        0x1.23ea1ap-3F, /* 1.4253635705e-01 */
        -0x1.b4248ep-4F, /* -1.0648017377e-01 */
        0x1.f9584ap-5F /* 6.1687607318e-02 */
    };
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    float t = fabsf(x);
    float z;
    float w;
    float s1;
    float s2;
    float result;
    uint32_t id;

    if (ix >= 0x4C800000U) { /* |x| >= 2^26 or NaN */
        if (ix > 0x7F800000U) {
            return x;
        }
        return ((bits >> 31U) != 0U) ? -hi[3] : hi[3];
    }
    if (ix < 0x39800000U) { /* |x| < 2^-12 */
        return x;
    }
    if (ix < 0x3EE00000U) { /* |x| < 7/16 */
        t = x;
        id = 4U;
    } else if (ix < 0x3F300000U) { /* |x| < 11/16 */
        t = ((2.0F * t) - 1.0F) / (2.0F + t);
        id = 0U;
    } else if (ix < 0x3F980000U) { /* |x| < 19/16 */
        t = (t - 1.0F) / (t + 1.0F);
        id = 1U;
    } else if (ix < 0x401C0000U) { /* |x| < 39/16 */
        t = (t - 1.5F) / (1.0F + (1.5F * t));
        id = 2U;
    } else {
        t = -1.0F / t;
        id = 3U;
    }
    z = t * t;
    w = z * z;
    /* The odd and the even terms are summed apart. */
    s1 = z * (a[0] + (w * (a[2] + (w * a[4]))));
    s2 = w * (a[1] + (w * a[3]));
    if (id == 4U) {
        return t - (t * (s1 + s2));
    }
    result = hi[id] - (((t * (s1 + s2)) - lo[id]) - t);
    return ((bits >> 31U) != 0U) ? -result : result;
}
