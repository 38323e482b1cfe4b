"""Compares what the compiler computed with an independent derivation from each model's DEFINITION.

    python check.py DIRECTORY [--summary FILE] [--record DIRECTORY --states K]

DIRECTORY holds one request `NAME.COORDINATES.json` per model and coordinate set: the definition, the exported
coordinates, and states with the compiler's values (see README.md). One line is printed per request; the exit code is
1 where anything disagrees, 2 where there was nothing to compare. Everything is in SI.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import kinds
from comparison import Comparison
from control import compare_control
from entries import compare_norms, compare_random, read_states
from record import consistent_records, random_records, write_record
from sensitivity import compare_sensitivity


def main(arguments=None):
    options = read_options(arguments)
    files = sorted(path for path in options.directory.glob("*.json") if options.only in path.name)
    summary = [check_file(path, options) for path in files]
    if options.summary:
        options.summary.write_text(json.dumps(summary, indent=1))
    failures = [failure for line in summary for failure in line["failures"]]
    for failure in failures:
        print(failure)
    if not files:
        print(f"no requests in {options.directory}: nothing was compared")
        return 2
    bad = sum(1 for line in summary if line["failures"])
    states = sum(line["random"] + line["consistent"] for line in summary)
    verdict = f"{bad} of {len(files)} disagree" if bad else "all agree"
    print(f"{len(files)} requests, {states} states: {verdict}")
    return 1 if failures else 0


def read_options(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, help="where the requests are")
    parser.add_argument("--summary", type=Path, help="file for the results as JSON")
    parser.add_argument("--record", type=Path, help="directory for the reference's own values")
    parser.add_argument("--states", type=int, default=1, help="how many states of each kind to record")
    parser.add_argument("--mutated", default="", help="models, by commas, of which one state more is recorded: mutants need it")
    parser.add_argument("--only", default="", help="only requests whose file name contains this")
    parser.add_argument("--minimum", type=int, default=1, help="random and consistent states each must have")
    return parser.parse_args(arguments)


def check_file(path, options):
    began = time.monotonic()
    line = {"request": path.stem, "random": 0, "consistent": 0, "set_aside": 0, "condition": None}
    comparison = Comparison(path.stem)
    try:
        request = json.loads(path.read_text())
        check_request(request, comparison, line, options)
    except (ValueError, KeyError, TypeError, IndexError, NotImplementedError, RuntimeError) as error:
        comparison.fail("request", f"{type(error).__name__}: {error}")
    for kind in ("random", "consistent"):
        if line[kind] < options.minimum:
            comparison.fail(kind, f"{line[kind]} states, expected at least {options.minimum}")
    line |= {"worst": comparison.worst, "failures": comparison.failures, "seconds": time.monotonic() - began}
    print_line(line)
    return line


def print_line(line):
    worst = " ".join(f"{name} {error:.1e}" for name, error in line["worst"].items())
    condition = "-" if line["condition"] is None else "{:.1e}..{:.1e}".format(*line["condition"])
    states = f"{line['random']} random, {line['consistent']} consistent, {line['set_aside']} set aside"
    verdict = "DISAGREES" if line["failures"] else "agrees"
    print(f"{line['request']}: {verdict} | {worst} | {states} | condition {condition} | {line['seconds']:.1f} s")
    sys.stdout.flush()


def check_request(request, comparison, line, options):
    if request.get("parameters_are_si") is not True:
        raise ValueError("parameters must be in SI")
    kind = kinds.kind_of(request["definition"])
    model, absolute, own = kind.derive(request["definition"], request["coordinates"])
    records = {"random": [], "consistent": []}
    mutated = line["request"].partition(".")[0] in options.mutated.split(",")
    count = options.states + int(mutated)
    if request["random"]:
        line["random"] = len(request["random"])
        states = read_states(model, own, request["random"])
        compare_norms(comparison, own, states)
        quantities = own.evaluate(states)
        compare_random(comparison, own, request["random"], quantities)
        if options.record:
            records["random"] = random_records(states, quantities, count)
    if request["consistent"]:
        line["consistent"] = len(request["consistent"])
        check = kind.consistent_check(comparison, model, absolute, own, request["consistent"])
        check.run(line)
        further = compare_control(check)
        sensitivity = compare_sensitivity(check)
        if sensitivity is not None:
            further["sensitivity"] = sensitivity
        if options.record:
            records["consistent"] = consistent_records(check, count, further)
    if options.record:
        write_record(options.record / f"{line['request']}.json", request, own, records)


if __name__ == "__main__":
    sys.exit(main())
