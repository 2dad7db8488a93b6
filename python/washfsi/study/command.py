# SPDX-License-Identifier: BSD-3-Clause
"""The command scripts/study."""

import argparse
import itertools
import os
import pathlib
import signal
import sys

from washfsi.running import find_program
from washfsi.study import refinement
from washfsi.study.runs import ROOT, all_words, case_name, runs_of, value_of
from washfsi.study.scheduler import Scheduler
from washfsi.study.tables import HEADLINES, OF_THE_CELLS, cases_of, groups_of, samples_of, write_tables
from washfsi.study.tradeoff import ACTIONS, DPI, draw_tradeoff
from washfsi.study.verdict import EXPLANATION, sentence

TITLES = {"work": "Work of the bodies in a cycle", "relative_speed": "Speed of the water along the cloth",
          "water_shear": "Shear of the water on the cloth", "stress": "Stress of the cloth", "turns": "Turns of the cloths"}


def factors_in(text):
    """Returns the factors of a list, in ascending order."""
    try:
        factors = sorted({float(word) for word in text.split(",")})
    except ValueError:
        factors = [0.0]
    if not all(1 < factor <= 10 for factor in factors):
        raise argparse.ArgumentTypeError(f"{text}: must be numbers above 1 and at most 10")
    return factors


def make_parser(description):
    """Returns the parser of the command line."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="+", type=pathlib.Path, metavar="CASE.opts")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "out" / "study", help="folder of the study")
    parser.add_argument("--seeds", type=int, help="runs of each case, each with other seeds of its cloths (default: as many "
                        "as the study's folder has, at least one)")
    parser.add_argument("--refine", type=factors_in, default=[], metavar="F[,F]", help="runs each case on finer grids too, with F times "
                        "as many cells and markers along each axis, and says which figures keep their ranking")
    parser.add_argument("--jobs", type=int, help="runs at the same time (default: cores / ranks)")
    parser.add_argument("--ranks", type=int, help="processes of each run (default: 1 with several jobs, else 2)")
    parser.add_argument("--action", choices=ACTIONS, default="relative_speed", help="washing action of study.png")
    parser.add_argument("--program", type=pathlib.Path, help="the program (default: that of the build or of the installation)")
    parser.add_argument("--table", action="store_true", help="run nothing, only look at what there is")
    return parser


def wrong_cases(options, words):
    """Returns what is wrong with the cases, nothing if all is well; `words` are options for every run."""
    names = [case_name(case, refine) for refine in (1, *options.refine) for case in options.cases]
    for case in options.cases:
        if not case.is_file():
            return f"no file {case}"
        if options.refine and value_of(all_words(case, words), "refine", "1") != "1":
            return f"{case}: --refine and -refine cannot be given together"
    twice = [name for name in names if names.count(name) > 1]
    return f"two cases are named {twice[0]}" if twice else ""


def parse_arguments(words, description):
    """Returns the command line's options, and those for every run."""
    cut = words.index("--") if "--" in words else len(words)
    parser = make_parser(description)
    options = parser.parse_args(words[:cut])
    if not options.table:
        try:
            options.program = find_program(options.program)
        except FileNotFoundError as error:
            parser.error(str(error))
    for name in ("seeds", "jobs", "ranks"):
        if getattr(options, name) is not None and getattr(options, name) < 1:
            parser.error(f"--{name} must be 1 or more")
    if told := wrong_cases(options, words[cut + 1:]):
        parser.error(told)
    return options, words[cut + 1:]


