"""Memories, which are constant between events, and the events that set them.

All that is held stands in one vector: gates of contacts, then events that pass a level, those with a period, memories. The guard of the first of these
is level − value, with 1 in the place of a force; what else is held has none. At the places of events with a speed that jumps stands, in what comes after
them, what it jumps to, and the speed itself stands where the rates of gaps stand.
"""

import casadi as ca

from expressions import evaluate

WAYS = ("rises", "falls", "crosses")


def in_places(definition):
    """Events in the order of their places."""
    return sorted(definition.get("events", []), key=lambda event: "every" in event)


def guards(model, scope):
    """Gaps and forces of events and memories."""
    passing = [event for event in model.events if "every" not in event]
    gaps = [evaluate(event[way], scope) - evaluate(event["value"], scope) for event in passing for way in WAYS if way in event]
    rest = len(model.events) - len(passing) + len(model.memories)
    zeros = [ca.SX(0)] * rest
    return ca.vertcat(*gaps, *zeros), ca.vertcat(*[ca.SX(1)] * len(passing), *zeros)


def assignments(model, scope):
    """All that is held after the events whose places are 1."""
    after = ca.vertsplit(model.gates)
    first = len(after) - len(model.memories) - len(model.events)
    occurs = {event["name"]: model.gates[first + k] > 0.5 for k, event in enumerate(model.events)}
    places = {memory["name"]: first + len(model.events) + k for k, memory in enumerate(model.memories)}
    for event in model.definition.get("events", []):
        for told in event["sets"]:
            at = places[told["name"]]
            after[at] = ca.if_else(occurs[event["name"]], evaluate(told["value"], scope), after[at])
        if "jump" in event:
            after[first + model.events.index(event)] = evaluate(event["jump"]["value"], scope)
    return ca.vertcat(*after)


def jumping(model, scope):
    """Of all that is held the speed that jumps, else 0; and whether one does. Nothing where none does."""
    if not any("jump" in event for event in model.events):
        return ca.SX(0, 1), ca.SX(0, 1)
    first = model.gates.numel() - len(model.memories) - len(model.events)
    speeds, jumps = [ca.SX(0)] * model.gates.numel(), [ca.SX(0)] * model.gates.numel()
    for k, event in enumerate(model.events):
        if "jump" in event:
            speeds[first + k], jumps[first + k] = evaluate(event["jump"]["speed"], scope), ca.SX(1)
    return ca.vertcat(*speeds), ca.vertcat(*jumps)
