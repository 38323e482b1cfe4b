/* lw_from_bits: the double of these bits. */
static double lw_from_bits(uint64_t bits)
{
    double x;

    (void)memcpy(&x, &bits, sizeof(x));
    return x;
}
