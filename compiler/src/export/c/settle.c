/* The largest magnitude. */
static @real @m_most(const @real x[], int count)
{
    @real most = @0;
    int i;

    for (i = 0; i < count; i++) {
        most = (most > @fabs(x[i])) ? most : @fabs(x[i]);
    }
    return most;
}

/* A hundred roundings of the largest entry of D M^-1 D^T (1/kg): nothing at regular positions, and at singular ones what leaves the
   direction without a constraint alone. */
static @real @m_compliance(const @m_model_t *model)
{
    @real scales[@nr];

    @m_row_scales(model, scales);
    return @m_most(scales, @nr) * @rounding;
}

/* One step of Newton's iteration towards the constraints, of positions and velocities, on the shortest way in the norm of the mass
   matrix, with one factorisation; gives how far it moved a coordinate at most (m, rad). */
static @real @m_settle(const @m_model_t *model, @real time, @m_state_t *state)
{
    @real store[@nstore];
    @real phi[@nr];
    @real rest[@nr];
    @real jacobian[@njacobian];
    @real zero[@nv];
    @real delta[@nv];
    @real change[@nv];
    @real lambda[@nr];
    @real q[@nq];
    int i;

    (void)@m_factor(model, time, state->q, @m_compliance(model), store);
    @m_constraints(model, time, state->q, phi);
    @m_nu(model, time, state->q, rest);
    @m_constraint_jacobian(model, time, state->q, jacobian);
    for (i = 0; i < @njacobian; i++) {
        rest[@m_jacobian_row[i]] -= jacobian[i] * state->v[@m_jacobian_column[i]];
    }
    for (i = 0; i < @nr; i++) {
        phi[i] = -phi[i];
    }
    for (i = 0; i < @nv; i++) {
        zero[i] = @0;
    }
    @m_solve(model, store, zero, phi, delta, lambda);
    @m_solve(model, store, zero, rest, change, lambda);
    for (i = 0; i < @nq; i++) {
        q[i] = state->q[i];
    }
    @m_retract(q, delta, delta, true, state->q);
    for (i = 0; i < @nv; i++) {
        state->v[i] = change[i] + state->v[i];
    }
    return @m_most(delta, @nv);
}
