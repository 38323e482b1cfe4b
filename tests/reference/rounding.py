"""Magnitudes that do not grow with the length of a chain of bodies.

The sum of magnitudes of `magnitude` multiplies along products: of seven rotations it is a thousand to a billion times
what rounding does. Here it is bounded by the rounding that happens: all instructions are run again in single
precision, and the difference, in units of that precision, is the size of the terms as far as they matter. Of an entry
the largest over the states counts, ten times, and at least a thousandth of the largest entry of its quantity, as any
one difference may vanish by chance.

No entry is smaller than a thousandth of the largest of its quantity in the same state, however small its own terms: in
space a motion in a plane or about an axis has components that are rounding of the others, and the two derivations turn
them in different ways.
"""

import numpy as np

from magnitude import Evaluator

SAFETY = 10.0
LEAST = 1e-3


class RoundingEvaluator(Evaluator):
    def __call__(self, *arguments):
        results = super().__call__(*arguments)
        coarse = self.values(*arguments, dtype=np.float32)
        for name, result in results.items():
            if result.values.size:
                bound = rounding_bound(result.values, coarse[name].values)
                result.magnitudes = np.minimum(result.magnitudes, np.maximum(bound, np.abs(result.values)))
                largest = result.magnitudes.max(axis=1, keepdims=True)
                result.magnitudes = np.where(
                    result.magnitudes > 0.0, np.maximum(result.magnitudes, LEAST * largest), 0.0
                )
        return results


def rounding_bound(fine, coarse):
    """Per entry, of (states, entries) computed in double and in single precision; infinite where single has none."""
    with np.errstate(all="ignore"):
        difference = np.abs(fine - coarse) / np.finfo(np.float32).eps
    difference = np.where(np.isfinite(difference), difference, np.inf).max(axis=0)
    finite = difference[np.isfinite(difference)]
    return SAFETY * np.maximum(difference, LEAST * finite.max(initial=0.0))
