/* The end of the program that `tests/libm.rs` builds. Before it come the includes, lw_sin and all others, and
 * thresholds_of_double[], thresholds_of_float[] and functions[]. It prints, for every function and class of
 * arguments, a hash of the results. `tests/libm.rs` forms the same arguments in the same way. */

static uint64_t state;

/* xorshift64* */
static uint64_t next(void)
{
    state ^= state >> 12U;
    state ^= state << 25U;
    state ^= state >> 27U;
    return state * 0x2545F4914F6CDD1DU;
}

static uint64_t bits_of(uint32_t single, double x)
{
    return (single != 0U) ? (uint64_t)lw_bitsf((float)x) : lw_bits(x);
}

/* A number from -size to size. */
static double uniform(uint64_t random, double size)
{
    return (((double)(random >> 11U) * 0x1p-52) - 1.0) * size;
}

/* The bits of an argument. */
static uint64_t argument(uint32_t class, uint32_t single)
{
    const uint32_t width = (single != 0U) ? 32U : 64U;
    const uint32_t digits = (single != 0U) ? 23U : 52U;
    const uint64_t bias = (single != 0U) ? 127U : 1023U;
    const uint64_t infinity = ((2U * bias) + 1U) << digits;
    const uint64_t one = bias << digits;
    const uint64_t fraction = ((uint64_t)1U << digits) - 1U;
    const uint64_t r = next();
    const uint64_t s = next();
    const uint64_t sign = (s >> 63U) << (width - 1U);
    const uint64_t few = ((r >> 32U) % 7U) - 3U;
    uint64_t bits;

    switch (class) {
    case 0U:
        bits = r >> (64U - width);
        break;
    case 1U:
        bits = bits_of(single, uniform(r, 10.0));
        break;
    case 2U:
        bits = bits_of(single, uniform(r, 1.0));
        break;
    case 3U:
        bits = bits_of(single, uniform(r, (single != 0U) ? 110.0 : 760.0));
        break;
    case 4U: {
        const double multiple = (double)((s >> 2U) >> (r % 61U));

        bits = (bits_of(single, multiple * 0x1.921fb54442d18p0) + few) & (infinity | fraction);
        bits |= sign;
        break;
    }
    case 5U: {
        uint64_t offset = few;

        if (single != 0U) {
            bits = thresholds_of_float[r % COUNT(thresholds_of_float)];
        } else {
            bits = thresholds_of_double[r % COUNT(thresholds_of_double)] + (((r >> 40U) & 1U) << 32U);
            if (((r >> 41U) & 1U) != 0U) {
                offset = ((s >> 1U) & 0xFFFFFFFFU) - 0x80000000U;
            }
        }
        bits = ((bits + offset) & (infinity | fraction)) | sign;
        break;
    }
    case 6U: {
        const uint64_t offset = (s & fraction) >> (r % digits);

        bits = ((((r >> 40U) & 1U) != 0U) ? (one + offset) : (one - offset)) | sign;
        break;
    }
    case 7U:
        bits = ((r % (bias - 19U)) << digits) | (s & fraction) | sign;
        break;
    case 8U: {
        const uint64_t span = (((r >> 40U) & 1U) != 0U) ? 28U : (bias - 20U);

        bits = (((2U * bias) - (r % span)) << digits) | (s & fraction) | sign;
        break;
    }
    default: {
        const uint64_t special[8] = { 0U, 1U, fraction, fraction + 1U, one, infinity - 1U, infinity, infinity + 1U };

        bits = special[r % 8U] | sign;
        break;
    }
    }
    return bits;
}

/* FNV-1a, to which all NaNs are the same. */
static uint64_t hashed(uint64_t hash, uint64_t bits, uint32_t single)
{
    const uint64_t infinity = (single != 0U) ? 0x7F800000U : 0x7FF0000000000000U;
    const uint64_t size = bits & ((single != 0U) ? 0x7FFFFFFFU : 0x7FFFFFFFFFFFFFFFU);
    uint64_t rest = (size > infinity) ? UINT64_MAX : bits;
    uint64_t result = hash;
    uint32_t i;

    for (i = 0U; i < 8U; i++) {
        result = (result ^ (rest & 0xFFU)) * 0x100000001B3U;
        rest >>= 8U;
    }
    return result;
}

/* Of a pair, half have exponents that are less than 70 apart. */
static uint64_t other(uint64_t first, uint32_t class, uint32_t single)
{
    const uint32_t digits = (single != 0U) ? 23U : 52U;
    const uint64_t exponent = (single != 0U) ? 0x7F800000U : 0x7FF0000000000000U;
    const uint64_t bits = argument(class, single);
    const uint64_t r = next();

    if ((r >> 63U) == 0U) {
        return bits;
    }
    return (bits & ~exponent) | ((first + (((r % 140U) - 70U) << digits)) & exponent);
}

static uint64_t result(const struct function *function, uint32_t class)
{
    const uint32_t single = ((function->one_f != NULL) || (function->two_f != NULL)) ? 1U : 0U;
    const uint64_t bits = argument(class, single);
    uint64_t value;

    if (function->one != NULL) {
        value = lw_bits(function->one(lw_from_bits(bits)));
    } else if (function->one_f != NULL) {
        value = lw_bitsf(function->one_f(lw_from_bitsf((uint32_t)bits)));
    } else if (function->two != NULL) {
        value = lw_bits(function->two(lw_from_bits(bits), lw_from_bits(other(bits, class, single))));
    } else {
        const uint32_t second = (uint32_t)other(bits, class, single);

        value = lw_bitsf(function->two_f(lw_from_bitsf((uint32_t)bits), lw_from_bitsf(second)));
    }
    return hashed(0xCBF29CE484222325U, value, single);
}

int main(void)
{
    uint32_t i;
    uint32_t class;
    uint32_t k;

    for (i = 0U; i < (uint32_t)COUNT(functions); i++) {
        for (class = 0U; class < CLASSES; class++) {
            uint64_t hash = 0U;

            state = 0x9E3779B97F4A7C15U * ((16U * (uint64_t)i) + class + 1U);
            for (k = 0U; k < ARGUMENTS; k++) {
                hash = (hash * 31U) + result(&functions[i], class);
            }
            (void)printf("%s %u %016" PRIx64 "\n", functions[i].name, (unsigned int)class, hash);
        }
    }
    return 0;
}
