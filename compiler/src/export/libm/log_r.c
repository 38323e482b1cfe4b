/* lw_log_r: log((1 + s) / (1 - s)) / s - 2 for z = s^2 up to 0.0295.
 *
 * The algorithm is from FreeBSD's msun (e_log.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_log_r(double z)
{
    const double lg1 = 0x1.5555555555593p-1; /* 6.666666666666735130e-01 */
    const double lg2 = 0x1.999999997fa04p-2; /* 3.999999999940941908e-01 */
    const double lg3 = 0x1.2492494229359p-2; /* 2.857142874366239149e-01 */
    const double lg4 = 0x1.c71c51d8e78afp-3; /* 2.222219843214978396e-01 */
    const double lg5 = 0x1.7466496cb03dep-3; /* 1.818357216161805012e-01 */
    const double lg6 = 0x1.39a09d078c69fp-3; /* 1.531383769920937332e-01 */
    const double lg7 = 0x1.2f112df3e5244p-3; /* 1.479819860511658591e-01 */
    const double w = z * z;
    const double t1 = w * (lg2 + (w * (lg4 + (w * lg6))));
    const double t2 = z * (lg1 + (w * (lg3 + (w * (lg5 + (w * lg7))))));

    return t2 + t1;
}
