/* lw_bitsf: the bits of a float. */
static uint32_t lw_bitsf(float x)
{
    uint32_t bits;

    (void)memcpy(&bits, &x, sizeof(bits));
    return bits;
}
