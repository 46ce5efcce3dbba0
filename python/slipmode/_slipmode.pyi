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
    "classify_point",
    "classify_points",
    "describe_point",
    "draw_grid",
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
def classify_point(
    values: Sequence[str], inertial_threshold: str | None = None
) -> tuple[int, str, tuple[int, int, str, str, float, float, float] | None] | None: ...
def describe_point(values: Sequence[str], inertial_threshold: str | None = None) -> str: ...
def draw_grid(
    slider: Sequence[str], loading_velocity: str, normal_stress: str, inertial_threshold: str | None = None
) -> tuple[int, str, tuple[bytearray, bytearray, str] | None]: ...
def classify_points(
    slider: Sequence[str],
    normal_stresses: bytes,
    loading_velocities: bytes,
    inertial_threshold: str | None = None,
    first: int = 0,
) -> tuple[bytearray, bytearray, bytearray, bytearray, bytearray, bytearray, bytearray]: ...
