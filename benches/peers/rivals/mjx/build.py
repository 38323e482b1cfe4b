"""MJX: batches only, from the MJCF of `rivals/mujoco/build.py`."""

import json

from rivals.mujoco.build import mjcf
from surroundings import HERE, Absent

NAME = "mjx"
PEER = "MJX on the processor"
MOST_LINKS = 8


def batch(surroundings, linkage):
    """Steps a second, and how many members and steps they were."""
    if len(linkage.links) > MOST_LINKS:
        raise Absent(f"asked for up to {MOST_LINKS} bodies: its compiler was not ready after four minutes for 21")
    written = surroundings.folder("generated", NAME) / f"{linkage.name}.xml"
    written.write_text(mjcf(linkage))
    members, steps = 1024, 10
    command = [surroundings.python(NAME), HERE / "rivals" / NAME / "batch.py", written, members, steps, 1e-6]
    said = json.loads(surroundings.run(command, timeout=240).splitlines()[-1])
    return {"members": members, "steps": steps, "threads": "its own", **said}
