"""Compares Linkwright with its rivals on this machine: README.md says what is compared and how.

    python3 benches/peers/run.py [--only mujoco,casadi] [--mechanisms four_bar,andrews] [--quick] [--out DIR]

What it needs is Python with venv, cargo and gcc; every peer is installed with pinned versions below target/peers. A peer that cannot be
installed, built or expressed is named as absent, with the reason.
"""

import argparse
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from surroundings import ROOT, Absent, make_environment  # noqa: E402

# The environment in which definitions are read.
READER = "casadi"


class Settings:
    def __init__(self, arguments, all_mechanisms, all_peers):
        listed = lambda text: [part for part in text.split(",") if part] if text else []  # noqa: E731
        self.only = listed(arguments.only)
        unknown = set(self.only) - set(all_peers)
        if unknown:
            raise SystemExit(f"unknown peers: {', '.join(sorted(unknown))}; known: {', '.join(all_peers)}")
        self.quick = arguments.quick
        self.mechanisms = listed(arguments.mechanisms) or list(all_mechanisms)
        unknown = set(self.mechanisms) - set(all_mechanisms)
        if unknown:
            raise SystemExit(f"unknown mechanisms: {', '.join(sorted(unknown))}; known: {', '.join(all_mechanisms)}")
        self.target = pathlib.Path(arguments.target).resolve()
        self.out = pathlib.Path(arguments.out).resolve()
        self.seconds = 2.0 if arguments.quick else 20.0

    def named(self):
        return {"only": self.only, "mechanisms": self.mechanisms, "quick": self.quick, "seconds": self.seconds}


def parsed():
    parser = argparse.ArgumentParser(description="Compares Linkwright with its rivals on this machine.")
    parser.add_argument("--only", default="", help="peers, by commas")
    parser.add_argument("--mechanisms", default="", help="mechanisms, by commas")
    parser.add_argument("--quick", action="store_true", help="less time for each; figures are rough")
    parser.add_argument("--out", default=str(HERE / "results"), help="folder of the tables")
    parser.add_argument("--target", default=str(ROOT / "target" / "peers"), help="folder for environments and what is built")
    return parser.parse_args()


def main():
    arguments = parsed()
    target = pathlib.Path(arguments.target).resolve()
    try:
        reader = make_environment(target, READER)
    except Absent as absent:
        raise SystemExit(f"definitions are read by CasADi, which is not to be had: {absent}") from None
    if pathlib.Path(sys.prefix).resolve() != reader.parent.parent.resolve():
        os.execv(reader, [str(reader), str(pathlib.Path(__file__).resolve()), *sys.argv[1:]])
    import compare
    import table

    settings = Settings(arguments, compare.MECHANISMS, [*compare.RIVALS, *compare.SIMULATORS, *compare.BATCHES])
    comparison = compare.Comparison(settings)
    try:
        comparison.course()
    except KeyboardInterrupt:
        raise SystemExit("interrupted: nothing is written") from None
    except Absent as absent:
        raise SystemExit(f"without this nothing can be compared: {absent}") from None
    for path in table.write(comparison.results, settings.out):
        print(path)


if __name__ == "__main__":
    main()
