from collections.abc import Sequence
from typing import Final

__all__ = [
    "CheckFailed",
    "InputError",
    "SLIP_MODES",
    "SPECTRAL_CLASSES",
    "VERSION",
    "call",
    "check_slider",
    "classify_points",
    "main",
]

class InputError(ValueError): ...
class CheckFailed(RuntimeError): ...

SLIP_MODES: Final[list[str]]
SPECTRAL_CLASSES: Final[list[str]]
VERSION: Final[str]

def main(arguments: Sequence[str]) -> int: ...
def call(arguments: Sequence[str]) -> tuple[int, bytes, str]: ...
def check_slider(slider: Sequence[str]) -> bool: ...
def classify_points(
    slider: Sequence[str],
    normal_stresses: bytes,
    loading_velocities: bytes,
    inertial_threshold: str | None = None,
    first: int = 0,
) -> tuple[bytearray, bytearray, bytearray, bytearray, bytearray, bytearray, bytearray]: ...
