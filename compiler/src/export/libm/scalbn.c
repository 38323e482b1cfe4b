/* lw_scalbn: x * 2^n for n from -1991 to 2046, rounded once.
 *
 * The algorithm is from musl (src/math/scalbn.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static double lw_scalbn(double x, int32_t n)
{
    double y = x;
    int32_t k = n;

    if (k > 1023) {
        y *= 0x1p1023;
        k -= 1023;
    } else if (k < -1022) {
        /* The factor leaves 53 digits above the subnormal numbers, so that the rounding happens once. */
        y *= 0x1p-969;
        k += 969;
    } else {
        /* One factor is enough. */
    }
    return y * lw_pow2(k);
}
