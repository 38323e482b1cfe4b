"""The course of the comparison, in the environment that reads definitions: `run.py` starts it.

For each mechanism: its DEFINITION from Linkwright, every peer's model from that, accelerations at random consistent states compared,
and only then what agrees is timed. What is absent, cannot be expressed or disagrees is kept with its reason.
"""

import importlib
import os

import costs
import linkage
import numpy as np
import own
from precision import Precision
from surroundings import HERE, ROOT, Absent, Entry, Surroundings, machine, run

MECHANISMS = {
    "double_pendulum": "double pendulum",
    "four_bar": "four-bar",
    "n_four_bar_10": "ladder of ten",
    "n_four_bar_40": "ladder of forty",
    "andrews": "Andrews' squeezer",
    "panda": "Panda arm",
    "bricard": "Bricard",
}
# Compiled peers that share a process; each has `rivals/NAME/build.py`.
RIVALS = ("casadi", "mujoco", "pinocchio", "sympy", "symforce", "simbody")
# Those that are libraries of the distribution or crates, and have no environment.
OF_THE_SYSTEM = ("simbody",)
# Peers that simulate in a Python of their own.
SIMULATORS = ("exudyn", "drake", "rapier")
# Peers whose batches run in a Python of their own.
BATCHES = ("mjx",)
LINKWRIGHT = "Linkwright"
STATES = 64


class Comparison:
    """What is known so far; `results` is what is written."""

    def __init__(self, settings):
        self.settings = settings
        self.target = settings.target
        self.surroundings = Surroundings(self.target)
        self.results = {"machine": machine(), "mechanisms": {}, "absent": [], "settings": settings.named()}

    def say(self, text):
        print(text, flush=True)

    def absent(self, peer, reason, mechanism=None):
        where = f" ({MECHANISMS[mechanism]})" if mechanism else ""
        # Tables are for readers elsewhere.
        reason = reason.replace(f"{self.target}/", "").replace(f"{ROOT}/", "")
        self.say(f"  absent: {peer}{where}: {reason}")
        self.results["absent"].append({"peer": peer, "mechanism": mechanism, "reason": reason})

    def course(self):
        self.say("Linkwright's shared library")
        self.library = own.build(self.target / "linkwright")
        self.harness = self.surroundings.folder("built") / "harness"
        self.surroundings.compile("gcc", ["-O2", "-Wall", HERE / "harness" / "harness.c", "-ldl"], self.harness)
        rivals = self.rivals()
        for name in self.settings.mechanisms:
            self.mechanism(name, rivals)
        self.results["machine"]["load_at_end"] = list(os.getloadavg())
        self.results["versions"] = versions(self.settings.only)
        self.results["commit"] = commit()
        return self.results

    def rivals(self):
        """The rivals whose environments are there, by name."""
        found = {}
        for name in self.settings.only or RIVALS:
            if name not in RIVALS:
                continue
            try:
                if name not in OF_THE_SYSTEM:
                    self.surroundings.python(name)
                found[name] = importlib.import_module(f"rivals.{name}.build")
            except Absent as absent:
                self.absent(name, str(absent))
            except ImportError as error:
                self.absent(name, f"its builder cannot be imported: {error}")
        return found

    def mechanism(self, name, rivals):
        self.say(f"\n{MECHANISMS[name]}")
        model = own.Own(self.library, name)
        here = {"title": MECHANISMS[name], "peers": {}, "refused": []}
        self.results["mechanisms"][name] = here
        described = linkage.read(name, model.definition())
        entries = [own_entry(self.library, model)]
        try:
            entries[0].build, entries[0].code = costs.cost(self.surroundings, model)
            entries[0].note = "build with its generation"
        except Absent as absent:
            self.absent("costs of Linkwright's code", str(absent), name)
        for rival, builder in rivals.items():
            try:
                entries += builder.prepare(self.surroundings, described, model.source())
            except (Absent, linkage.CannotBeExpressed) as reason:
                self.absent(rival, str(reason), name)
        checks = self.states(model, 64, seed=1)
        agreed = [entry for entry in entries if self.agrees(name, entry, checks, here)]
        try:
            self.interleaved(name, model, agreed, here)
        except Absent as absent:
            self.absent("times of all peers", str(absent), name)
        self.simulated(name, model, agreed, described, here)
        self.batches(name, agreed, here)
        self.apart(name, described, here)

    def simulated(self, mechanism, model, entries, described, here):
        """Wall time beside error."""
        self.say("  simulating")
        angles = lambda numbers: linkage.joint_angles(described, numbers)  # noqa: E731
        try:
            precision = Precision(self, mechanism, model, entries[0], angles)
            here["precision"] = precision.of_all(entries, self.simulators(mechanism, described), self.absent)
        except Absent as absent:
            self.absent("work and precision", str(absent), mechanism)

    def simulators(self, mechanism, described):
        """Peers that live in Python's process, by simulations only."""
        found = []
        for name in SIMULATORS:
            if self.settings.only and name not in self.settings.only:
                continue
            try:
                found.append(importlib.import_module(f"rivals.{name}.build").simulator(self.surroundings, described))
            except Absent as absent:
                self.absent(name, str(absent), mechanism)
        return found

    def batches(self, mechanism, entries, here):
        """Steps of RK4 of many members on all threads, for those that have batches."""
        here["batches"] = {}
        threads = os.cpu_count()
        for entry in entries:
            if entry.peer not in (LINKWRIGHT, "MuJoCo"):
                continue
            step = here["peers"][entry.peer].get("step", {}).get("ns", 1e5)
            members = 4096 if entry.peer == LINKWRIGHT else 256
            steps = max(10, int(0.3e9 / (step * members)))
            answer = self.file(mechanism, entry, "batch")
            given = self.file(mechanism, entry, "along")
            command = [self.harness, "batch", "peer", entry.library, entry.model, given, members, threads, 1e-6, steps]
            try:
                run([*command, 3 if self.settings.quick else 10, answer])
                seconds = float(np.fromfile(answer)[0])
                rate = members * steps / seconds
                here["batches"][entry.peer] = {"members": members, "steps": steps, "rate": rate, "threads": threads}
            except Absent as absent:
                self.absent(f"{entry.peer}, batches", str(absent), mechanism)

    def apart(self, mechanism, described, here):
        """Batches of peers that run in a Python of their own."""
        for name in BATCHES:
            if self.settings.only and name not in self.settings.only:
                continue
            builder = importlib.import_module(f"rivals.{name}.build")
            try:
                here["batches"][builder.PEER] = builder.batch(self.surroundings, described)
            except Absent as absent:
                self.absent(builder.PEER, str(absent), mechanism)

    def states(self, model, count, seed):
        rows, accelerations, motions = model.states(count, seed)
        return {"rows": rows, "accelerations": accelerations, "motions": motions}

    def file(self, mechanism, entry, what):
        label = "".join(c if c.isalnum() else "_" for c in entry.peer)
        return self.surroundings.folder("states", mechanism) / f"{label}.{what}"

    def write_states(self, mechanism, entry, states, what):
        """A file of states in the peer's coordinates, and what the accelerations must be."""
        q, v, a = (states["rows"], None, states["accelerations"]) if entry.states is None else entry.states(states["motions"])
        rows = q if v is None else np.concatenate([q, v], axis=1)
        path = self.file(mechanism, entry, what)
        np.ascontiguousarray(rows, dtype=np.float64).tofile(path)
        return path, a

    def agrees(self, mechanism, entry, states, here):
        """Whether accelerations agree at all states; what is refused is named."""
        try:
            given, expected = self.write_states(mechanism, entry, states, "random")
            answer = self.file(mechanism, entry, "accelerations")
            run([self.harness, "check", "peer", entry.library, entry.model, given, answer])
            middle, worst = disagreement(np.fromfile(answer).reshape(expected.shape), expected)
        except Absent as absent:
            self.absent(entry.peer, str(absent), mechanism)
            return False
        here["peers"][entry.peer] = {
            "agrees_to": worst, "middle_agrees_to": middle, "tolerance": entry.tolerance, "note": entry.note,
            "generation": entry.generation, "build": entry.build, "code": entry.code,
        }  # fmt: skip
        error = middle if entry.middle else worst
        if error <= entry.tolerance and worst < float("inf"):
            self.say(f"  {entry.peer}: agrees to {worst:.1e}, in the middle {middle:.1e}")
            return True
        self.say(f"  {entry.peer}: REFUSED, accelerations differ by {error:.1e} of the largest (allowed {entry.tolerance:.0e})")
        here["refused"].append({"peer": entry.peer, "error": error, "tolerance": entry.tolerance})
        return False

    def interleaved(self, mechanism, model, entries, here):
        states = self.states(model, STATES, seed=0)
        arguments = []
        for number, entry in enumerate(entries):
            given, _ = self.write_states(mechanism, entry, states, "along")
            arguments += [str(number), entry.library, entry.model, given]
        out = self.surroundings.folder("samples") / f"{mechanism}.txt"
        self.say(f"  timing {len(entries)} peers for {self.settings.seconds:g} s")
        run([self.harness, "time", self.settings.seconds, out, *arguments])
        samples = {}
        for line in out.read_text().splitlines():
            peer, kind, *values = line.split()
            samples[peer, kind] = np.array([float(value) for value in values])
        here["clock"] = quantiles(samples["-", "clock"])
        here["slices"] = len(samples["-", "clock"])
        for number, entry in enumerate(entries):
            found = here["peers"][entry.peer]
            for kind in ("evaluation", "chain", "step"):
                ns = samples.get((str(number), kind))
                if ns is not None:
                    ratio = float(np.nanmedian(ns / samples["0", kind]))
                    slices = int(np.isfinite(ns).sum())
                    found[kind] = {"ns": float(np.nanmin(ns)), "median": float(np.nanmedian(ns)), "ratio": ratio, "slices": slices}


