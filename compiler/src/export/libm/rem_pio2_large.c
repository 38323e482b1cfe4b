/* lw_rem_pio2_large: what remains of a large positive number after division by pi/2, in y[0] + y[1], and
 * the last three bits of the quotient. The number is the sum of x[i] * 2^(e0 - 24 * i) for i below nx <= 3,
 * where each x[i] is an integer below 2^24 and e0 is at least -3. The precision is 0, then y has one
 * element with 24 bits, or 1, then it has two with 53 bits. The product of 2/pi and the number is formed
 * without the digits that contribute a multiple of 8.
 *
 * The algorithm is from FreeBSD's msun (k_rem_pio2.c) by way of musl and the crate libm 0.2.16 of Rust.
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this software is freely granted,
 * provided that this notice is preserved.
 */
static uint32_t lw_rem_pio2_large(const double *x, int32_t nx, double *y, int32_t e0, uint32_t precision)
{
    /* 2/pi in pieces of 24 bits. */
    static const int32_t ipio2[66] = {
        0xA2F983, 0x6E4E44, 0x1529FC, 0x2757D1, 0xF534DD, 0xC0DB62, 0x95993C, 0x439041, 0xFE5163,
        0xABDEBB, 0xC561B7, 0x246E3A, 0x424DD2, 0xE00649, 0x2EEA09, 0xD1921C, 0xFE1DEB, 0x1CB129,
        0xA73EE8, 0x8235F5, 0x2EBB44, 0x84E99C, 0x7026B4, 0x5F7E41, 0x3991D6, 0x398353, 0x39F49C,
        0x845F8B, 0xBDF928, 0x3B1FF8, 0x97FFDE, 0x05980F, 0xEF2F11, 0x8B5A0A, 0x6D1F6D, 0x367ECF,
        0x27CB09, 0xB74F46, 0x3F669E, 0x5FEA2D, 0x7527BA, 0xC7EBE5, 0xF17B3D, 0x0739F7, 0x8A5292,
        0xEA6BFB, 0x5FB11F, 0x8D5D08, 0x560330, 0x46FC7B, 0x6BABF0, 0xCFBC20, 0x9AF436, 0x1DA9E3,
        0x91615E, 0xE61B08, 0x659985, 0x5F14A0, 0x68408D, 0xFFD880, 0x4D7327, 0x310606, 0x1556CA,
        0x73A8C9, 0x60E27B, 0xC08C6B
    };
    /* pi/2 in pieces of 24 bits. */
    static const double pio2[5] = {
        0x1.921fb4p0, /* 1.57079625129699707031e+00 */
        0x1.4442dp-24, /* 7.54978941586159635335e-08 */
        0x1.846988p-48, /* 5.39030252995776476554e-15 */
        0x1.8cc516p-72, /* 3.28200341580791294123e-22 */
        0x1.01b838p-96 /* 1.27065575308067607349e-29 */
    };
    const int32_t jk = 3 + (int32_t)precision; /* The last piece of 2/pi in the first attempt. */
    const int32_t jx = nx - 1;
    const int32_t jv = (e0 - 3) / 24; /* The first piece of 2/pi that matters. */
    int32_t q0 = e0 - (24 * (jv + 1)); /* The exponent of q[0], at most 2. */
    int32_t jz = jk; /* The last element of q[] and, later, of iq[]. */
    int32_t first = 0; /* The first element of q[] that is yet to compute. */
    double f[20] = { 0 }; /* 2/pi */
    double q[20] = { 0 }; /* The product in pieces of 24 bits and carries. */
    uint32_t iq[20] = { 0 }; /* The product in pieces of 24 bits, last piece first. */
    double fq[20] = { 0 }; /* The result before its summation. */
    double z;
    double fw;
    uint32_t n;
    uint32_t half; /* It is not 0 if the fraction is 1/2 or more, 2 if that is known from z. */
    uint32_t again;
    int32_t i;
    int32_t j;

    for (i = 0; i < jx; i++) {
        j = (jv - jx) + i;
        f[i] = (j < 0) ? 0.0 : (double)ipio2[j];
    }
    do {
        again = 0U;
        for (i = first; i <= jz; i++) {
            f[jx + i] = (double)ipio2[jv + i];
            fw = 0.0;
            for (j = 0; j <= jx; j++) {
                fw += x[j] * f[(jx + i) - j];
            }
            q[i] = fw;
        }

        /* Carries go from the last piece to the first. */
        z = q[jz];
        for (i = 0; i < jz; i++) {
            double rest;

            fw = 0x1p-24 * z;
            fw = (double)(uint32_t)fw;
            rest = z - (0x1p24 * fw);
            iq[i] = (uint32_t)rest;
            z = q[(jz - 1) - i] + fw;
        }

        /* The integer n and the fraction z of the quotient. */
        z = lw_scalbn(z, q0);
        z -= 8.0 * floor(z * 0.125);
        n = (uint32_t)z;
        z -= (double)n;
        half = 0U;
        if (q0 > 0) {
            const uint32_t fraction = 24U - (uint32_t)q0; /* The bits of the piece after the point. */
            const uint32_t integer = iq[jz - 1] >> fraction;

            n += integer;
            iq[jz - 1] -= integer << fraction;
            half = iq[jz - 1] >> (fraction - 1U);
        } else if (q0 == 0) {
            half = iq[jz - 1] >> 23U;
        } else if (z >= 0.5) {
            half = 2U;
        } else {
            /* The fraction is below 1/2. */
        }

        if (half != 0U) {
            /* The fraction q becomes 1 - q. */
            uint32_t borrow = 0U;

            n += 1U;
            for (i = 0; i < jz; i++) {
                if (borrow != 0U) {
                    iq[i] = 0xFFFFFFU - iq[i];
                } else if (iq[i] != 0U) {
                    borrow = 1U;
                    iq[i] = 0x1000000U - iq[i];
                } else {
                    /* Nothing is subtracted from it yet. */
                }
            }
            if (q0 == 1) {
                iq[jz - 1] &= 0x7FFFFFU;
            } else if (q0 == 2) {
                iq[jz - 1] &= 0x3FFFFFU;
            } else {
                /* The piece has no bit before the point. */
            }
            if (half == 2U) {
                z = 1.0 - z;
                if (borrow != 0U) {
                    z -= lw_scalbn(1.0, q0);
                }
            }
        }

        /* If nothing but zeros is left, then more digits are needed. Neither z nor a piece is negative. */
        if (z <= 0.0) {
            uint32_t digits = 0U;

            for (i = jz - 1; i >= jk; i--) {
                digits |= iq[i];
            }
            if (digits == 0U) {
                int32_t more = 1;

                while (iq[jk - more] == 0U) {
                    more++;
                }
                first = jz + 1;
                jz += more;
                again = 1U;
            }
        }
    } while (again != 0U);

    if (z <= 0.0) {
        /* Pieces of zero are dropped. */
        do {
            jz--;
            q0 -= 24;
        } while (iq[jz] == 0U);
    } else {
        /* The fraction z becomes one or two pieces. */
        z = lw_scalbn(z, -q0);
        if (z >= 0x1p24) {
            double rest;

            fw = 0x1p-24 * z;
            fw = (double)(uint32_t)fw;
            rest = z - (0x1p24 * fw);
            iq[jz] = (uint32_t)rest;
            jz++;
            q0 += 24;
            iq[jz] = (uint32_t)fw;
        } else {
            iq[jz] = (uint32_t)z;
        }
    }

    /* The fraction as floating-point numbers, and its product with pi/2. */
    fw = lw_scalbn(1.0, q0);
    for (i = jz; i >= 0; i--) {
        q[i] = fw * (double)iq[i];
        fw *= 0x1p-24;
    }
    for (i = jz; i >= 0; i--) {
        fw = 0.0;
        for (j = 0; (j <= jk) && (j <= (jz - i)); j++) {
            fw += pio2[j] * q[i + j];
        }
        fq[jz - i] = fw;
    }

    fw = 0.0;
    for (i = jz; i >= 0; i--) {
        fw += fq[i];
    }
    y[0] = (half == 0U) ? fw : -fw;
    if (precision != 0U) {
        fw = fq[0] - fw;
        for (i = 1; i <= jz; i++) {
            fw += fq[i];
        }
        y[1] = (half == 0U) ? fw : -fw;
    }
    return n & 7U;
}
