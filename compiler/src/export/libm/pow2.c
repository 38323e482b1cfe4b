/* lw_pow2: 2^n for n from -1022 to 1023. */
static double lw_pow2(int32_t n)
{
    const int32_t exponent = n + 1023;

    return lw_from_bits((uint64_t)exponent << 52U);
}
