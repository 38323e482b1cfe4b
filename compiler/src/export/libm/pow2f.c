/* lw_pow2f: 2^n for n from -126 to 127. */
static float lw_pow2f(int32_t n)
{
    const int32_t exponent = n + 127;

    return lw_from_bitsf((uint32_t)exponent << 23U);
}
