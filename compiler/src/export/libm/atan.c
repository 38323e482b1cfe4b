/* lw_atan: the angle from -pi/2 to pi/2 whose tangent is x.
 *
 * The algorithm is from FreeBSD's msun (s_atan.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_atan(double x)
{
    /* The arctangents of 0.5, 1, 1.5 and infinity, in two parts. */
    static const double hi[4] = {
        0x1.dac670561bb4fp-2, /* 4.63647609000806093515e-01 */
        0x1.921fb54442d18p-1, /* 7.85398163397448278999e-01 */
        0x1.f730bd281f69bp-1, /* 9.82793723247329054082e-01 */
        0x1.921fb54442d18p0 /* 1.57079632679489655800e+00 */
    };
    static const double lo[4] = {
        0x1.a2b7f222f65e2p-56, /* 2.26987774529616870924e-17 */
        0x1.1a62633145c07p-55, /* 3.06161699786838301793e-17 */
        0x1.007887af0cbbdp-56, /* 1.39033110312309984516e-17 */
        0x1.1a62633145c07p-54 /* 6.12323399573676603587e-17 */
    };
    static const double a[11] = {
        0x1.555555555550dp-2, /* 3.33333333333329318027e-01 */
        -0x1.999999998ebc4p-3, /* -1.99999999998764832476e-01 */
        0x1.24924920083ffp-3, /* 1.42857142725034663711e-01 */
        -0x1.c71c6fe231671p-4, /* -1.11111104054623557880e-01 */
        0x1.745cdc54c206ep-4, /* 9.09088713343650656196e-02 */
        -0x1.3b0f2af749a6dp-4, /* -7.69187620504482999495e-02 */
        0x1.10d66a0d03d51p-4, /* 6.66107313738753120669e-02 */
        -0x1.dde2d52defd9ap-5, /* -5.83357013379057348645e-02 */
        0x1.97b4b24760debp-5, /* 4.97687799461593236017e-02 */
        -0x1.2b4442c6a6c2fp-5, /* -3.65315727442169155270e-02 */
        0x1.0ad3ae322da11p-6 /* 1.62858201153657823623e-02 */
    };
    const uint32_t hx = lw_high_word(x);
    const uint32_t ix = hx & 0x7FFFFFFFU;
    double t = fabs(x);
    double z;
    double w;
    double s1;
    double s2;
    double result;
    uint32_t id;

    if (ix >= 0x44100000U) { /* |x| >= 2^66 or NaN */
        if (lw_is_nan(x) != 0U) {
            return x;
        }
        return ((hx >> 31U) != 0U) ? -hi[3] : hi[3];
    }
    if (ix < 0x3E400000U) { /* |x| < 2^-27 */
        return x;
    }
    if (ix < 0x3FDC0000U) { /* |x| < 7/16 */
        t = x;
        id = 4U;
    } else if (ix < 0x3FE60000U) { /* |x| < 11/16 */
        t = ((2.0 * t) - 1.0) / (2.0 + t);
        id = 0U;
    } else if (ix < 0x3FF30000U) { /* |x| < 19/16 */
        t = (t - 1.0) / (t + 1.0);
        id = 1U;
    } else if (ix < 0x40038000U) { /* |x| < 39/16 */
        t = (t - 1.5) / (1.0 + (1.5 * t));
        id = 2U;
    } else {
        t = -1.0 / t;
        id = 3U;
    }
    z = t * t;
    w = z * z;
    /* The odd and the even terms are summed apart. */
    s1 = z * (a[0] + (w * (a[2] + (w * (a[4] + (w * (a[6] + (w * (a[8] + (w * a[10]))))))))));
    s2 = w * (a[1] + (w * (a[3] + (w * (a[5] + (w * (a[7] + (w * a[9]))))))));
    if (id == 4U) {
        return t - (t * (s1 + s2));
    }
    result = hi[id] - (((t * (s1 + s2)) - lo[id]) - t);
    return ((hx >> 31U) != 0U) ? -result : result;
}
