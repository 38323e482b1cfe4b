"""A peer that simulates in a Python of its own."""

from surroundings import HERE


class Simulator:
    """Its script times itself: `rivals/NAME/simulate.py`."""

    def __init__(self, surroundings, linkage, name, peer):
        self.surroundings, self.peer = surroundings, peer
        self.script = HERE / "rivals" / name / "simulate.py"
        self.python = surroundings.python(name)
        self.linkage = surroundings.folder("generated", name) / f"{linkage.name}.json"
        self.linkage.write_text(linkage.json())

    def run(self, told):
        """What the script prints."""
        return self.surroundings.run([self.python, self.script, self.linkage, told], timeout=300)
