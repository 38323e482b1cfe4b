/* lw_high_word: the upper 32 bits of a double: its sign, exponent and first 20 digits. */
static uint32_t lw_high_word(double x)
{
    return (uint32_t)(lw_bits(x) >> 32U);
}
