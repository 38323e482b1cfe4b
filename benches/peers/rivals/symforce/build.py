"""SymForce: C++ of `generate.py`, for small mechanisms in the plane."""

from linkage import joint_angles
from rivals.pinocchio.build import eigen
from surroundings import HERE, Absent, Entry, native

NAME = "symforce"
SOURCE = HERE / "rivals" / NAME
MOST_LINKS = 8


def prepare(surroundings, linkage, source):
    if not linkage.planar:
        raise Absent("derived for the plane only")
    if len(linkage.links) > MOST_LINKS:
        raise Absent(f"derived up to {MOST_LINKS} bodies: its expressions are not shared on the way")
    folder = surroundings.folder("generated", NAME)
    given = folder / f"{linkage.name}.json"
    given.write_text(linkage.json())
    said = surroundings.run([surroundings.python(NAME), SOURCE / "generate.py", given, linkage.name, folder], timeout=600)
    seconds, header, _ = said.splitlines()[-1].split()
    output = surroundings.folder("built", NAME) / f"{linkage.name}.so"
    function = "".join(part.capitalize() for part in linkage.name.split("_"))
    defines = [f"-DFUNCTION={function}", f"-DSIZE={len(linkage.links)}", f'-DHEADER="{header}"']
    include = ["-isystem", eigen(surroundings)]
    built = surroundings.compile("g++", ["-std=c++17", "-w", *native(), *defines, *include, SOURCE / "peer.cpp"], output)
    return [
        Entry(
            "SymForce", output, linkage.name, lambda numbers: joint_angles(linkage, numbers), 1e-6, generation=float(seconds), build=built
        )
    ]
