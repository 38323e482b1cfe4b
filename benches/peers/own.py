"""Linkwright's shared library: built, and asked for definitions and consistent states."""

import ctypes
import os
import pathlib
import subprocess

import numpy as np
from surroundings import Absent

HERE = pathlib.Path(__file__).resolve().parent
DOUBLES = np.ctypeslib.ndpointer(dtype=np.float64, flags="C")


def environment():
    """With everything for this processor, as the peers' C is compiled."""
    flags = os.environ.get("RUSTFLAGS", "-C target-cpu=native")
    return os.environ | {"RUSTFLAGS": flags, "CARGO_INCREMENTAL": "0"}


def build(target):
    """The shared library."""
    command = ["cargo", "build", "--release", "--locked", "--manifest-path", HERE / "linkwright" / "Cargo.toml", "--target-dir", target]
    try:
        subprocess.run(command, env=environment(), check=True)
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        raise Absent(f"Linkwright's shared library is not built: {error}") from None
    for name in ("liblinkwright_peer.so", "liblinkwright_peer.dylib"):
        if (target / "release" / name).exists():
            return target / "release" / name
    raise Absent("the shared library of linkwright-peer is not where cargo puts it")


class Own:
    """A model, by its name."""

    def __init__(self, library, name):
        self.library = ctypes.CDLL(str(library))
        self.name = name
        self.library.linkwright_text.restype = ctypes.c_char_p
        self.library.peer_open.restype = ctypes.c_void_p
        self.library.linkwright_states.argtypes = [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_int, DOUBLES, DOUBLES, DOUBLES]
        self.library.linkwright_bodies.argtypes = [ctypes.c_void_p, DOUBLES, DOUBLES]
        self.library.linkwright_motions.argtypes = [ctypes.c_void_p]
        self.library.peer_sizes.argtypes = [ctypes.c_void_p, ctypes.POINTER(ctypes.c_int), ctypes.POINTER(ctypes.c_int)]
        self.peer = self.library.peer_open(name.encode())
        if not self.peer:
            raise KeyError(f"Linkwright's library has no model `{name}`")
        q, v = ctypes.c_int(), ctypes.c_int()
        self.library.peer_sizes(self.peer, ctypes.byref(q), ctypes.byref(v))
        self.sizes = q.value, v.value
        self.motions = self.library.linkwright_motions(self.peer)

    def definition(self):
        return self.library.linkwright_text(self.name.encode(), 0).decode()

    def source(self):
        return self.library.linkwright_text(self.name.encode(), 1).decode()

    def states(self, count, seed=0):
        """Rows (q, v), accelerations, motions of the bodies; along the motion, or at random with a seed."""
        q, v = self.sizes
        found = np.zeros((count, q + v)), np.zeros((count, v)), np.zeros((count, self.motions))
        self.library.linkwright_states(self.peer, seed, count, *found)
        return found

    def bodies(self, row):
        """The motion of the bodies in a state."""
        found = np.zeros((1, self.motions))
        self.library.linkwright_bodies(self.peer, np.ascontiguousarray(row), found)
        return found
