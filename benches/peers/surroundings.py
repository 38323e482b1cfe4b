"""Virtual environments, compilers and folders of the peers. What is missing is named, by `Absent`."""

import os
import pathlib
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]


class Absent(Exception):
    """Why a peer, or a peer's model of a mechanism, is not there."""


@dataclass
class Entry:
    """A peer's model of a mechanism, ready to be loaded."""

    peer: str
    library: pathlib.Path
    model: str  # what `peer_open` is given
    states: object  # motions of the bodies → positions, velocities, accelerations in the peer's coordinates
    tolerance: float = 1e-9  # of the accelerations, relative to the largest of a state
    middle: bool = False  # whether that is asked of the middle state, as of soft rows, or of the worst
    note: str = ""
    generation: float | None = None  # s
    build: float | None = None  # s
    code: int | None = None  # bytes of instructions


class Surroundings:
    def __init__(self, target):
        self.target = target
        self.versions = {}
        self.ready = {}

    def folder(self, *parts):
        path = self.target.joinpath(*parts)
        path.mkdir(parents=True, exist_ok=True)
        return path

    def python(self, peer):
        """The interpreter of a peer's environment, made where it is missing."""
        if peer not in self.ready:
            try:
                self.ready[peer] = make_environment(self.target, peer)
            except Absent as absent:
                self.ready[peer] = absent
        if isinstance(self.ready[peer], Absent):
            raise self.ready[peer]
        return self.ready[peer]

    def packages(self, peer):
        """Where a peer's environment has its packages."""
        python = self.python(peer)
        return pathlib.Path(self.run([python, "-c", "import sysconfig; print(sysconfig.get_paths()['platlib'])"]).strip())

    def run(self, command, **options):
        """Output of a command; `Absent` with what it said last where it fails."""
        return run(command, **options)

    def compile(self, compiler, arguments, output):
        """Seconds of a compilation."""
        if shutil.which(compiler) is None:
            raise Absent(f"no compiler `{compiler}`")
        begin = time.perf_counter()
        run([compiler, *arguments, "-o", output])
        return time.perf_counter() - begin


def run(command, timeout=1800, **options):
    command = [str(part) for part in command]
    name = pathlib.Path(command[0]).name
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, **options)
    except FileNotFoundError:
        raise Absent(f"no `{name}`") from None
    except subprocess.TimeoutExpired:
        raise Absent(f"`{name}` took more than {timeout} s") from None
    if done.returncode:
        said = [line.strip() for line in (done.stderr or done.stdout).splitlines() if line.strip()]
        errors = [line for line in said if "error" in line.lower()]
        last = (errors or said or [f"exit code {done.returncode}"])[-1 if not errors else 0]
        raise Absent(f"`{name}` failed: {last[:200]}")
    return done.stdout


def make_environment(target, peer):
    """A virtual environment with the pinned packages of a peer; made anew where the pins have changed."""
    requirements = HERE / "requirements" / f"{peer}.txt"
    folder = target / "environments" / peer
    python, stamp = folder / "bin" / "python", folder / "pinned.txt"
    if python.exists() and stamp.exists() and stamp.read_text() == requirements.read_text():
        return python
    print(f"  {peer}: {' '.join(requirements.read_text().split())}", flush=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    run([sys.executable, "-m", "venv", "--clear", folder])
    run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", requirements])
    stamp.write_text(requirements.read_text())
    return python


def bytes_of_code(library, names=()):
    """Bytes of the functions of these names in an object or shared library; of all of its instructions without names."""
    if shutil.which("nm") is None:
        return None
    total = 0
    for line in run(["nm", "-S", "--defined-only", library]).splitlines():
        parts = line.split()
        if len(parts) == 4 and parts[2] in "tTwW" and (not names or parts[3] in names):
            total += int(parts[1], 16)
    return total


def native(*flags):
    return ["-O3", "-march=native", "-shared", "-fPIC", *flags]


def machine():
    """Processor, cores, load, compilers."""
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text()
    except OSError:
        text = ""
    field = next((line.split(":", 1)[1].strip() for line in text.splitlines() if line.startswith("model name")), os.uname().machine)
    versions = {}
    for tool in ("rustc", "gcc", "clang"):
        try:
            versions[tool] = run([tool, "--version"]).splitlines()[0]
        except Absent:
            versions[tool] = "absent"
    return {"processor": field, "cores": os.cpu_count(), "load": list(os.getloadavg()), **versions}
