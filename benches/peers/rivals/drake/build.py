"""Drake: simulations of trees, because a continuous plant takes no closed loops; see `simulate.py`."""

from rivals.simulator import Simulator
from surroundings import Absent

NAME = "drake"
PEER = "Drake, RK3"


def simulator(surroundings, linkage):
    if linkage.loops:
        raise Absent("a continuous plant takes no closed loops (its discrete solver holds them softly)")
    if any(linkage.torques) or linkage.springs:
        raise Absent("springs and torques are not written for it here")
    return Simulator(surroundings, linkage, NAME, PEER)
