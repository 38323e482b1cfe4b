"""Errors of compared quantities: worst of each, and what to say when one is above its tolerance."""

from dataclasses import dataclass, field

import numpy as np

TERM_SCALED = 1e-12  # differences in units of the magnitude of the terms
BACKWARD = 2e-13  # normwise backward error of a linear system
RESIDUAL = 1e-10  # constraints and identities at consistent states, in units of the terms
CONDITION = 1e8  # states above are set aside …
SET_ASIDE = 0.1  # … at most this share of them

SHOWN = 5  # entries named per quantity that disagrees


def numbers(values, shape=None):
    """JSON numbers as an array; null, as some writers spell a value that is no number, becomes NaN."""
    array = np.array(values, dtype=object)
    array = np.where(np.equal(array, None), np.nan, array).astype(float) if array.size else np.zeros(array.shape)
    return array if shape is None else array.reshape(shape)


@dataclass
class Comparison:
    """Collects the worst error per quantity and the disagreements of one request."""

    model: str
    worst: dict = field(default_factory=dict)
    failures: list = field(default_factory=list)

    def terms(self, quantity, given, own, scale, entry, tolerance=TERM_SCALED):
        """|given − own| / scale per (state, entry); `entry(k)` names the k-th entry."""
        given, own, scale = (np.asarray(part, float) for part in (given, own, scale))
        if given.shape != own.shape:
            self.fail(quantity, f"{given.shape[-1]} entries given, {own.shape[-1]} expected")
            return
        difference = np.abs(given - own)
        # An entry without any term (a structural zero here) is measured by the largest of its state.
        largest = scale.max(axis=-1, keepdims=True, initial=0.0)
        scale = np.where(scale == 0.0, largest, scale)
        with np.errstate(all="ignore"):
            error = np.where(difference == 0.0, 0.0, difference / scale)
        error = np.where(np.isnan(error), np.inf, error)
        self._keep(
            quantity, error, tolerance, lambda state, k: (entry(k), float(given[state, k]), float(own[state, k]))
        )

    def errors(self, quantity, error, tolerance, what):
        """Errors that are already relative, one per state; `what` says what they are."""
        error = np.asarray(error, float).reshape(-1, 1)
        error = np.where(np.isnan(error), np.inf, error)
        self._keep(quantity, error, tolerance, lambda state, k: (what, None, None))

    def fail(self, quantity, statement):
        self.failures.append(f"{self.model}: {quantity}: {statement}")

    def _keep(self, quantity, error, tolerance, describe):
        if error.size == 0:
            return
        self.worst[quantity] = max(self.worst.get(quantity, 0.0), float(error.max()))
        by_entry = error.max(axis=0)
        for k in np.argsort(-by_entry)[:SHOWN]:
            if by_entry[k] <= tolerance:
                break
            state = int(error[:, k].argmax())
            name, given, own = describe(state, k)
            pair = "" if given is None else f": compiler {given!r}, reference {own!r}"
            self.fail(quantity, f"{name}{pair}; error {by_entry[k]:.3g} > {tolerance:g} (state {state})")
        bad = int((by_entry > tolerance).sum())
        if bad > SHOWN:
            self.fail(quantity, f"and {bad - SHOWN} more entries")
