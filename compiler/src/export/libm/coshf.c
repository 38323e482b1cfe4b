/* lw_coshf: the hyperbolic cosine of x.
 *
 * The algorithm is from musl (src/math/coshf.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static float lw_coshf(float x)
{
    const uint32_t ix = lw_bitsf(x) & 0x7FFFFFFFU;
    const float size = fabsf(x);
    float t;

    if (ix < 0x3F317217U) { /* |x| < ln2 */
        if (ix < 0x39800000U) { /* |x| < 2^-12 */
            return 1.0F;
        }
        t = lw_expm1f(size);
        return 1.0F + ((t * t) / (2.0F * (1.0F + t)));
    }
    if (ix < 0x42B17217U) { /* |x| < log(FLT_MAX) */
        t = lw_expf(size);
        return 0.5F * (t + (1.0F / t));
    }
    return lw_k_expo2f(size);
}
