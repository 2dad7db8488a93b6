# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that read results need. A run does not, so in the sources it is installed when the first of them is called."""

import importlib.util
import pathlib
import subprocess
import sys

INSTALL = pathlib.Path(__file__).resolve().parent / "install-dependencies"
MODULES = ("numpy", "h5py", "matplotlib")
LIBRARIES = ("three/three.min.js", "chart.js/chart.min.js")


def missing_modules():
    """Returns the Python modules that are not there."""
    return [name for name in MODULES if importlib.util.find_spec(name) is None]


def install_missing():
    """Installs what is missing by apt; ends with one line where Python's modules are missing still."""
    complete = not missing_modules() and all((pathlib.Path("/usr/share/javascript") / name).is_file() for name in LIBRARIES)
    if not complete and INSTALL.is_file():
        subprocess.run([INSTALL, "--results"], stdout=sys.stderr, check=False)
        importlib.invalidate_caches()
    if missing_modules():
        sys.exit(f"washfsi: results need Python's {', '.join(missing_modules())}: install Debian's python3-h5py and python3-matplotlib")
