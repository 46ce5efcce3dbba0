"""Commands of the library: as functions of this process, or as processes where files are written."""

from __future__ import annotations

import json
import subprocess
import sys
import warnings
from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

from slipmode import _slipmode
from slipmode._slipmode import CheckFailed, InputError

T = TypeVar("T")
WARNING = "warning: "


class SlipmodeWarning(UserWarning):
    """A value looks like another unit's, or lies outside of the range that was tested."""


def call(*arguments: str) -> str:
    """Run a command in this process and return what it prints."""
    code, output, messages = _slipmode.call(arguments)
    remark(code, messages)
    return output.decode()


def call_json(*arguments: str) -> Any:
    """Run a command in this process and return the object that it prints."""
    return json.loads(call(*arguments, "--json"))


def run(*arguments: str, may_differ: bool = False) -> tuple[bool, str]:
    """Run a command as a process of its own, which Ctrl-C ends; return whether its check passed, and what it prints."""
    command = [sys.executable, "-m", "slipmode", *arguments, "--quiet"]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        output, messages = process.communicate()
    except BaseException:
        process.terminate()
        process.communicate()
        raise
    code = process.returncode
    if not (code == 1 and may_differ):
        remark(code, messages.decode())
    return code == 0, output.decode() + (messages.decode() if code == 1 else "")


def remark(code: int, messages: str) -> None:
    """Raise what a command reported, and warn of what looks wrong."""
    lines = [line for line in messages.splitlines() if not line.startswith("in SI: ")]
    for line in lines:
        if line.startswith(WARNING):
            warnings.warn(line.removeprefix(WARNING), SlipmodeWarning, stacklevel=caller_level())
    if code != 0:
        text = "\n".join(line.removeprefix("error: ") for line in lines if not line.startswith(WARNING))
        raise (CheckFailed if code == 1 else InputError)(text)


def caller_level() -> int:
    """Return how many calls above the caller of this function the code lies that called the package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "slipmode":
        frame, level = frame.f_back, level + 1
    return level


def progress(items: Iterable[T], total: int) -> Iterator[T]:
    """Show a bar of tqdm next to long work, if tqdm is installed."""
    try:
        from tqdm import tqdm
    except ImportError:
        yield from items
    else:
        yield from tqdm(items, total=total, delay=1, leave=False, disable=total < 2)
