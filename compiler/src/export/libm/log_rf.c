/* lw_log_rf: log((1 + s) / (1 - s)) / s - 2 for z = s^2 up to 0.0295.
 *
 * The algorithm is from FreeBSD's msun (e_logf.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 * Conversion to float by Ian Lance Taylor, Cygnus Support, ian@cygnus.com.
 */
static float lw_log_rf(float z)
{
    const float lg1 = 0x1.555554p-1F; /* 0.66666662693 */
    const float lg2 = 0x1.999c26p-2F; /* 0.40000972152 */
    const float lg3 = 0x1.23d3dcp-2F; /* 0.28498786688 */
    const float lg4 = 0x1.f13c4cp-3F; /* 0.24279078841 */
    const float w = z * z;
    const float t1 = w * (lg2 + (w * lg4));
    const float t2 = z * (lg1 + (w * lg3));

    return t2 + t1;
}
