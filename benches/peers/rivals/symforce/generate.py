"""SymForce: C++ of a linkage in the plane, (q, v) → v̇ in the angles of its hinges.

    python generate.py LINKAGE.json NAME FOLDER

M, Q, D and γ are derived as for SymPy, on which SymForce stands; elimination, the search for common subexpressions and C++ are
SymForce's. Prints seconds and the header. Runs in SymForce's own environment.
"""

import json
import pathlib
import sys
import time

# The folder of SymPy's script, and not the one above it, whose `sympy` is none.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "sympy"))

import derive  # noqa: E402
import symforce.symbolic as sf  # noqa: E402
from symforce import codegen  # noqa: E402
from symforce.values import Values  # noqa: E402


class Expressions:
    """Keeps expressions as they are: SymForce finds by itself what occurs twice."""

    def keep(self, expression):
        return sf.sympify(expression)


def main():
    linkage, name, folder = json.load(open(sys.argv[1])), sys.argv[2], sys.argv[3]
    begin = time.perf_counter()
    plane, *equations = derive.derived(linkage)
    n = len(plane.links)
    q, v = (sf.Matrix(n, 1).symbolic(letter) for letter in "qv")
    accelerations = derive.solved(plane, *equations, Expressions())
    absolute = {}
    for i, link in enumerate(plane.links):
        before = link["parent"]
        for letter, vector, symbols in (("x", q, plane.angles), ("w", v, plane.rates)):
            known = absolute[letter, before] if before >= 0 else 0
            absolute[letter, i] = vector[i] + known
    replaced = {sf.Symbol(f"{letter}{i}"): value for (letter, i), value in absolute.items()}
    accelerations = [sf.sympify(a).subs(replaced) for a in accelerations]
    befores = [link["parent"] for link in plane.links]
    relative = [a - accelerations[before] if before >= 0 else a for a, before in zip(accelerations, befores)]
    generator = codegen.Codegen(
        inputs=Values(q=q, v=v), outputs=Values(a=sf.Matrix(relative)), config=codegen.CppConfig(), name=name, return_key="a"
    )
    made = generator.generate_function(output_dir=pathlib.Path(folder), namespace="linkages")
    header = next(path for path in made.generated_files if path.suffix == ".h")
    print(time.perf_counter() - begin, header, generator.name)


if __name__ == "__main__":
    main()
