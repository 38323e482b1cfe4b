/* lw_k_sin: the sine of x + y for |x| up to about pi/4. The tail y counts only if has_tail is not 0.
 *
 * The algorithm is from FreeBSD's msun (k_sin.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_k_sin(double x, double y, uint32_t has_tail)
{
    const double s1 = -0x1.5555555555549p-3; /* -1.66666666666666324348e-01 */
    const double s2 = 0x1.111111110f8a6p-7; /* 8.33333333332248946124e-03 */
    const double s3 = -0x1.a01a019c161d5p-13; /* -1.98412698298579493134e-04 */
    const double s4 = 0x1.71de357b1fe7dp-19; /* 2.75573137070700676789e-06 */
    const double s5 = -0x1.ae5e68a2b9cebp-26; /* -2.50507602534068634195e-08 */
    const double s6 = 0x1.5d93a5acfd57cp-33; /* 1.58969099521155010221e-10 */
    const double z = x * x;
    const double w = z * z;
    const double r = s2 + (z * (s3 + (z * s4))) + (z * w * (s5 + (z * s6)));
    const double v = z * x;

    if (has_tail == 0U) {
        return x + (v * (s1 + (z * r)));
    }
    return x - (((z * ((0.5 * y) - (v * r))) - y) - (v * s1));
}
