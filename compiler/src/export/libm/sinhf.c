/* lw_sinhf: the hyperbolic sine of x.
 *
 * The algorithm is from musl (src/math/sinhf.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static float lw_sinhf(float x)
{
    const uint32_t bits = lw_bitsf(x);
    const uint32_t ix = bits & 0x7FFFFFFFU;
    const float h = ((bits >> 31U) != 0U) ? -0.5F : 0.5F;
    const float size = fabsf(x);
    float t;

    if (ix < 0x42B17217U) { /* |x| < log(FLT_MAX) */
        if (ix < 0x39800000U) { /* |x| < 2^-12 */
            return x;
        }
        t = lw_expm1f(size);
        if (ix < 0x3F800000U) { /* |x| < 1 */
            return h * ((2.0F * t) - ((t * t) / (t + 1.0F)));
        }
        return h * (t + (t / (t + 1.0F)));
    }
    return 2.0F * h * lw_k_expo2f(size);
}
