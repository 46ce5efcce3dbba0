"""The command line: ``slipmode`` and ``python -m slipmode``."""

import sys

from slipmode import _slipmode


def main() -> int:
    """Run the command line of this process and return its exit code."""
    return _slipmode.main(["slipmode", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
