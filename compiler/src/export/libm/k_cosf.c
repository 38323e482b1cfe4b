/* lw_k_cosf: the cosine of x for |x| up to about pi/4.
 *
 * The algorithm is from FreeBSD's msun (k_cosf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 * Debugged and optimized by Bruce D. Evans.
 */
static float lw_k_cosf(double x)
{
    const double c0 = -0x1.ffffffd0c5e81p-2; /* -0.499999997251031003120 */
    const double c1 = 0x1.55553e1053a42p-5; /* 0.0416666233237390631894 */
    const double c2 = -0x1.6c087e80f1e27p-10; /* -0.00138867637746099294692 */
    const double c3 = 0x1.99342e0ee5069p-16; /* 0.0000243904487962774090654 */
    const double z = x * x;
    const double w = z * z;
    const double r = c2 + (z * c3);

    return (float)(((1.0 + (z * c0)) + (w * c1)) + ((w * z) * r));
}
