/* lw_asin_r: (asin(x) - x) / x for z = x^2 up to 1/4.
 *
 * The algorithm is from FreeBSD's msun (e_asin.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_asin_r(double z)
{
    const double p0 = 0x1.5555555555555p-3; /* 1.66666666666666657415e-01 */
    const double p1 = -0x1.4d61203eb6f7dp-2; /* -3.25565818622400915405e-01 */
    const double p2 = 0x1.9c1550e884455p-3; /* 2.01212532134862925881e-01 */
    const double p3 = -0x1.48228b5688f3bp-5; /* -4.00555345006794114027e-02 */
    const double p4 = 0x1.9efe07501b288p-11; /* 7.91534994289814532176e-04 */
    const double p5 = 0x1.23de10dfdf709p-15; /* 3.47933107596021167570e-05 */
    const double q1 = -0x1.33a271c8a2d4bp1; /* -2.40339491173441421878e+00 */
    const double q2 = 0x1.02ae59c598ac8p1; /* 2.02094576023350569471e+00 */
    const double q3 = -0x1.6066c1b8d0159p-1; /* -6.88283971605453293030e-01 */
    const double q4 = 0x1.3b8c5b12e9282p-4; /* 7.70381505559019352791e-02 */
    const double p = z * (p0 + (z * (p1 + (z * (p2 + (z * (p3 + (z * (p4 + (z * p5))))))))));
    const double q = 1.0 + (z * (q1 + (z * (q2 + (z * (q3 + (z * q4)))))));

    return p / q;
}
