/* lw_asin_rf: (asin(x) - x) / x for z = x^2 up to 1/4.
 *
 * The algorithm is from FreeBSD's msun (e_asinf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_asin_rf(float z)
{
    const float p0 = 0x1.5554eap-3F; /* 1.6666586697e-01 */
    const float p1 = -0x1.5e2774p-5F; /* -4.2743422091e-02 */
    const float p2 = -0x1.1ba6d6p-7F; /* -8.6563630030e-03 */
    const float q1 = -0x1.69cb5cp-1F; /* -7.0662963390e-01 */
    const float p = z * (p0 + (z * (p1 + (z * p2))));
    const float q = 1.0F + (z * q1);

    return p / q;
}
