/* (c, s) with cos d = 1 + z c and sin d = d + d z s, z = d * d up to @direct. */
static void @m_series(@real z, @real x[2])
{
    @?single x[0] = (z * ((z * (-@0.001388888888888889)) + @0.041666666666666664)) + (-@0.5);
    @?single x[1] = (z * @0.008333333333333333) + (-@0.16666666666666666);
    @!single const @real z2 = z * z;
    @!single const @real z4 = z2 * z2;
    @!single const @real s_low = (z * (@1 / @120)) + (-@1 / @6);
    @!single const @real s_mid = (z * (@1 / @362880)) + (-@1 / @5040);
    @!single const @real s_high = (z * (@1 / @6227020800)) + (-@1 / @39916800);
    @!single const @real s_last = -@1 / @1307674368000;
    @!single const @real c_low = (z * (@1 / @24)) + (-@0.5);
    @!single const @real c_mid = (z * (@1 / @40320)) + (-@1 / @720);
    @!single const @real c_high = (z * (@1 / @479001600)) + (-@1 / @3628800);
    @!single const @real c_last = -@1 / @87178291200;

    @!single x[0] = (z4 * ((z2 * c_last) + c_high)) + ((z2 * c_mid) + c_low);
    @!single x[1] = (z4 * ((z2 * s_last) + s_high)) + ((z2 * s_mid) + s_low);
}
