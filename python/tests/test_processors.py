"""The native module runs on every processor of its architecture, and gives the same bytes there."""

import hashlib
import importlib.util
import platform
import shutil
import subprocess
import sys

import pytest
from slipmode import _slipmode

#: The roots to 3 000 digits, which GMP multiplies with its fastest routines.
ROOTS = ["roots", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s", "1e5", "-v", "1e-3"]
ROOTS += ["--digits", "3000"]
#: The package itself needs NumPy, which needs newer processors than this module.
PROGRAM = """
import hashlib, importlib.util, sys
path, *arguments = sys.argv[1:]
spec = importlib.util.spec_from_file_location("_slipmode", path)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
code, output, _ = module.call(arguments)
print(code, hashlib.sha256(output).hexdigest())
"""
EMULATOR = shutil.which("qemu-x86_64")
is_x86_64 = platform.machine() == "x86_64" and sys.platform == "linux"


def native_module() -> str:
    found = importlib.util.find_spec("slipmode._slipmode")
    assert found is not None and found.origin is not None
    return found.origin


@pytest.mark.skipif(not is_x86_64, reason="GMP chooses its routines at run time on x86-64")
def test_gmp_asks_which_processor_it_runs_on():
    # Of what the module is built from only the fat build of GMP knows CentaurHauls, the name of a maker of processors. Some compilers
    # have it as words of four letters in their instructions.
    with open(native_module(), "rb") as file:
        module = file.read()
    assert all(part in module for part in (b"Cent", b"aurH", b"auls"))


@pytest.mark.skipif(not is_x86_64 or EMULATOR is None, reason="qemu-x86_64 emulates older processors")
@pytest.mark.parametrize("processor", ["Opteron_G1", "core2duo", "Nehalem"])
def test_older_processors_give_the_same_bytes(processor):
    code, output, _ = _slipmode.call(ROOTS)
    command = [EMULATOR, "-cpu", processor, sys.executable, "-c", PROGRAM, native_module(), *ROOTS]
    found = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert found.split() == [str(code), hashlib.sha256(output).hexdigest()] and code == 0
