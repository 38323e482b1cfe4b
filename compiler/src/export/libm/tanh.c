/* lw_tanh: the hyperbolic tangent of x.
 *
 * The algorithm is from musl (src/math/tanh.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static double lw_tanh(double x)
{
    const uint32_t high = lw_high_word(x);
    const uint32_t hx = high & 0x7FFFFFFFU;
    const double size = fabs(x);
    double t;

    if (hx > 0x40340000U) { /* |x| > 20 or NaN */
        t = 1.0 - (0.0 / size);
    } else if (hx > 0x3FE193EAU) { /* |x| > ln3 / 2 */
        t = lw_expm1(2.0 * size);
        t = 1.0 - (2.0 / (t + 2.0));
    } else if (hx > 0x3FD058AEU) { /* |x| > ln(5/3) / 2 */
        t = lw_expm1(2.0 * size);
        t = t / (t + 2.0);
    } else if (hx >= 0x00100000U) { /* |x| >= 2^-1022 */
        t = lw_expm1(-2.0 * size);
        t = -t / (t + 2.0);
    } else {
        t = size;
    }
    return ((high >> 31U) != 0U) ? -t : t;
}
