"""C code for mechanisms, as an expert writes it around CasADi: plane.py, andrews.py, space.py.

    python benches/casadi/generate.py DIRECTORY

Prints the operations of each function after common subexpressions have been found.

Everything is one straight-line function

    (angles, rates, (2α, β²), torques) -> (accelerations, multipliers)

without torques in the plane, whose C is compiled by gcc -O3, and into DIRECTORY/native by gcc -O3 -march=native.
"""

import itertools
import pathlib
import subprocess
import sys

import andrews
import plane
import space
import trees


def main():
    directory = pathlib.Path(sys.argv[1])
    (directory / "native").mkdir(parents=True, exist_ok=True)
    for made in itertools.chain(plane.functions(), andrews.functions(), space.functions()):
        name = made.name()
        made.generate(f"{name}.c", {"with_header": False})
        pathlib.Path(f"{name}.c").rename(directory / f"{name}.c")
        for target, flags in ((".", []), ("native", ["-march=native"])):
            command = ["gcc", "-O3", *flags, "-shared", "-fPIC", f"{name}.c", "-o", f"{target}/{name}.so", "-lm"]
            subprocess.run(command, cwd=directory, check=True)
        (directory / f"{name}.operations").write_text(str(report(made)))
    for part in space.panda_parts():
        report(part)


def report(made):
    """Prints the counts of a function; their sum."""
    counts = trees.counts(made)
    total = sum(counts.values())
    print(f"{made.name():<18}{total:>6}  " + "  ".join(f"{kind} {n}" for kind, n in counts.items() if n))
    return total


if __name__ == "__main__":
    main()
