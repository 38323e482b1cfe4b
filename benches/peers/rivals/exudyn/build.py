"""Exudyn: simulations only, because its interface has no accelerations of a state; see `simulate.py`."""

from rivals.simulator import Simulator

NAME = "exudyn"
PEER = "Exudyn, generalised-α"


def simulator(surroundings, linkage):
    return Simulator(surroundings, linkage, NAME, PEER)
