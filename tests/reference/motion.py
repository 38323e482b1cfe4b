"""What a request says of the motion of a body and of the reaction of a joint, entry by entry."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Motion:
    entries: tuple  # names
    groups: dict  # quantity → which entries
    angular: frozenset  # entries that a particle has none of
    wrench: tuple  # names of the entries of a reaction

    @property
    def size(self):
        return len(self.entries)


PLANE = Motion(
    entries=("x", "y", "cos θ", "sin θ", "v_x", "v_y", "ω", "a_x", "a_y", "α"),
    groups={"poses": range(0, 4), "velocities": range(4, 7), "accelerations": range(7, 10)},
    angular=frozenset((2, 3, 6, 9)),
    wrench=("x", "y", "τ"),
)

SPACE = Motion(
    entries=(
        "x", "y", "z", *(f"A_{row}{column}" for row in "xyz" for column in "xyz"),
        "v_x", "v_y", "v_z", "ω_x", "ω_y", "ω_z", "a_x", "a_y", "a_z", "ω̇_x", "ω̇_y", "ω̇_z",
    ),
    groups={"poses": range(0, 12), "velocities": range(12, 18), "accelerations": range(18, 24)},
    angular=frozenset((*range(3, 12), *range(15, 18), *range(21, 24))),
    wrench=("x", "y", "z", "τ_x", "τ_y", "τ_z"),
)  # fmt: skip
