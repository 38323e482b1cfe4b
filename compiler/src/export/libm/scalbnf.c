/* lw_scalbnf: x * 2^n for n from -228 to 254, rounded once.
 *
 * The algorithm is from musl (src/math/scalbnf.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static float lw_scalbnf(float x, int32_t n)
{
    float y = x;
    int32_t k = n;

    if (k > 127) {
        y *= 0x1p127F;
        k -= 127;
    } else if (k < -126) {
        /* The factor leaves 24 digits above the subnormal numbers, so that the rounding happens once. */
        y *= 0x1p-102F;
        k += 102;
    } else {
        /* One factor is enough. */
    }
    return y * lw_pow2f(k);
}
