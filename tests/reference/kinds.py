"""The one place where planar and spatial definitions part: what derives and checks a definition of either kind."""

import reference
import space_reference
from consistent_check import ConsistentCheck
from coordinate_set import CoordinateSet
from definition import Model
from space_consistent import SpaceConsistentCheck
from space_coordinate_set import SpaceCoordinateSet
from space_definition import SpaceModel


class Planar:
    consistent_check = ConsistentCheck

    @staticmethod
    def derive(definition, coordinates):
        """The model, its absolute equations, and the equations in the exported coordinates."""
        model = Model(definition)
        absolute = reference.derive(model)
        return model, absolute, CoordinateSet(model, absolute, coordinates)


class Spatial:
    consistent_check = SpaceConsistentCheck

    @staticmethod
    def derive(definition, coordinates):
        model = SpaceModel(definition)
        own = SpaceCoordinateSet(model, coordinates)
        return model, space_reference.derive(model, coordinates), own


def kind_of(definition):
    kinds = {"planar": Planar, "spatial": Spatial}
    if definition.get("kind") not in kinds:
        raise ValueError(f"a definition of the unknown kind {definition.get('kind')!r}")
    return kinds[definition["kind"]]
