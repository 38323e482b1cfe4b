/* lw_exp: e^x.
 *
 * The algorithm is from FreeBSD's msun (e_exp.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2004 by Sun Microsystems, Inc. All rights reserved.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_exp(double x)
{
    const double ln2_hi = 0x1.62e42feep-1; /* 6.93147180369123816490e-01 */
    const double ln2_lo = 0x1.a39ef35793c76p-33; /* 1.90821492927058770002e-10 */
    const double inv_ln2 = 0x1.71547652b82fep0; /* 1.44269504088896338700e+00 */
    const double p1 = 0x1.555555555553ep-3; /* 1.66666666666666019037e-01 */
    const double p2 = -0x1.6c16c16bebd93p-9; /* -2.77777777770155933842e-03 */
    const double p3 = 0x1.1566aaf25de2cp-14; /* 6.61375632143793436117e-05 */
    const double p4 = -0x1.bbd41c5d26bf1p-20; /* -1.65339022054652515390e-06 */
    const double p5 = 0x1.6376972bea4dp-25; /* 4.13813679705723846039e-08 */
    const double highest = 0x1.62e42fefa39efp9; /* 709.782712893383973096 */
    const double lowest = -0x1.74910d52d3051p9; /* -745.13321910194110842 */
    const uint32_t high = lw_high_word(x);
    const uint32_t hx = high & 0x7FFFFFFFU;
    const uint32_t negative = high >> 31U;
    double r = x;
    double hi = x;
    double lo = 0.0;
    double rr;
    double c;
    double y;
    int32_t k = 0;

    if (hx >= 0x4086232BU) { /* |x| >= 708.39... or NaN */
        if (lw_is_nan(x) != 0U) {
            return x;
        }
        if (x > highest) {
            return x * 0x1p1023; /* It is infinite. */
        }
        if (x < lowest) {
            return 0.0;
        }
    }
    if (hx > 0x3FD62E42U) { /* |x| > 0.5 ln2 */
        double n;

        if (hx >= 0x3FF0A2B2U) { /* |x| >= 1.5 ln2 */
            n = (inv_ln2 * x) + ((negative != 0U) ? -0.5 : 0.5);
            k = (int32_t)n;
        } else {
            k = 1 - (2 * (int32_t)negative);
        }
        n = (double)k;
        hi = x - (n * ln2_hi); /* The product is exact. */
        lo = n * ln2_lo;
        r = hi - lo;
    } else if (hx <= 0x3E300000U) { /* |x| <= 2^-28 */
        return 1.0 + x;
    } else {
        /* No multiple of ln2 is subtracted. */
    }
    rr = r * r;
    c = r - (rr * (p1 + (rr * (p2 + (rr * (p3 + (rr * (p4 + (rr * p5)))))))));
    y = 1.0 + ((((r * c) / (2.0 - c)) - lo) + hi);
    return (k == 0) ? y : lw_scalbn(y, k);
}
