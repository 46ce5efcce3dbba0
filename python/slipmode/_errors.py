"""What the package raises, and what it warns of."""


class SlipmodeError(ValueError):
    """Base of what the package raises."""


class InputError(SlipmodeError):
    """The input is at fault."""


class CheckFailed(SlipmodeError, RuntimeError):
    """A check failed, or a computation has no result."""


class SlipmodeWarning(UserWarning):
    """A value looks like another unit's, or lies outside of the range that was tested."""
