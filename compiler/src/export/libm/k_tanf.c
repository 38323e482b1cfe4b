/* lw_k_tanf: the tangent of x for |x| up to about pi/4; -1 / tangent if odd is 1.
 *
 * The algorithm is from FreeBSD's msun (k_tan.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright 2004 Sun Microsystems, Inc. All Rights Reserved.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static float lw_k_tanf(double x, uint32_t odd)
{
    static const double t[6] = {
        0x1.5554d3418c99fp-2, /* 0.333331395030791399758 */
        0x1.112fd38999f72p-3, /* 0.133392002712976742718 */
        0x1.b54c91d865afep-5, /* 0.0533812378445670393523 */
        0x1.91df3908c33cep-6, /* 0.0245283181166547278873 */
        0x1.85dadfcecf44ep-9, /* 0.00297435743359967304927 */
        0x1.362b9bf971bcdp-7 /* 0.00946564784943673166728 */
    };
    const double z = x * x;
    const double w = z * z;
    const double s = z * x;
    const double high = t[4] + (z * t[5]);
    const double middle = t[2] + (z * t[3]);
    const double low = t[0] + (z * t[1]);
    const double r = (x + (s * low)) + ((s * w) * (middle + (w * high)));

    return (float)((odd != 0U) ? (-1.0 / r) : r);
}
