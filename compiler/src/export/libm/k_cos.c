/* lw_k_cos: the cosine of x + y for |x| up to about pi/4, where y is the tail of x.
 *
 * The algorithm is from FreeBSD's msun (k_cos.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_k_cos(double x, double y)
{
    const double c1 = 0x1.555555555554cp-5; /* 4.16666666666666019037e-02 */
    const double c2 = -0x1.6c16c16c15177p-10; /* -1.38888888888741095749e-03 */
    const double c3 = 0x1.a01a019cb159p-16; /* 2.48015872894767294178e-05 */
    const double c4 = -0x1.27e4f809c52adp-22; /* -2.75573143513906633035e-07 */
    const double c5 = 0x1.1ee9ebdb4b1c4p-29; /* 2.08757232129817482790e-09 */
    const double c6 = -0x1.8fae9be8838d4p-37; /* -1.13596475577881948265e-11 */
    const double z = x * x;
    const double zz = z * z;
    const double r = (z * (c1 + (z * (c2 + (z * c3))))) + (zz * zz * (c4 + (z * (c5 + (z * c6)))));
    const double hz = 0.5 * z;
    const double w = 1.0 - hz;

    return w + (((1.0 - w) - hz) + ((z * r) - (x * y)));
}
