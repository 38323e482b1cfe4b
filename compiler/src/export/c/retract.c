/* Positions q moved by increments u of the velocities' kind (m, rad); orientations are normalised where the motion goes on from
   them, and angles whose turns are counted move by the integral of v. */
static void @m_retract(const @real q[@nq], const @real u[@nv], const @real integral[@nv], bool goes_on, @real to[@nq])
{
    @?linear int i;

    @?linear for (i = 0; i < @nlinear; i++) {
    @?linear     to[i] = q[i] + u[i];
    @?linear }
    @?rotations @m_turn_pairs(&q[@nlinear], &u[@nlinear], goes_on, &to[@nlinear]);
    @?quaternions @m_turn_quaternions(&q[@atquads], &u[@atomegas], goes_on, &to[@atquads]);
    @!turns (void)goes_on;
@wraps
    @!angles (void)integral;
}
