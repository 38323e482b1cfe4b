/* lw_k_expo2f: e^x / 2 for x from log(FLT_MAX), where e^x itself is infinite.
 *
 * The algorithm is from musl (src/math/__expo2f.c) and the crate libm 0.2.16 of Rust.
 * Copyright (C) 2005-2020 Rich Felker, et al.
 * It may be used under the MIT licence.
 */
static float lw_k_expo2f(float x)
{
    const float k_ln2 = 0x1.45c778p7F; /* 235 ln2 */
    const float scale = 0x1p117F;

    /* The square of the scale would be infinite. */
    return lw_expf(x - k_ln2) * scale * scale;
}
