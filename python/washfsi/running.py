# SPDX-License-Identifier: BSD-3-Clause
"""Starting and stopping runs."""

import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time

from washfsi.errors import RunError
from washfsi.results import Results

HERE = pathlib.Path(__file__).resolve()


def find_program(program=None):
    """Returns the program: the one given, that of WASHFSI_PROGRAM, of the build, of the installation, or in PATH."""
    given = program or os.environ.get("WASHFSI_PROGRAM")
    places = [pathlib.Path(given)] if given else [HERE.parents[2] / "build" / "bin" / "washfsi",
                                                  HERE.parents[4] / "bin" / "washfsi"]
    for place in places:
        if place.is_file():
            return place.resolve()
    if given:
        raise FileNotFoundError(f"no program {given}")
    found = shutil.which("washfsi")
    if not found:
        raise FileNotFoundError("no program washfsi: build it, or give its place as `program` or in WASHFSI_PROGRAM")
    return pathlib.Path(found)


def words_of(options):
    """Returns options, a dictionary, as words of a command line."""
    words = []
    for name, value in options.items():
        words.append("-" + name.lstrip("-"))
        if isinstance(value, bool):
            words.append("true" if value else "false")
        elif isinstance(value, (list, tuple)):
            words.append(",".join(map(str, value)))
        elif value is not None:
            words.append(str(value))
    return words


def start(program, words, ranks, **streams):
    """Starts the program on some ranks, in a session of its own so that Ctrl-C does not reach it."""
    command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks), str(program), *map(str, words)]
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")
    environment.setdefault("OMPI_MCA_mpi_yield_when_idle", "1")
    return subprocess.Popen(command, env=environment, start_new_session=True, **streams)


def children(launcher):
    """Returns the processes that a launcher has started."""
    found = set()
    try:
        for thread in pathlib.Path(f"/proc/{launcher.pid}/task").iterdir():
            found |= set(map(int, (thread / "children").read_text().split()))
    except OSError:  # it has ended
        pass
    return found


def stop(launchers):
    """Tells the ranks of some runs to end and waits: each finishes its step and writes a checkpoint. mpirun, told
    itself, would not wait for them."""
    told = set()
    while any([launcher.poll() is None for launcher in launchers]):
        for rank in set().union(*map(children, launchers)) - told:
            told.add(rank)
            try:
                os.kill(rank, signal.SIGTERM)
            except ProcessLookupError:
                pass
        time.sleep(0.05)


def line_of(text, status):
    """Returns the line in which the program tells why it failed."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    own = [line for line in lines if line.startswith("washfsi: ")]
    other = [line for line in lines if not line.startswith("---")]
    return (own or other or [f"washfsi ended with status {status}"])[0]


def run(case, output, options=None, ranks=1, program=None):
    """Runs a case and returns its results.

    case     options file; None: the options alone make the case
    output   folder of the results
    options  dictionary of further options: numbers, texts, lists, True or False, None for no value
    ranks    number of processes
    Raises RunError, with the program's line, when the run fails.
    """
    words = (["-options_file", case] if case else []) + ["-output_dir", output] + words_of(options or {})
    with tempfile.TemporaryFile("w+") as complaints:
        launcher = start(find_program(program), words, ranks, stdout=subprocess.DEVNULL, stderr=complaints)
        try:
            status = launcher.wait()
        except BaseException:
            stop([launcher])
            raise
        if status:
            complaints.seek(0)
            raise RunError(line_of(complaints.read(), status), status)
    return Results(output)
