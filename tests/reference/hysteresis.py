"""Loads of a DEFINITION that resist a way by internal states: Masing's backbones and the law of Bouc and Wen.

A state is a deflection of a spring in a row with a slider. Those of a load are called by its name, in the order of its knots.
"""

import casadi as ca
import numpy as np

import bristles
from expressions import entry
from tables import in_si

KINDS = ("masing", "bouc_wen")


def name_the_way(load, definition):
    """Writes the coordinate of a joint or body where its name alone is given."""
    if load["kind"] not in KINDS or "name" not in load["expression"]:
        return
    text = load["expression"]["name"]
    if any(signal["name"] == text for signal in definition.get("signals", [])):
        return
    kinds = {joint["name"]: joint["kind"] for joint in definition["joints"]}
    if text in kinds or any(body["name"] == text for body in definition["bodies"]):
        travels = kinds.get(text) in ("prismatic", "point_on_line")
        load["expression"] = {"name": f"{text}.travel" if travels else f"{text}.angle"}


def backbone(load, definition):
    """Knots and values beyond the origin, and whether it goes on rising behind them."""
    name = load["backbone"]["value"]["name"]
    table = next(table for table in definition["tables"] if table["name"] == name)
    unit = table["arguments"][0]["unit"]
    points = [(in_si(x, unit), in_si(y, table["unit"])) for x, y in table["points"]]
    positive = np.array([point for point in points if point[0] > 0])
    return positive[:, 0], positive[:, 1], table["outside"] != "hold"


def elements(load, definition):
    """(knot, stiffness) of the elements that yield, and the stiffness that is left behind the last."""
    x, y, rises = backbone(load, definition)
    count = len(x)
    # Columns: what an element of stiffness one bears at each knot, min(x, knot); the last never yields.
    bears = np.minimum.outer(x, np.append(x[:-1], np.inf) if rises else x)
    bears = np.where(np.isinf(bears), x[:, None], bears)
    stiffness = np.linalg.solve(bears, y)
    lasting = stiffness[-1] if rises else 0.0
    taken = range(count - 1 if rises else count)
    return [(x[i], stiffness[i]) for i in taken if stiffness[i] > 1e-9 * y[0] / x[0]], lasting


def states(definition):
    """With the keys of declared ones; all begin at zero."""
    found = []
    for load in definition["loads"]:
        if load["kind"] == "bouc_wen":
            found.append(f"{load['name']}.deflection")
        elif load["kind"] == "masing":
            found += [f"{load['name']}.element[{i}]" for i in range(len(elements(load, definition)[0]))]
        elif load["kind"] in bristles.KINDS:
            found += bristles.states(load, definition)
    return [{"name": name, "unit": None, "value": {"number": "0"}} for name in found]


def law(load, model, x, v):
    """What it resists with, and the rates of its states, given the way and its rate."""
    own = [k for k, state in enumerate(model.states) if state["name"].startswith(load["name"] + ".")]
    z = [model.z[k] for k in own]
    if load["kind"] == "masing":
        yielding, lasting = elements(load, model.definition)
        force, rates = lasting * x, []
        for e, (knot, stiffness) in zip(z, yielding):
            force += stiffness * ca.if_else(e > knot, knot, ca.if_else(e < -knot, -knot, e))
            goes_on = ca.logic_or(ca.logic_and(e >= knot, v > 0), ca.logic_and(e <= -knot, v < 0))
            rates.append(ca.if_else(goes_on, 0, v))
        return force, rates
    given = {
        key: entry(load[key], model) if load.get(key) else ca.SX(0)
        for key in ("stiffness", "share", "depth", "beta", "gamma", "exponent")
    }
    n = float(given["exponent"])
    size = ca.fabs(z[0] / given["depth"])
    raised = size ** int(n) if n == int(n) else ca.exp(n * ca.log(size))
    bent = given["beta"] * ca.sign(v) * ca.sign(z[0]) + given["gamma"]
    k, share = given["stiffness"], given["share"]
    return share * k * x + (1 - share) * k * z[0], [v * (1 - bent * raised)]
