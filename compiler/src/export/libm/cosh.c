/* lw_cosh: the hyperbolic cosine of x.
 *
 * The algorithm is from musl (src/math/cosh.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static double lw_cosh(double x)
{
    const uint32_t hx = lw_high_word(x) & 0x7FFFFFFFU;
    const double size = fabs(x);
    double t;

    if (hx < 0x3FE62E42U) { /* |x| < ln2 */
        if (hx < 0x3E500000U) { /* |x| < 2^-26 */
            return 1.0;
        }
        t = lw_expm1(size);
        return 1.0 + ((t * t) / (2.0 * (1.0 + t)));
    }
    if (hx < 0x40862E42U) { /* |x| < log(DBL_MAX) */
        t = lw_exp(size);
        return 0.5 * (t + (1.0 / t));
    }
    return lw_k_expo2(size);
}