def versions(only):
    """What is pinned, and what the distribution has."""
    found = {}
    for path in sorted((HERE / "requirements").glob("*.txt")):
        if not only or path.stem in only:
            found[path.stem] = ", ".join(path.read_text().split())
    if not only or "rapier" in only:
        manifest = (HERE / "rivals" / "rapier" / "Cargo.toml").read_text()
        found["rapier"] = next(line for line in manifest.splitlines() if line.startswith("rapier2d"))
    if not only or "simbody" in only:
        try:
            found["simbody"] = run(["dpkg-query", "-W", "-f", "${Version}", "libsimbody-dev"])
        except Absent:
            found["simbody"] = "unknown"
    return found


def commit():
    try:
        return run(["git", "-C", HERE, "describe", "--always", "--dirty"]).strip()
    except Absent:
        return "unknown"


def quantiles(values):
    return {"least": float(values.min()), "median": float(np.median(values)), "most": float(values.max())}


def disagreement(found, expected):
    """The largest difference of a state's accelerations, relative to the largest of them: of the middle and of the worst state."""
    scale = np.abs(expected).max(axis=1)
    with np.errstate(invalid="ignore"):
        errors = np.abs(found - expected).max(axis=1) / scale
    if np.isnan(errors).any():
        return float("inf"), float("inf")
    return float(np.median(errors)), float(errors.max())


def own_entry(library, model):
    return Entry(LINKWRIGHT, library, model.name, None, 1e-15)
