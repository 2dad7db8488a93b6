# SPDX-License-Identifier: BSD-3-Clause
"""Runs several cases at once; an interruption or an error stops them all, each with a checkpoint."""

import signal
import subprocess
import time

from washfsi.running import line_of, start, stop
from washfsi.study.runs import ROOT


def launch(run, program, ranks):
    """Starts a run, from its checkpoint if there is one, with a log in its folder."""
    words = ["-options_file", run.file.resolve(), "-output_dir", run.folder.resolve(), *run.words]
    if run.checkpoint.is_file():
        words += ["-restart", run.checkpoint.resolve()]
    run.folder.mkdir(parents=True, exist_ok=True)
    run.record.write_text(run.options(), encoding="utf-8")
    with open(run.folder / "run.log", "a", encoding="utf-8") as log:
        return start(program, words, ranks, cwd=ROOT, stdout=log, stderr=subprocess.STDOUT)


def said_since(run, place):
    """Returns what the log says from a place on."""
    with open(run.folder / "run.log", encoding="utf-8", errors="replace") as log:
        log.seek(place)
        return log.read()


def stop_all(launchers):
    """Stops all runs; further signals wait until each has written its checkpoint."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    stop(launchers)


class Scheduler:
    """Works off a list of runs, some at a time. `ended` is called when runs have ended."""

    def __init__(self, program, ranks, jobs, ended):
        self.program, self.ranks, self.jobs, self.ended = program, ranks, jobs, ended
        self.going = []  # runs, their launchers, and where their logs begin

    def work(self, runs):
        """Runs all; returns whether all went well. What ends it early, as KeyboardInterrupt, leaves checkpoints behind."""
        waiting, well = list(runs), True
        try:
            while waiting or self.going:
                while waiting and len(self.going) < self.jobs:
                    run = waiting.pop(0)
                    print(f"study: {run.name}", flush=True)
                    log = run.folder / "run.log"
                    place = log.stat().st_size if log.is_file() else 0
                    self.going.append((run, launch(run, self.program, self.ranks), place))
                well = self.collect() and well
                time.sleep(0.05)
        except BaseException:
            stop_all([launcher for _, launcher, _ in self.going])
            raise
        return well

    def collect(self):
        """Tells of the runs that have ended; returns whether they went well."""
        over = [one for one in self.going if one[1].poll() is not None]
        self.going = [one for one in self.going if one not in over]
        for run, launcher, place in over:
            if launcher.returncode:
                why = line_of(said_since(run, place), launcher.returncode)
                print(f"study: {run.name} failed: {why}", flush=True)
            self.ended()
        return all(launcher.returncode == 0 for _, launcher, _ in over)
