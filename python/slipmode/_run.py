"""Commands of the library: as functions of this process, or as processes where files are written."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

from slipmode import _slipmode
from slipmode._errors import CheckFailed, InputError, SlipmodeWarning

T = TypeVar("T")
R = TypeVar("R")
WARNING = "warning: "
#: Between two looks at a process.
TICK_S = 0.05

#: What Python calls the keys and the options of the command line, where the names differ.
ARGUMENTS = {
    "direct_effect": "a",
    "evolution_effect": "b",
    "critical_slip_distance_m": "d_c",
    "stiffness_pa_per_m": "k",
    "mass_per_area_kg_per_m2": "m",
    "normal_stress_pa": "sigma",
    "loading_velocity_m_per_s": "v",
    "for": "unknown",
    "points": "n",
    "relative_error": "errors",
    "tolerance": "rtol",
    "grid_normal_stress": "sigma",
    "grid_loading_velocity": "v",
}


def call(*arguments: str, warned: list[str] | None = None) -> str:
    """Run a command in this process and return what it prints; warnings are collected in ``warned`` if it is given."""
    code, output, messages = _slipmode.call(arguments)
    remark(code, in_python(messages), warned)
    return output.decode()


def call_json(*arguments: str, warned: list[str] | None = None) -> Any:
    """Run a command in this process and return the object that it prints."""
    return json.loads(call(*arguments, "--json", warned=warned))


def in_python(messages: str) -> str:
    """Return messages with the names that Python has for options and quantities."""

    def name(found: re.Match[str]) -> str:
        key = found[1].replace("-", "_")
        return ARGUMENTS.get(key, key)

    text = re.split(r"\n\n(?:Usage: |For more information)", messages.replace("command line: ", ""))[0]
    text = re.sub(r"--([a-z]+(?:-[a-z0-9]+)*)", name, text)
    return re.sub(r"(?<!column )\b([a-z]+_[a-z0-9_]+)(?= = )", name, text)


def in_records(text: str, name: str, file: str | None = None) -> str:
    """Return a message with arguments, and rows of a table that was written to a file, as Python names them."""
    if file is not None:
        path = re.escape(file)
        text = re.sub(rf"{path}:\d+: (?=row |header)", f"{name}: ", text)
        text = re.sub(rf"{path}:(\d+): ", lambda line: f"{name}: row {int(line[1]) - 1}: ", text)
        text = text.replace(file, name)
    text = text.replace("command line: ", "")
    return re.sub(r"--([a-z]+(?:-[a-z0-9]+)*)", lambda option: "argument " + option[1].replace("-", "_"), text)


def run(*arguments: str, may_differ: bool = False, reworded: Callable[[str], str] = str) -> tuple[bool, str]:
    """Run a command as a process of its own, which Ctrl-C ends; return whether its check passed, and what it prints."""
    command = [sys.executable, "-m", "slipmode", *arguments, "--quiet"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        output, messages = outcome(process)
    except BaseException:
        process.terminate()
        process.communicate()
        raise
    code = process.returncode
    if not (code == 1 and may_differ):
        remark(code, reworded(messages.decode()))
    return code == 0, output.decode() + (messages.decode() if code == 1 else "")


def outcome(process: subprocess.Popen[bytes]) -> tuple[bytes, bytes]:
    """Return what a process prints; Ctrl-C is at most a tick late (``communicate`` without a limit waits 0.25 s more)."""
    while True:
        try:
            return process.communicate(timeout=TICK_S)
        except subprocess.TimeoutExpired:
            pass


def remark(code: int, messages: str, warned: list[str] | None = None) -> None:
    """Raise what a command reported, and warn once of what looks wrong, or collect it."""
    lines = [line for line in messages.splitlines() if not line.startswith("in SI: ")]
    found = [line.removeprefix(WARNING) for line in lines if line.startswith(WARNING)]
    if warned is None:
        warn("\n".join(dict.fromkeys(found)))
    else:
        warned.extend(found)
    if code != 0:
        text = "\n".join(line.removeprefix("error: ") for line in lines if not line.startswith(WARNING))
        raise (CheckFailed if code == 1 else InputError)(text)


def warn(text: str) -> None:
    """Warn where the package was called, if there is a text."""
    if text:
        warnings.warn(text, SlipmodeWarning, stacklevel=caller_level())


def caller_level() -> int:
    """Return how many calls above the caller of this function the code lies that called the package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "slipmode":
        frame, level = frame.f_back, level + 1
    return level


def each(items: Sequence[T | None], work: Callable[[T, list[str]], R]) -> list[R | None]:
    """Do the work of every item, in parallel; none stays none. ``work`` collects warnings, of which one is given."""

    def one(item: T | None) -> tuple[R | None, list[str]]:
        warned: list[str] = []
        return (None if item is None else work(item, warned)), warned

    pool = ThreadPoolExecutor(max_workers=os.cpu_count())
    try:
        done = list(progress(pool.map(one, items), len(items)))
    finally:
        # Ctrl-C does not wait for the runs that have begun.
        pool.shutdown(wait=False, cancel_futures=True)
    with_warning = [(row, warned) for row, (_, warned) in enumerate(done) if warned]
    if with_warning:
        row, first = with_warning[0]
        warn(f"row {row}: {'; '.join(first)}; {len(with_warning)} of {len(items)} rows have a warning")
    return [found for found, _ in done]


def progress(items: Iterable[T], total: int) -> Iterator[T]:
    """Show a bar of tqdm next to long work, if tqdm is installed."""
    try:
        from tqdm import tqdm
    except ImportError:
        yield from items
    else:
        yield from tqdm(items, total=total, delay=1, leave=False, disable=total < 2)
