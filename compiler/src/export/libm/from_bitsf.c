/* lw_from_bitsf: the float of these bits. */
static float lw_from_bitsf(uint32_t bits)
{
    float x;

    (void)memcpy(&x, &bits, sizeof(x));
    return x;
}
