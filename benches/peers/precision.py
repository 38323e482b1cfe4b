"""Work and precision: wall time of a simulated second beside the error at its end, for steps that are halved again and again.

The reference is Linkwright's own motion with steps four times shorter than the shortest; an exact peer that is not Linkwright, with
the same steps, says how far it can be trusted. Errors are of angles, rad, at the end: the largest.
"""

import json
from dataclasses import dataclass

import numpy as np
from surroundings import Absent, run


@dataclass
class Task:
    """Seconds from the start, most steps, how often they are halved, and how long a peer may take for one run."""

    end: float
    steps: int
    halvings: int


# Ladders stop before all rods are in one line, where each peer is at the mercy of where its steps fall.
TASKS = {
    "double_pendulum": Task(2.0, 12800, 9),
    "four_bar": Task(0.5, 3200, 8),
    "n_four_bar_10": Task(0.5, 3200, 8),
    "n_four_bar_40": Task(0.5, 3200, 8),
    "andrews": Task(0.03, 12800, 8),
    "panda": Task(0.5, 3200, 8),
    "bricard": Task(2.0, 6400, 8),
}
LEVELS = (1e-4, 1e-6, 1e-8)
LONGEST = 4.0  # s of one run
TRUSTED = 1e-9


def turned(difference):
    """The largest of differences of angles, whatever turns are between them."""
    difference = np.asarray(difference)
    return float(np.abs(np.arctan2(np.sin(difference), np.cos(difference))).max())


class Precision:
    def __init__(self, comparison, mechanism, model, own, angles):
        self.comparison, self.mechanism, self.model, self.own, self.angles = comparison, mechanism, model, own, angles
        self.task = TASKS[mechanism]
        self.folder = comparison.surroundings.folder("simulated", mechanism)
        rows, _, motions = model.states(1)
        self.start_row, self.start_motions = rows, motions

    def simulate(self, entry, steps, times):
        """Seconds, and positions at the end; None where it failed."""
        if entry.states is None:
            row = self.start_row
        else:
            q, v, _ = entry.states(self.start_motions)
            row = np.concatenate([q, v], axis=1)
        given, answer = self.folder / "start", self.folder / "end"
        np.ascontiguousarray(row).tofile(given)
        harness = self.comparison.harness
        run([harness, "simulate", "peer", entry.library, entry.model, given, repr(self.task.end / steps), steps, times, answer])
        seconds, done, *end = np.fromfile(answer)
        if done != steps or not np.isfinite(end).all():
            return None
        return seconds, np.array(end)

    def reference(self, others):
        """The motion of the bodies at the end, and how far an independent peer is from it."""
        steps = 4 * self.task.steps
        found = self.simulate(self.own, steps, 1)
        if found is None:
            raise Absent("Linkwright's own motion does not reach the end")
        motions = self.model.bodies(found[1])
        best = (None, None)
        for entry in others:
            # Those that are exact, and not too slow for so many steps.
            probe = None if entry.middle or "handed" in entry.peer else self.simulate(entry, 16, 1)
            if probe is None or probe[0] * steps / 16 > 4 * LONGEST:
                continue
            other = self.simulate(entry, steps, 1)
            error = None if other is None else self.error(entry, other[1], motions)
            if error is not None and (best[1] is None or error < best[1]):
                best = entry.peer, error
            if best[1] is not None and best[1] < TRUSTED:
                break
        return motions, *best

    def error(self, entry, row, motions):
        if entry.states is None:
            return turned(self.angles(self.model.bodies(row))[0] - self.angles(motions)[0])
        q = entry.states(motions)[0]
        return turned(row[: q.shape[1]] - q[0])

    def curve(self, entry, motions):
        """(steps, seconds of a simulated second, error), longest steps first."""
        points, steps = [], self.task.steps >> self.task.halvings
        quick = self.comparison.settings.quick
        while steps <= self.task.steps:
            once = self.simulate(entry, steps, 1)
            if once is not None:
                if once[0] < 0.2:
                    once = self.simulate(entry, steps, 3 if quick else min(60, max(3, int(0.25 / max(once[0], 1e-5)))))
                points.append([steps, once[0] / self.task.end, self.error(entry, once[1], motions)])
                if 2 * once[0] > LONGEST:
                    break
            steps *= 2
        return points

    def of_all(self, entries, simulators, absent):
        """Curves by peer."""
        motions, trusted_by, trust = self.reference(entries[1:])
        result = {"end": self.task.end, "reference": {"peer": trusted_by, "agrees_to": trust}, "curves": {}}
        for entry in entries:
            if "handed" not in entry.peer:
                result["curves"][entry.peer] = self.curve(entry, motions)
        for simulator in simulators:
            try:
                result["curves"][simulator.peer] = self.of_simulator(simulator, motions)
            except Absent as reason:
                absent(simulator.peer, str(reason), self.mechanism)
        for curve in result["curves"].values():
            if trust is not None:
                curve[:] = [point for point in curve if point[2] > 4 * trust or point[2] > TRUSTED]
        result["at"] = {peer: [at_error(curve, level) for level in LEVELS] for peer, curve in result["curves"].items()}
        return result

    def of_simulator(self, simulator, motions):
        """A peer that lives in Python: it is told the start and the steps, and times itself."""
        q, v, _ = self.angles(self.start_motions)
        steps = [self.task.steps >> k for k in range(self.task.halvings, -1, -1)]
        told = {"q": q[0].tolist(), "v": v[0].tolist(), "end": self.task.end, "steps": steps, "longest": LONGEST}
        file = self.folder / "told.json"
        file.write_text(json.dumps(told))
        said = json.loads(simulator.run(file).splitlines()[-1])
        reference = self.angles(motions)[0][0]
        return [[count, seconds / self.task.end, turned(np.array(end) - reference)] for count, seconds, end in said]


def at_error(curve, level):
    """Seconds of a simulated second at this error, between the two nearest points by their logarithms; None outside."""
    points = [(error, seconds) for _, seconds, error in curve if error > 0]
    best = None
    for (e0, s0), (e1, s1) in zip(points, points[1:]):
        if e0 >= level >= e1 and e0 > e1:
            part = np.log(e0 / level) / np.log(e0 / e1)
            found = float(np.exp(np.log(s0) + part * np.log(s1 / s0)))
            best = found if best is None else min(best, found)
    if best is None and points and points[0][0] < level:
        return points[0][1]
    return best
