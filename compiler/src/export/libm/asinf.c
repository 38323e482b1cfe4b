/* lw_asinf: the angle from -pi/2 to pi/2 whose sine is x.
 *
 * The algorithm is from FreeBSD's msun (e_asinf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_asinf(float x)
{
    const double pio2 = 0x1.921fb54442d18p0; /* 1.570796326794896558e+00 */
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    float z;
    double s;
    float result;

    if (ix >= 0x3F800000U) { /* |x| >= 1 or NaN */
        if (ix == 0x3F800000U) {
            return (float)((double)x * pio2);
        }
        return 0.0F / (x - x); /* It is NaN. */
    }
    if (ix < 0x3F000000U) { /* |x| < 0.5 */
        if ((ix >= 0x00800000U) && (ix < 0x39800000U)) { /* 2^-126 <= |x| < 2^-12 */
            return x;
        }
        return x + (x * lw_asin_rf(x * x));
    }
    z = (1.0F - fabsf(x)) * 0.5F;
    s = sqrt((double)z);
    result = (float)(pio2 - (2.0 * (s + (s * (double)lw_asin_rf(z)))));
    return ((bits >> 31U) != 0U) ? -result : result;
}
