"""SymPy: C of `derive.py`, for small mechanisms in the plane. Longer ones take SymPy minutes."""

from linkage import joint_angles
from surroundings import HERE, Absent, Entry, bytes_of_code, native

NAME = "sympy"
SOURCE = HERE / "rivals" / NAME
MOST_LINKS = 25


def prepare(surroundings, linkage, source):
    if not linkage.planar:
        raise Absent("derived for the plane only: a user of SymPy would write the kinematics in space by hand")
    if len(linkage.links) > MOST_LINKS:
        raise Absent(f"derived up to {MOST_LINKS} bodies: SymPy takes many minutes for more")
    folder = surroundings.folder("generated", NAME)
    given, file = folder / f"{linkage.name}.json", folder / f"{linkage.name}.c"
    given.write_text(linkage.json())
    said = surroundings.run([surroundings.python(NAME), SOURCE / "derive.py", given, linkage.name, file], timeout=900).split()
    built = surroundings.folder("built", NAME)
    alone, output = built / f"{linkage.name}.o", built / f"{linkage.name}.so"
    seconds = surroundings.compile("gcc", ["-O3", "-march=native", "-fPIC", "-c", file], alone)
    defines = [f"-DFUNCTION={linkage.name}", f"-DSIZE={len(linkage.links)}"]
    surroundings.compile("gcc", [*native(), *defines, SOURCE / "peer.c", alone, "-lm"], output)
    return [
        Entry(
            "SymPy, projection + LDL + cse", output, linkage.name, lambda numbers: joint_angles(linkage, numbers), 1e-6,
            generation=float(said[0]), build=seconds, code=bytes_of_code(alone),
        )
    ]  # fmt: skip
