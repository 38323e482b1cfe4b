@?phased /* Takes the phases of couplings that state none from an assembled position. */
@?phased static void @m_fix_phases(@m_model_t *model, const @real q[@nq])
@?phased {
    @?phased static const int rows[@nopen] = @openrows;
    @?phased @real phi[@nr];
    @?phased int i;
    @?phased
    @?phased @m_constraints(model, @0, q, phi);
    @?phased for (i = 0; i < @nopen; i++) {
    @?phased     model->phases[i] = model->phases[i] + phi[rows[i]];
    @?phased }
    @?phased @?constants @m_prepare(@preparearguments);
@?phased }
@?phased
/* The model with these parameters; the number of what is wrong with them, -1 where nothing is. */
static int @m_model_of(@m_model_t *model@parametersparameter)
{
    @?phases static const @real phases[@nphases] = @phases;
    @?phases int i;
@checks

    @?parameters model->parameters = *parameters;
    @?phases for (i = 0; i < @nphases; i++) {
    @?phases     model->phases[i] = phases[i];
    @?phases }
    @?constants @m_prepare(@preparearguments);
    @!some model->empty = 0U;
@masses
    @?constants if (!@m_finite(model->constants, @nconstants)) {
    @?constants     return @nwrong;
    @?constants }
    return -1;
}

@?parameters const char *@m_wrong_parameter(const @m_parameters_t *parameters)
@?parameters {
    @?parameters static const char *const names[] = @wrong;
    @?parameters @m_model_t model;
    @?parameters int number;
    @?parameters
    @?parameters if (parameters == NULL) {
    @?parameters     return NULL;
    @?parameters }
    @?parameters number = @m_model_of(&model, parameters);
    @?parameters return (number < 0) ? NULL : names[number];
@?parameters }
@?parameters
