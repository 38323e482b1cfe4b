/* lw_is_nan: 1 for a NaN, otherwise 0. */
static uint32_t lw_is_nan(double x)
{
    return ((lw_bits(x) & 0x7FFFFFFFFFFFFFFFU) > 0x7FF0000000000000U) ? 1U : 0U;
}
