"""What type checkers know: numbers give records, arrays give arrays of results, frames give frames. The tests check it with mypy."""

from typing import assert_type

import numpy as np
import slipmode
from numpy.typing import NDArray

STRESSES = np.array([1e5, 5e6, 2e7])


def main() -> None:
    """Ask about one slider at a point, at an array of points, and about a mapping of columns."""
    point = slipmode.classify(a=0.009, b=0.0126, d_c=8e-6, k=2e9, m=2400, sigma=5e6, v=1e-5)
    assert_type(point, slipmode.Classification)
    exact = slipmode.classify(a="0.009", b="0.0126", d_c="8um", k=2e9, m=2400, sigma="5MPa", v="10um/s")
    # A text may have an error bar.
    assert_type(exact, slipmode.Classification | slipmode.Possibilities)
    several = slipmode.classify(a="0.009", b=0.0126, d_c=8e-6, k=2e9, m=2400, sigma=STRESSES, v=1e-5)
    assert_type(several, slipmode.Classifications)
    roots = slipmode.roots(a=0.009, b=0.0126, d_c=8e-6, k=2e9, m=2400, sigma=STRESSES, v=1e-5)
    assert_type(roots, NDArray[np.complex128])
    run = slipmode.simulate(a=0.009, b=0.0126, d_c=8e-6, k=2e9, m=2400, sigma=5e6, v=1e-5, law="slip", rtol=1e-6)
    assert_type(run, slipmode.Simulation)
    columns = {"a": [0.008, 0.009], "b": [0.0126] * 2, "d_c": [8e-6] * 2, "k": [2e9] * 2, "m": [2400] * 2}
    assert_type(slipmode.boundary(columns, n=3), slipmode.Table)
    print(point.slip_mode, several.slip_mode[1], run.mode, roots.shape)


if __name__ == "__main__":
    main()