def jobs_and_ranks(options, runs):
    """Returns how many runs at a time, of how many ranks: as many as there are cores unless told otherwise."""
    cores = len(os.sched_getaffinity(0))
    jobs = options.jobs or min(max(cores // (options.ranks or 1), 1), max(runs, 1))
    return jobs, options.ranks or (1 if jobs > 1 else min(2, cores))


def samples_by_design(runs):
    """Returns the figures of each design for each of its groups of cloths, of runs on one grid; the group is None without cloth."""
    found = {}
    for mine in cases_of(runs).values():
        groups = {group: samples for group in groups_of(mine) if (samples := samples_of(mine, group))}
        found |= {mine[0].design: groups} if groups else {}
    return found


def by_refinement(runs):
    """Returns the figures of each design for each of its groups of cloths, on each grid that has any."""
    factors = sorted({run.refine for run in runs})
    grids = {factor: samples_by_design([run for run in runs if run.refine == factor]) for factor in factors}
    return {factor: designs for factor, designs in grids.items() if designs}


def by_group(designs):
    """Returns the figures of all designs that have it for each group of cloths."""
    groups = dict.fromkeys(group for mine in designs.values() for group in mine if group)
    return {group: {design: mine[group] for design, mine in designs.items() if group in mine} for group in groups}


def headline(name, designs):
    """Returns the values of a headline figure of all designs that have it, and its unit."""
    found = {design: (unit, values) for design, figures in designs.items() for (figure, unit), values in figures.items() if figure == name}
    return {design: values for design, (_, values) in found.items()}, next((unit for unit, _ in found.values()), "")


def headlines_of(grids):
    """Returns for each headline figure, the work of all bodies and those of each group, by name and title what headline() has on each
    grid."""
    grouped = {factor: by_group(designs) for factor, designs in grids.items()}
    groups = dict.fromkeys(group for mine in grouped.values() for group in mine)
    works = {factor: {design: next(iter(mine.values())) for design, mine in designs.items()} for factor, designs in grids.items()}
    told = {("work", TITLES["work"]): {factor: headline("work", designs) for factor, designs in works.items()}}
    for group, name in itertools.product(groups, HEADLINES):
        if name != "work":
            title = TITLES[name] + (f" ({group})" if len(groups) > 1 else "")
            told[name, title] = {factor: headline(name, mine.get(group, {})) for factor, mine in grouped.items()}
    return {key: found for key, every in told.items() if (found := {factor: one for factor, one in every.items() if one[0]})}


def sentences(figures, factors):
    """Returns a sentence for each headline figure on each grid."""
    return [sentence(title + (f", cells x {factor:g}" if len(factors) > 1 else ""), *found[factor])
            for factor in factors for (_, title), found in figures.items() if factor in found]


def on_finer_grids(figures):
    """Returns the table of estimates and the sentences on the ranking, of studies on several grids."""
    rows, lines = [], []
    for (name, title), found in figures.items():
        designs = {}
        for factor, (samples, unit) in found.items():
            for design, values in samples.items():
                designs.setdefault(design, {})[factor] = values
        if name not in OF_THE_CELLS:
            rows += refinement.estimate_rows(title, unit, designs)
        if len(found) > 1:
            lines.append(refinement.ranking(title, [found[factor][0] for factor in sorted(found)[-2:]]))
    return (refinement.table(rows) if rows else ""), lines


def doubts(runs):
    """Returns a line for each design of whose runs something fails: the sentences stand on that."""
    lines = []
    for case, mine in cases_of(runs).items():
        found = dict(finding for run in mine for finding in run.failures())
        if found:
            told = "; ".join(f"{name}, {text}" for name, text in found.items())
            lines.append(f"{case} is not to be believed: {told}.")
    return lines


def draw(designs, options):
    """Writes study.png if there is anything to draw."""
    groups = {group: mine for group, mine in by_group(designs).items() if headline(options.action, mine)[0]}
    if not groups:
        return
    seeds = min(len(values) for designs in groups.values() for figures in designs.values() for values in figures.values())
    figure, _ = draw_tradeoff(groups, seeds, options.action)
    figure.savefig(options.output / "study.png", dpi=DPI)
    print(options.output / "study.png")


def report(runs, options, last=True):
    """Writes the tables and, when all has been run, what can be decided; prints it."""
    table = write_tables(runs, options.output)
    grids = by_refinement(runs)
    figures = headlines_of(grids)
    estimates, rankings = on_finer_grids(figures)
    lines = [told for run in runs if (told := run.outdated())] + doubts(runs)
    lines += sentences(figures, list(grids)) or ["No finished run has figures of agitation cycles, so there is nothing to decide."]
    text = table + "\n" + "\n".join(f"- {line}" for line in lines) + "\n\n" + EXPLANATION
    if estimates:
        text += "\n## On finer grids\n\n" + "\n".join([estimates, *(f"- {line}" for line in rankings), "", refinement.EXPLANATION])
    (options.output / "study.md").write_text(text, encoding="utf-8")
    if last:
        print("\n".join([table, *lines, *(["", estimates] if estimates else []), *rankings]))
        if grids:
            draw(grids[max(grids)], options)


def raise_interrupt(*_):
    """Treats SIGTERM as Ctrl-C."""
    raise KeyboardInterrupt


def unfinished(runs):
    """Returns the runs that have not finished, and those of them that cannot go on because their case has changed; tells of the others."""
    waiting, stuck = [], []
    for run in runs:
        if run.status() == "finished":
            print(f"study: {run.name} has finished before", flush=True)
        elif told := run.outdated():
            print(f"study: {told}", flush=True)
            stuck.append(run)
        else:
            waiting.append(run)
    return waiting, stuck


def run_all(runs, options):
    """Runs what has not finished; returns the exit status."""
    waiting, stuck = unfinished(runs)
    jobs, ranks = jobs_and_ranks(options, len(waiting))
    scheduler = Scheduler(options.program, ranks, jobs, lambda: report(runs, options, last=False))
    try:
        return 0 if scheduler.work(waiting) and not stuck else 1
    except KeyboardInterrupt:
        print("study: interrupted; the same command goes on", flush=True)
        return 130


def main(description):
    """Runs the study and reports."""
    options, words = parse_arguments(sys.argv[1:], description)
    signal.signal(signal.SIGTERM, raise_interrupt)
    try:
        runs = runs_of(options.cases, options.output, options.seeds, words, options.refine)
    except ValueError as error:
        print(f"study: {error}", file=sys.stderr)
        return 2
    status = 0 if options.table else run_all(runs, options)
    report(runs, options)
    return status
