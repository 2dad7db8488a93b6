# SPDX-License-Identifier: BSD-3-Clause
"""The tables of a study: runs.csv, a row per run and group of cloths; study.csv, a row per case and group, means over seeds."""

import csv
import statistics

STRESSES = ("stress_ss", "stress_rr", "stress_sr", "stress")
MEASURES = ("max_stretch", "max_depth", "tumbles")
START = ["case", "status", "time_s", "steps", "wall_seconds", "group"]
SUMMARY = [*(f"{stress}_{what}_MPa" for stress in STRESSES for what in ("mean", "std")), *MEASURES, "crossings"]
OF_THE_CELLS = ("relative_speed", "water_shear")  # taken 1.5 cells from the cloth: on finer grids they are another figure
HEADLINES = ("work", "relative_speed", "water_shear", "stress", "turns")  # figures in study.md


def owner_of(name, owners):
    """Returns the body or group of cloths that a figure belongs to, None for one of the machine, and the rest of its name."""
    mine = max((owner for owner in owners if name.startswith(f"{owner}_")), key=len, default=None)
    return (mine, name[len(mine) + 1:]) if mine else (None, name)


def total_work(figures, bodies):
    """Returns the work of all bodies in a cycle, None where none has a work: (mean, unit)."""
    works = [figures[f"{body}_work"] for body in bodies if f"{body}_work" in figures]
    return (sum(work[0] for work in works), works[0][2]) if works else None


def figures_of(run, group):
    """Returns the figures of a run that concern a group or the machine: by name (mean over cycles, std, unit). `work` is
    that of all bodies."""
    figures, groups, bodies = run.figures(), run.summary().get("cloths", {}), run.summary().get("bodies", {})
    work = total_work(figures, bodies)
    mine = {"work": (work[0], None, work[1])} if work else {}
    for name, figure in figures.items():
        owner, rest = owner_of(name, [*bodies, *groups])
        if owner not in groups:
            mine[name] = figure
        elif owner == group:
            mine[rest] = figure
    return mine


def summary_row(run, group):
    """Returns the numbers of a run's summary for one group."""
    summary = run.summary()
    row = {"time_s": summary["time"], "steps": summary["steps"], "wall_seconds": summary["wall_seconds"],
           "crossings": summary.get("cloth_crossings")}
    cloth = summary.get("cloths", {}).get(group, {})
    for stress in STRESSES:
        for what in ("mean", "std"):
            value = cloth.get(f"{stress}_{what}")
            row[f"{stress}_{what}_MPa"] = None if value is None else 1e-6 * value
    return row | {measure: cloth.get(measure) for measure in MEASURES}


def groups_of(runs):
    """Returns the groups of cloths of a case's runs; [None] if there are none."""
    return next((list(run.summary()["cloths"]) for run in runs if run.summary().get("cloths")), [None])


def status_of(runs):
    """Returns the status of a case: that of its runs, or how many have finished."""
    states = [run.status() for run in runs]
    return states[0] if len(set(states)) == 1 else f"{states.count('finished')} of {len(states)} finished"


def run_rows(run):
    """Returns the rows of one run in runs.csv."""
    start = {"case": run.case, "seed": run.seed, "status": run.status()}
    if not run.summary():
        return [start]
    rows = []
    for group in groups_of([run]):
        row = start | summary_row(run, group) | {"group": group, "cycles": run.summary().get("cycles", {}).get("complete")}
        for name, (mean, std, unit) in figures_of(run, group).items():
            row |= {f"{name} [{unit}]": mean, f"{name} std [{unit}]": std}
        rows.append(row)
    return rows


def samples_of(runs, group):
    """Returns the figures of the finished runs of a case: by name and unit, a value for each seed."""
    samples = {}
    for run in runs:
        if run.status() == "finished":
            for name, (mean, _, unit) in figures_of(run, group).items():
                samples.setdefault((name, unit), []).append(mean)
    return samples


def spread(values):
    """Returns the standard deviation over seeds, None with one seed."""
    return statistics.stdev(values) if len(values) > 1 else None


def case_rows(case, runs):
    """Returns the rows of one case in study.csv: means over its finished runs; where there are none, how far the others are."""
    start = {"case": case, "status": status_of(runs), "seeds": sum(run.status() == "finished" for run in runs)}
    rows, begun = [], [run for run in runs if run.summary()]
    counted = [run for run in begun if run.status() == "finished"] or begun
    for group in groups_of(runs) if begun else []:
        row, numbers = start | {"group": group}, [summary_row(run, group) for run in counted]
        for name in numbers[0]:
            values = [number[name] for number in numbers if number[name] is not None]
            row[name] = statistics.fmean(values) if values else None
        for (name, unit), values in samples_of(runs, group).items():
            row |= {f"{name} [{unit}]": statistics.fmean(values), f"{name} spread [{unit}]": spread(values)}
        rows.append(row)
    return rows or [start]


def text_of(value):
    """Returns a number with four digits, a text as it is."""
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def figure_columns(rows, known):
    """Returns the columns of figures that the rows have, in their order."""
    return list(dict.fromkeys(name for row in rows for name in row if name not in known))


def write_csv(path, first, rows):
    """Writes a table with the columns `first`, then those of the figures."""
    columns = [*first, *figure_columns(rows, first)]
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()}
                         for row in rows)


def markdown(rows):
    """Returns the table of the headlines of all cases."""
    figures = [name for headline in HEADLINES for name in figure_columns(rows, START)
               if name.startswith(f"{headline} [")]
    others = [name for name in ("stress_mean_MPa", *MEASURES, "crossings") if any(row.get(name) is not None for row in rows)]
    columns = ["case", "status", "time_s", "group", "seeds", *figures, *others]
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    for row in rows:
        cells = [text_of(row.get(name)) for name in columns]
        for place, name in enumerate(columns):
            width = row.get(name.replace(" [", " spread ["))
            if name in figures and width is not None:
                cells[place] += f" ± {width:.2g}"
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def cases_of(runs):
    """Returns the runs of each case by its name."""
    cases = {}
    for run in runs:
        cases.setdefault(run.case, []).append(run)
    return cases


def write_tables(runs, output):
    """Writes runs.csv and study.csv; returns the table of headlines in Markdown."""
    output.mkdir(parents=True, exist_ok=True)
    cases = cases_of(runs)
    first = [*START, "seeds", *SUMMARY]
    rows = [row for case, mine in cases.items() for row in case_rows(case, mine)]
    write_csv(output / "study.csv", first, rows)
    write_csv(output / "runs.csv", ["case", "seed", *START[1:], *SUMMARY, "cycles"],
              [row for mine in cases.values() for run in mine for row in run_rows(run)])
    return markdown(rows)
