# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a study: each case with each seed."""

import pathlib
import re
from dataclasses import dataclass, field

from washfsi.errors import ResultsError
from washfsi.options_file import quoted, words_of_line
from washfsi.results import Results
from washfsi.running import HERE

# The working directory of all runs: the source's root, or, where washfsi is installed, the folder in which the command is
# called. File names in options behind -- are relative to it.
ROOT = HERE.parents[2] if (HERE.parents[2] / "CMakeLists.txt").is_file() else pathlib.Path.cwd()


@dataclass
class Run:
    """One run of a case. Seed 1 is that of the case itself; seed n adds n - 1 to the seed of every group."""

    case: str  # its name, that of the folder too
    file: pathlib.Path
    folder: pathlib.Path
    seed: int = 1
    words: list = field(default_factory=list)  # further options
    refine: float = 1.0  # so many times the cells and markers of the case along each axis

    @property
    def name(self):
        """Returns the run's name in messages."""
        return str(self.folder.name if self.folder.name == self.case else f"{self.case}/{self.folder.name}")

    @property
    def design(self):
        """Returns the case's name on any grid."""
        return self.file.stem

    @property
    def record(self):
        """Returns the file that keeps the options of the run."""
        return self.folder / "study.opts"

    @property
    def checkpoint(self):
        """Returns the file that an unfinished run goes on from."""
        return self.folder / "checkpoint.h5"

    def options(self):
        """Returns all options of the run as it would be started now, in a text."""
        words = all_words(self.file, self.words)
        return "".join(("\n" if re.match("--?[A-Za-z]", word) else " ") + quoted(word) for word in words).strip() + "\n"

    def changed(self):
        """Returns whether the run was made with other options than it would be now."""
        return self.record.is_file() and words_in(self.record) != all_words(self.file, self.words)

    def outdated(self):
        """Returns a sentence on a run whose results are those of other options than it would be started with now; else nothing."""
        finished = self.status() == "finished"
        if not (finished or self.checkpoint.is_file()) or not self.changed():
            return ""
        return f"{self.name} was {'run' if finished else 'begun'} with other options than it has now; delete {self.folder} to run it anew."

    def summary(self):
        """Returns the run's summary, empty if there is none."""
        try:
            return Results(self.folder).summary
        except ResultsError:
            return {}

    def status(self):
        """Returns how far the run is, in a word or two."""
        started = (self.folder / "run.log").is_file()
        return self.summary().get("status", "unfinished" if started else "not run")

    def failures(self):
        """Returns what fails of how far the run is to be believed: (name, what was found)."""
        trust = self.summary().get("trust", {})
        return [(finding["name"], finding["found"]) for part in ("start", "end") for finding in trust.get(part, [])
                if finding["verdict"] == "fail"]

    def figures(self):
        """Returns the figures of its agitation cycles by name: (mean over cycles, standard deviation over cycles, unit)."""
        figures = self.summary().get("cycles", {}).get("figures", {})
        return {name: (figure["mean"], figure["std"], figure["unit"]) for name, figure in figures.items()
                if figure["mean"] is not None}


def words_in(file, seen=()):
    """Returns the words of an options file, those of the files that it names included."""
    path = file.resolve()
    if path in seen or not path.is_file():
        return []
    words = [word for line in path.read_text(encoding="utf-8").splitlines() for word in words_of_line(line)]
    return with_files(words, path.parent, (*seen, path))


def with_files(words, folder, seen=()):
    """Returns words of options, those of the files that -options_file names, seen from a folder, in its place."""
    every, rest = [], iter(words)
    for word in rest:
        if word == "-options_file":
            every += words_in(folder / next(rest, ""), seen)
        else:
            every.append(word)
    return every


def all_words(file, words):
    """Returns the words of a case and of further options, those of the files that they name included."""
    return words_in(file) + with_files(words, ROOT)


def value_of(words, name, default):
    """Returns the last value that an option is given, in letters of any case."""
    values = [value for option, value in zip(words, words[1:]) if option[:1] == "-" and option.lstrip("-").lower() == name.lower()]
    return values[-1] if values else default


def seed_of(words, group):
    """Returns the seed of a group of cloths. Raises ValueError where it is no whole number."""
    text = value_of(words, f"{group}_seed", value_of(words, "cloths_seed", "1"))
    try:
        return int(text)
    except ValueError:
        raise ValueError(f"the seed of {group}, {text}, is not a whole number") from None


def seed_words(file, words, seed):
    """Returns the options that change the seed of every group of cloths."""
    if seed == 1:
        return []
    every = all_words(file, words)
    groups = [group for group in value_of(every, "cloths", "").split(",") if group]
    return [word for group in groups for word in (f"-{group}_seed", str(seed_of(every, group) + seed - 1))]


def seeds_there(folder):
    """Returns the number of seeds that a case's folder has been run with."""
    return max([int(path.name[5:]) for path in folder.glob("seed_*") if path.name[5:].isdigit()], default=1)


def folder_of(case_folder, seed, seeds):
    """Returns a run's folder. One seed alone needs none of its own; and what has been run either way remains seed 1."""
    own = case_folder / f"seed_{seed}"
    alone = seed == 1 and not own.is_dir() and (seeds == 1 or (case_folder / "run.log").is_file())
    return case_folder if alone else own


def case_name(file, refine):
    """Returns the name of a case on a grid."""
    return file.stem if refine == 1 else f"{file.stem}_refined_{refine:g}"


def runs_of(files, output, seeds, words, refinements=()):
    """Returns all runs of a study: the first seed of every case, then the second, and so on; then the same on each finer grid."""
    runs = []
    for refine in (1.0, *refinements):
        counts = {file: seeds or seeds_there(output / case_name(file, refine)) for file in files}
        finer = [] if refine == 1 else ["-refine", f"{refine:g}"]
        runs += [Run(case_name(file, refine), file, folder_of(output / case_name(file, refine), seed, counts[file]), seed,
                     [*words, *finer, *seed_words(file, words, seed)], refine)
                 for seed in range(1, max(counts.values()) + 1) for file in files if seed <= counts[file]]
    return runs
