/* lw_bits: the bits of a double. */
static uint64_t lw_bits(double x)
{
    uint64_t bits;

    (void)memcpy(&bits, &x, sizeof(bits));
    return bits;
}
