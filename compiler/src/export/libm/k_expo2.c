/* lw_k_expo2: e^x / 2 for x from log(DBL_MAX), where e^x itself is infinite.
 *
 * The algorithm is from musl (src/math/__expo2.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static double lw_k_expo2(double x)
{
    const double k_ln2 = 0x1.62066151add8bp10; /* 2043 ln2 */
    const double scale = 0x1p1021;

    /* The square of the scale would be infinite. */
    return lw_exp(x - k_ln2) * scale * scale;
}
