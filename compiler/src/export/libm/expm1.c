/* lw_expm1: e^x - 1.
 *
 * The algorithm is from FreeBSD's msun (s_expm1.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunPro, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static double lw_expm1(double x)
{
    const double highest = 0x1.62e42fefa39efp9; /* 7.09782712893383973096e+02 */
    const double ln2_hi = 0x1.62e42feep-1; /* 6.93147180369123816490e-01 */
    const double ln2_lo = 0x1.a39ef35793c76p-33; /* 1.90821492927058770002e-10 */
    const double inv_ln2 = 0x1.71547652b82fep0; /* 1.44269504088896338700e+00 */
    const double q1 = -0x1.11111111110f4p-5; /* -3.33333333333331316428e-02 */
    const double q2 = 0x1.a01a019fe5585p-10; /* 1.58730158725481460165e-03 */
    const double q3 = -0x1.4ce199eaadbb7p-14; /* -7.93650757867487942473e-05 */
    const double q4 = 0x1.0cfca86e65239p-18; /* 4.00821782732936239552e-06 */
    const double q5 = -0x1.afdb76e09c32dp-23; /* -2.01099218183624371326e-07 */
    const uint32_t high = lw_high_word(x);
    const uint32_t hx = high & 0x7FFFFFFFU;
    const uint32_t negative = high >> 31U;
    double r = x;
    double c = 0.0;
    double half;
    double rr;
    double r1;
    double t;
    double e;
    double y;
    int32_t k = 0;

    if (hx >= 0x4043687AU) { /* |x| >= 56 ln2 or NaN */
        if (lw_is_nan(x) != 0U) {
            return x;
        }
        if (negative != 0U) {
            return -1.0;
        }
        if (x > highest) {
            return x * 0x1p1023; /* It is infinite. */
        }
    }
    if (hx > 0x3FD62E42U) { /* |x| > 0.5 ln2 */
        double n;
        double hi;
        double lo;

        if (hx < 0x3FF0A2B2U) { /* |x| < 1.5 ln2 */
            k = 1 - (2 * (int32_t)negative);
        } else {
            n = (inv_ln2 * x) + ((negative != 0U) ? -0.5 : 0.5);
            k = (int32_t)n;
        }
        n = (double)k;
        hi = x - (n * ln2_hi); /* The product is exact. */
        lo = n * ln2_lo;
        r = hi - lo;
        c = (hi - r) - lo;
    } else if (hx < 0x3C900000U) { /* |x| < 2^-54 */
        return x;
    } else {
        /* No multiple of ln2 is subtracted. */
    }
    half = 0.5 * r;
    rr = r * half;
    r1 = 1.0 + (rr * (q1 + (rr * (q2 + (rr * (q3 + (rr * (q4 + (rr * q5)))))))));
    t = 3.0 - (r1 * half);
    e = rr * ((r1 - t) / (6.0 - (r * t)));
    if (k == 0) {
        return r - ((r * e) - rr);
    }
    e = (r * (e - c)) - c;
    e -= rr;
    /* e^x is about 2^k (r - e + 1). */
    if (k == -1) {
        return (0.5 * (r - e)) - 0.5;
    }
    if (k == 1) {
        if (r < -0.25) {
            return -2.0 * (e - (r + 0.5));
        }
        return 1.0 + (2.0 * (r - e));
    }
    if ((k < 0) || (k > 56)) {
        y = (r - e) + 1.0;
        if (k == 1024) {
            y = y * 2.0 * 0x1p1023;
        } else {
            y = y * lw_pow2(k);
        }
        y = y - 1.0;
    } else if (k < 20) {
        y = ((r - e) + (1.0 - lw_pow2(-k))) * lw_pow2(k);
    } else {
        y = ((r - (e + lw_pow2(-k))) + 1.0) * lw_pow2(k);
    }
    return y;
}
