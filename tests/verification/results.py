# SPDX-License-Identifier: BSD-3-Clause
"""Results of runs of the program, kept so that a long table can be interrupted and taken up again.

With WASHFSI_RESULTS naming a folder, each run has a folder of its own there. A run that has finished is not made again, one
that was interrupted goes on from its checkpoint; fields of a finished one are removed. What a run depends on (the program's sources, the options, the files that
they name) is part of its folder's name, so a change of any of it makes the run anew. Without WASHFSI_RESULTS results last as
long as the script that made them.
"""

import atexit
import functools
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
from typing import NamedTuple

import numpy as np

from tables import command, git, read_columns, support

FINISHED = "finished.json"
FIELDS = ("flow", "slices", "surfaces")  # large, and no table reads them


class Unfinished(Exception):
    """A run that was stopped since it would take too long. It can go on from its checkpoint."""

    def __init__(self, seconds, ranks=1):
        super().__init__(f"would take some {seconds / 60:.3g} minutes")
        self.seconds, self.ranks = seconds, ranks


class Result(NamedTuple):
    """What a run left behind."""
    folder: pathlib.Path
    seconds: float
    failed: bool  # the program ended with an error


@functools.cache
def root():
    """The folder of all results."""
    if "WASHFSI_RESULTS" in os.environ:
        return pathlib.Path(os.environ["WASHFSI_RESULTS"]).absolute()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="washfsi_"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


@functools.cache
def program_identity():
    """The commit that last changed the program's sources; the program itself where there is none, or they are changed."""
    sources = ("--", ":/lib", ":/apps")
    if (commit := git("log", "-1", "--format=%h", *sources)) and not git("status", "--porcelain", *sources):
        return commit
    return hashlib.sha256(support.PROGRAM.read_bytes()).hexdigest()


def contents(path):
    """What an options file says, and those that it names."""
    text = path.read_text(encoding="utf-8")
    named = [line.split()[1] for line in text.splitlines() if line.startswith("-options_file")]
    return [text, *(words for name in named for words in contents(path.parent / name))]


def place(ranks, options):
    """The folder of a run."""
    words = [str(option).replace(str(support.SOURCE), "") for option in options]
    files = [option for option in options if isinstance(option, pathlib.Path) and option.suffix == ".opts"]
    everything = [program_identity(), ranks, words, [contents(path) for path in files]]
    key = hashlib.sha256(json.dumps(everything).encode()).hexdigest()[:12]
    return root() / "-".join([*(path.stem for path in files[:1]), key])


def spent(folder):
    """Seconds that attempts before this one took, by when they last wrote a row."""
    attempts = folder / "attempts.json"
    if not attempts.is_file() or not (folder / "history.csv").is_file():
        return 0
    begun, before = json.loads(attempts.read_text())
    return before + max(0, (folder / "history.csv").stat().st_mtime - begun)


def wait_for(process, folder, ranks):
    """The status of a run; asks for a checkpoint and raises Unfinished where it would take longer than it may."""
    while True:
        try:
            return process.wait(PROBE if math.isfinite(LONGEST["run"]) else None)
        except subprocess.TimeoutExpired as late:
            if (seconds := expected_seconds(folder)) <= LONGEST["run"]:
                continue
            process.terminate()
            process.wait()
            LATE[folder] = Unfinished(seconds, ranks)
            raise LATE[folder] from late


def expected_seconds(folder):
    """How long a run takes as a whole, by how far it has come; as long as it has taken if that is not known."""
    history, options = folder / "history.csv", folder / "resolved.opts"
    ends = re.findall(r"^-time_end (\S+)", options.read_text(encoding="utf-8"), re.M) if options.is_file() else []
    has_rows = history.is_file() and len(history.read_text(encoding="utf-8").splitlines()) > 2
    times = read_columns(history)["time"] if has_rows else np.empty(0)
    return spent(folder) * max(1, float(ends[-1]) / times[-1]) if ends and times.size and times[-1] > 0 else spent(folder)


PROBE = 60  # seconds between looks at a run
LONGEST = {"run": math.inf}  # seconds that a run may take as a whole
LATE = {}  # what was raised of runs that took longer, by folder: they do not go on before the next time
USED = {}  # seconds of the runs that have been asked for since `timed` began, by folder


def run(ranks, *options, may_fail=False, earlier=None):
    """Runs the program with options, or finds the results of that. Fails with the program, unless it may fail.

    `earlier`: the result of a run to an earlier `-time_end`, to go on from.
    """
    folder = place(ranks, options)
    if earlier and not folder.exists():
        shutil.copytree(earlier.folder, folder, ignore=shutil.ignore_patterns(FINISHED))
    if folder in LATE:
        raise LATE[folder]
    if not (folder / FINISHED).is_file():
        make(folder, ranks, options, may_fail)
    finished = json.loads((folder / FINISHED).read_text())
    USED[folder] = finished["seconds"]
    return Result(folder, finished["seconds"], finished["failed"])


def make(folder, ranks, options, may_fail):
    """Runs the program from the start, or from the checkpoint of a run that was interrupted."""
    folder.mkdir(parents=True, exist_ok=True)
    before, begun = spent(folder), time.time()
    (folder / "attempts.json").write_text(json.dumps([begun, before]))
    checkpoint = folder / "checkpoint.h5"
    line = command(ranks, *options, *(["-restart", checkpoint] if checkpoint.is_file() else []), "-output_dir", folder)
    with open(folder / "output.txt", "a", encoding="utf-8") as output:
        status = wait_for(subprocess.Popen(line, stdout=output, stderr=subprocess.STDOUT), folder, ranks)
    if status and not may_fail:
        raise subprocess.CalledProcessError(status, line)
    finished = {"seconds": before + time.time() - begun, "failed": status != 0, "command": " ".join(line)}
    for name in FIELDS:
        shutil.rmtree(folder / name, ignore_errors=True)
    (folder / FINISHED).write_text(json.dumps(finished, indent=1))


def timed(measure):
    """What a measurement returns, and how many seconds its runs took, those that were made before too."""
    USED.clear()
    value = measure()
    return value, sum(USED.values())
