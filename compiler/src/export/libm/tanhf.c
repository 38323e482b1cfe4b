/* lw_tanhf: the hyperbolic tangent of x.
 *
 * The algorithm is from musl (src/math/tanhf.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static float lw_tanhf(float x)
{
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    const float size = fabsf(x);
    float t;

    if (ix > 0x41200000U) { /* |x| > 10 or NaN */
        t = 1.0F + (0.0F / size);
    } else if (ix > 0x3F0C9F54U) { /* |x| > ln3 / 2 */
        t = lw_expm1f(2.0F * size);
        t = 1.0F - (2.0F / (t + 2.0F));
    } else if (ix > 0x3E82C578U) { /* |x| > ln(5/3) / 2 */
        t = lw_expm1f(2.0F * size);
        t = t / (t + 2.0F);
    } else if (ix >= 0x00800000U) { /* |x| >= 2^-126 */
        t = lw_expm1f(-2.0F * size);
        t = -t / (t + 2.0F);
    } else {
        t = size;
    }
    return ((bits >> 31U) != 0U) ? -t : t;
}
