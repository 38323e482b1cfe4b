"""Loads of a DEFINITION that pull along a way from place to place, and never push."""

import casadi as ca

from expressions import entry


def length(load, kinematics):
    """From the first place by the second to the last."""
    places = [load["first"], load["second"], *load.get("further", [])]
    return sum((kinematics.distance(a, b) for a, b in zip(places, places[1:])), ca.SX(0))


def own_length(load, kinematics):
    return entry(load["length"], kinematics)


def tension(load, kinematics):
    def given(key):
        return entry(load[key], kinematics) if load.get(key) else ca.SX(0)

    run, own = length(load, kinematics), own_length(load, kinematics)
    rate = entry(load["pay_out"], kinematics) if load.get("pay_out") else kinematics.rate(own)
    stretch, width = run - own, given("smooth")
    if load.get("smooth"):
        inside = (stretch + width / 2) ** 2 / (2 * width)
        beyond = ca.if_else(stretch > width / 2, stretch, ca.if_else(stretch < -width / 2, 0, inside))
        taut = ca.if_else(stretch > width / 2, 1, ca.if_else(stretch < -width / 2, 0, stretch / width + 0.5))
    else:
        beyond = ca.if_else(stretch > 0, stretch, 0)
        taut = ca.if_else(stretch > 0, 1, 0)
    pull = given("stiffness") * beyond / own
    if not load.get("damping"):
        return pull
    pull += given("damping") * taut * (kinematics.rate(run) - rate)
    return ca.if_else(pull > 0, pull, 0)
