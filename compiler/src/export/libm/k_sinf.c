/* lw_k_sinf: the sine of x for |x| up to about pi/4.
 *
 * The algorithm is from FreeBSD's msun (k_sinf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 * Optimized by Bruce D. Evans.
 */
static float lw_k_sinf(double x)
{
    const double s1 = -0x1.5555554cbac77p-3; /* -0.166666666416265235595 */
    const double s2 = 0x1.11110896efbb2p-7; /* 0.0083333293858894631756 */
    const double s3 = -0x1.a00f9e2cae774p-13; /* -0.000198393348360966317347 */
    const double s4 = 0x1.6cd878c3b46a7p-19; /* 0.0000027183114939898219064 */
    const double z = x * x;
    const double w = z * z;
    const double r = s3 + (z * s4);
    const double s = z * x;

    return (float)((x + (s * (s1 + (z * s2)))) + (s * w * r));
}
