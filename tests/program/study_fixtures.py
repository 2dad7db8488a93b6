# SPDX-License-Identifier: BSD-3-Clause
"""Folders of runs that have never been run, for tests of what scripts/study makes of results."""

import json

import numpy as np

UNITS = {"agitator_work": "J", "agitator_power_mean": "W", "drum_work": "J", "towel_friction_work": "J", "towel_relative_speed": "m/s",
         "towel_water_shear": "Pa", "towel_stress": "Pa", "towel_turns": "-", "towel_path": "m", "towel_rack_work": "J",
         "mat_stress": "Pa", "sock_stress": "Pa"}
PERIOD = 1.5


def write_cycles(folder, figures, cycles=4):
    """Writes cycles.csv: each figure wobbles about its mean, but for the first cycle, which is half of it."""
    names = ["cycle", "start_up", "start", "end", *figures]
    wobble = 0.01 * np.cos(np.pi * np.arange(cycles))
    wobble[1:] -= wobble[1:].sum() / max(cycles - 1, 1)
    rows = [[number + 1, int(number == 0), number * PERIOD, (number + 1) * PERIOD,
             *((0.5 if number == 0 else 1 + wobble[number]) * mean for mean in figures.values())] for number in range(cycles)]
    units = ["-", "-", "s", "s", *(UNITS[name] for name in figures)]
    lines = [",".join(names), "# " + ",".join(units), *(",".join(map(repr, map(float, row))) for row in rows)]
    (folder / "cycles.csv").write_text("\n".join(lines) + "\n")
    return np.array(rows)[1:, 4:]


def write_run(folder, status="finished", cycles=4, cloths=("towel",), **figures):
    """Writes the folder of a run with these groups of cloths and figures (its means over cycles from the second on)."""
    folder.mkdir(parents=True)
    (folder / "run.log").touch()
    rows = write_cycles(folder, figures, cycles)
    means = {name: {"mean": column.mean(), "std": column.std(ddof=1), "unit": UNITS[name]}
             for name, column in zip(figures, rows.T)} if cycles > 2 else {}
    summary = {"program": "washfsi", "case": "fixture", "status": status, "time": cycles * PERIOD, "steps": 100 * cycles,
               "wall_seconds": 12.0, "cloth_crossings": 3,
               "bodies": {name: {} for name in ("drum", "agitator", "towel_rack")},
               "cycles": {"time": PERIOD, "complete": cycles, "first": 2, "figures": means},
               "cloths": {group: {"stress_mean": 2e5, "stress_std": 1e4, "max_stretch": 1.2, "max_depth": 0.0,
                                  "tumbles": 0.5} for group in cloths}}
    (folder / "summary.json").write_text(json.dumps(summary))


def write_study(folder, designs, seeds, spread=0.02, grid=""):
    """Writes a case file and runs for each design: {name: (work, speed, stress)}; returns the files of the cases. `grid` ends the
    names of the folders of runs on a finer grid."""
    random, files = np.random.default_rng(1), []
    for name, (work, speed, stress) in designs.items():
        files.append(folder / f"{name}.opts")
        files[-1].write_text("-cloths towel\n")
        for seed in range(1, seeds + 1):
            factors = 1 + spread * random.standard_normal(4)
            place = folder / "study" / (name + grid) / (f"seed_{seed}" if seeds > 1 else "")
            write_run(place, agitator_work=work * factors[0], drum_work=0.0, towel_friction_work=0.1 * work,
                      agitator_power_mean=work / PERIOD, towel_relative_speed=speed * factors[1], towel_water_shear=3 * speed * factors[1],
                      towel_stress=stress * factors[2], towel_turns=0.5 * factors[3])
    return files
