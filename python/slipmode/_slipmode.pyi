from collections.abc import Sequence
from typing import Final

__all__ = [
    "PRECISION_LEVELS",
    "RESULT_COLUMNS",
    "SLIP_MODES",
    "SPECTRAL_CLASSES",
    "VERSION",
    "call",
    "classify_point",
    "classify_points",
    "describe_point",
    "draw_grid",
    "exact_values",
    "fitted_words",
    "has_error_bar",
    "main",
    "roots_of_point",
    "roots_of_points",
    "table_columns",
    "table_rows",
]

PRECISION_LEVELS: Final[list[str]]
RESULT_COLUMNS: Final[list[str]]
SLIP_MODES: Final[list[str]]
SPECTRAL_CLASSES: Final[list[str]]
VERSION: Final[str]

def main(arguments: Sequence[str]) -> int: ...
def call(arguments: Sequence[str]) -> tuple[int, bytes, str]: ...
def exact_values(names: Sequence[str], texts: Sequence[str], first: int) -> list[str]: ...
def has_error_bar(text: str) -> bool: ...
def classify_point(
    columns: Sequence[tuple[str, str | float, str | None]], inertial_threshold: str | None = None
) -> tuple[tuple[list[float], list[int]], str] | None: ...
def classify_points(
    columns: Sequence[tuple[str, str | float | bytes | list[str], str | None]],
    length: int,
    inertial_threshold: str | None,
    is_whole: bool,
) -> tuple[bytes, str]: ...
def roots_of_point(values: Sequence[str], digits: str) -> tuple[int, str, str | None]: ...
def roots_of_points(columns: Sequence[tuple[str, str | float | bytes | list[str], str | None]], length: int) -> bytes: ...
def describe_point(values: Sequence[str], inertial_threshold: str | None = None) -> str: ...
def draw_grid(
    slider: Sequence[str], axes: Sequence[str], inertial_threshold: str | None = None
) -> tuple[int, str, tuple[bytes, bytes, str] | None]: ...
def fitted_words(value: float, error: float, low: float | None, high: float | None, unit: str) -> tuple[str, str]: ...
def table_columns(
    header: bytes, unused: Sequence[str]
) -> tuple[int, str, tuple[list[int | None], list[str | None], list[int]] | None]: ...
def table_rows(csv: bytes, unused: Sequence[str]) -> tuple[int, str, list[list[str]] | None]: ...
