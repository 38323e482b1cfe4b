/* lw_sinh: the hyperbolic sine of x.
 *
 * The algorithm is from musl (src/math/sinh.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static double lw_sinh(double x)
{
    const uint32_t high = lw_high_word(x);
    const uint32_t hx = high & 0x7FFFFFFFU;
    const double h = ((high >> 31U) != 0U) ? -0.5 : 0.5;
    const double size = fabs(x);
    double t;

    if (hx < 0x40862E42U) { /* |x| < log(DBL_MAX) */
        if (hx < 0x3E500000U) { /* |x| < 2^-26 */
            return x;
        }
        t = lw_expm1(size);
        if (hx < 0x3FF00000U) { /* |x| < 1 */
            return h * ((2.0 * t) - ((t * t) / (t + 1.0)));
        }
        return h * (t + (t / (t + 1.0)));
    }
    return 2.0 * h * lw_k_expo2(size);
}
