"""Simbody: the library of the distribution (libsimbody-dev of Debian), because there is no package of Python to pin."""

import pathlib

from linkage import joint_angles
from surroundings import HERE, Absent, Entry, native

NAME = "simbody"
INCLUDES = ("/usr/include/simbody", "/usr/local/include/simbody")


def library(surroundings):
    output = surroundings.folder("built", NAME) / "peer.so"
    source = HERE / "rivals" / NAME / "peer.cpp"
    if not output.exists() or output.stat().st_mtime < source.stat().st_mtime:
        include = next((folder for folder in INCLUDES if pathlib.Path(folder).is_dir()), None)
        if include is None:
            raise Absent("its headers are not installed (libsimbody-dev of Debian)")
        libraries = ["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"]
        surroundings.compile("g++", ["-std=c++17", "-w", *native(), "-I", include, source, *libraries], output)
    return output


def prepare(surroundings, linkage, source):
    written = surroundings.folder("generated", NAME) / f"{linkage.name}.txt"
    written.write_text(linkage.plain())
    states = lambda numbers: joint_angles(linkage, numbers)  # noqa: E731
    return [Entry("Simbody", library(surroundings), str(written), states, 1e-6, note="steps of Runge–Kutta–Merson, projected")]
