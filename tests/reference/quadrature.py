"""Nodes and weights of Gauss and Legendre on −1 to 1, found once for each number of them."""

from functools import cache

from numpy.polynomial.legendre import leggauss

gauss = cache(leggauss)
