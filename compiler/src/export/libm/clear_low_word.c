/* lw_clear_low_word: a double with the lower 32 bits cleared. */
static double lw_clear_low_word(double x)
{
    return lw_from_bits(lw_bits(x) & 0xFFFFFFFF00000000U);
}
