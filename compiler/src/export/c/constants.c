/* The hash of the definition. */
static const uint64_t @m_fingerprint = @fingerprint;

@?parameters const @m_parameters_t @m_default_parameters = @defaults;

const @m_state_t @m_start = {
    @startq,
    @startv,
    @?internal @startz,
};

@?corrects /* Row and column of the entries of D. */
@?corrects static const int @m_jacobian_row[@njacobian] = @jacobianrows;
@?corrects static const int @m_jacobian_column[@njacobian] = @jacobiancolumns;
