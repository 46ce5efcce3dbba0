"""A Monte Carlo over a, b and D_c: how often is a laboratory's slider unstable, and which slip modes occur?"""

import numpy as np
import pandas as pd
import slipmode


def main(count: int = 100_000) -> None:
    """Print the shares of slip modes among random sliders, the range of frequencies, and simulations of three of them."""
    random = np.random.default_rng(1)
    frame = pd.DataFrame(
        {
            "a": random.normal(0.009, 0.0005, count),
            "b": random.normal(0.0126, 0.0005, count),
            "Dc [um]": random.uniform(6, 10, count),
        }
    )
    found = slipmode.classify(frame, k="2MPa/mm", m="12kg/50cm2", sigma="5MPa", v="10um/s")
    print(found["slip_mode"].value_counts(normalize=True))
    print(found["frequency_hz"].quantile([0.05, 0.95]))
    unstable = frame[found["transition_sign"] < 0].head(3)
    runs = slipmode.simulate(unstable, k="2MPa/mm", m="12kg/50cm2", sigma="5MPa", v="10um/s", law="slip", rtol="1e-6")
    print(runs[["a", "b", "Dc [um]", "period_s", "peak_velocity_m_per_s"]])


if __name__ == "__main__":
    main()
