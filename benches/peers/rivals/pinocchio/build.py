"""Pinocchio: its C++ library from headers for this processor, and C that CasADi writes of its algorithms for trees.

Both programs take minutes to compile and serve all mechanisms. clang is taken where it is, because its code of the library is faster.
"""

import shutil

from linkage import joint_angles
from surroundings import HERE, Absent, Entry, bytes_of_code, native

NAME = "pinocchio"
SOURCE = HERE / "rivals" / NAME
INCLUDES = ("/usr/include/eigen3", "/usr/local/include/eigen3", "/opt/homebrew/include/eigen3")
APPROXIMATE = 1e-3


def eigen(surroundings):
    for folder in INCLUDES:
        try:
            surroundings.run(["test", "-d", folder])
            return folder
        except Absent:
            continue
    raise Absent("no headers of Eigen (libeigen3-dev of Debian)")


def flags(surroundings):
    prefix = surroundings.packages(NAME) / "cmeel.prefix" / "include"
    # The library's own build says the same of boost's lists, which are too short for all kinds of joints.
    boost = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS"]
    return ["-std=c++17", "-O3", "-march=native", "-DNDEBUG", "-w", *boost, "-isystem", prefix, "-isystem", eigen(surroundings)]


def built(surroundings, name, arguments):
    """Compiles once; anew where a source is younger. Output, and seconds where it was compiled now."""
    output = surroundings.folder("built", NAME) / name
    stamp = output.with_suffix(".seconds")
    sources = [*SOURCE.glob("*.?pp"), *(HERE / "interface").glob("*.h*")]
    if not stamp.exists() or stamp.stat().st_mtime < max(path.stat().st_mtime for path in sources):
        compiler = "clang++" if shutil.which("clang++") else "g++"
        print(f"  {NAME}: {name} is compiled by {compiler}, which takes minutes", flush=True)
        seconds = surroundings.compile(compiler, [*flags(surroundings), *arguments], output)
        stamp.write_text(f"{seconds}\n")
    return output, float(stamp.read_text())


def prepare(surroundings, linkage, source):
    written = surroundings.folder("generated", NAME) / f"{linkage.name}.txt"
    written.write_text(linkage.plain())
    library, _ = built(surroundings, "peer.so", ["-shared", "-fPIC", SOURCE / "peer.cpp"])
    states = lambda numbers: joint_angles(linkage, numbers)  # noqa: E731
    if linkage.loops:
        return [
            Entry("Pinocchio, constraintDynamics", library, str(written), states, 1e-6),
            Entry("Pinocchio, lcaba", library, f"{written}:lcaba", states, APPROXIMATE, True, "approximate"),
        ]
    return [Entry("Pinocchio, aba", library, str(written), states, 1e-9), *generated(surroundings, linkage, written, states)]


def generated(surroundings, linkage, written, states):
    """C of the library's algorithms."""
    packages = surroundings.packages("casadi") / "casadi"
    where = ["-isystem", packages / "include", "-L", packages, f"-Wl,-rpath,{packages}", "-lcasadi"]
    try:
        program, _ = built(surroundings, "codegen", [SOURCE / "codegen.cpp", *where])
    except Absent as absent:
        print(f"  {NAME}: no code generation: {absent}", flush=True)
        return []
    entries = []
    folder = surroundings.folder("generated", NAME)
    for way, title in (("aba", "ABA"), ("crba", "CRBA + LDL")):
        name = f"{linkage.name}_{way}"
        said = surroundings.run([program, written, name, way], cwd=folder).split()
        file = folder / f"{name}.c"
        sizes = {"SIZE": len(linkage.links), "INTEGERS": said[1], "WORK": said[2], "FUNCTION": name, "SOURCE": f'"{file}"'}
        output = surroundings.folder("built", NAME) / f"{name}.so"
        alone = output.with_suffix(".o")
        seconds = surroundings.compile("gcc", ["-O3", "-march=native", "-fPIC", "-c", file], alone)
        defines = [f"-D{key}={value}" for key, value in sizes.items()]
        surroundings.compile("gcc", [*native(), *defines, HERE / "rivals" / "casadi" / "peer.c", "-lm"], output)
        entries.append(
            Entry(
                f"Pinocchio's {title}, CasADi's C",
                output,
                name,
                states,
                1e-9,
                generation=float(said[0]),
                build=seconds,
                code=bytes_of_code(alone),
            )  # fmt: skip
        )
    return entries
