/* Whether numbers are neither infinite nor NaN: nothing else times zero is not zero. */
static bool @m_finite(const @real x[], int count)
{
    @real sum = @0;
    int i;

    for (i = 0; i < count; i++) {
        sum = (x[i] * @0) + sum;
    }
    return sum <= @0;
}

/* Whether two numbers are equal. */
static bool @m_same(@real a, @real b)
{
    return (a <= b) && (a >= b);
}

@?inputs /* Whether inputs are neither infinite nor NaN. */
@?inputs static bool @m_finite_inputs(const @m_inputs_t *u)
@?inputs {
    @?inputs return @finiteinputs;
@?inputs }
@?inputs
