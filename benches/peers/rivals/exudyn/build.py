"""Exudyn: simulations only, because its interface has no accelerations of a state; see `simulate.py`."""

from surroundings import HERE

NAME = "exudyn"
PEER = "Exudyn, generalised-α"


class Simulator:
    """A peer that simulates in a Python of its own and times itself."""

    def __init__(self, surroundings, linkage, name, peer):
        self.surroundings, self.peer = surroundings, peer
        self.script = HERE / "rivals" / name / "simulate.py"
        self.python = surroundings.python(name)
        self.linkage = surroundings.folder("generated", name) / f"{linkage.name}.json"
        self.linkage.write_text(linkage.json())

    def run(self, told):
        """What the script prints."""
        return self.surroundings.run([self.python, self.script, self.linkage, told], timeout=300)


def simulator(surroundings, linkage):
    return Simulator(surroundings, linkage, NAME, PEER)
