# SPDX-License-Identifier: BSD-3-Clause
"""The figures of a run: per cycle with mean and spread, of the whole run, and the headlines."""

from washfsi.study.tables import owner_of

MACHINE = "machine"
LABELS = {  # of figures per cycle, without the name of their body or group
    "cfl": "largest CFL number", "kinetic_energy_change": "kinetic energy kept", "dissipated": "lost to friction",
    "advection_dissipated": "numerical dissipation", "mask_dissipated": "lost at moving walls",
    "cloth_dissipated": "lost in cloth and coupling", "load_work": "work of weight and loads",
    "cloth_slip": "slip of the cloth",
    "cloth_crossings": "passages through another cloth", "energy_open": "energy-balance residual", "work": "work",
    "power_mean": "power, mean", "power_peak": "power, peak", "power_rms": "power, rms", "torque_mean": "torque, mean",
    "torque_peak": "torque, peak", "torque_rms": "torque, rms", "elastic_energy_change": "elastic energy kept",
    "stress": "stress", "relative_speed": "speed of the water along it", "water_shear": "shear of the water on it",
    "stretch": "largest stretch", "depth": "depth in bodies", "turns": "turns of a cloth", "path": "path of a cloth",
}
OF_THE_RUN = {  # of summary.json's cloths: name, label, unit; those with _mean have a _std over the markers
    "stress": ("stress", "Pa"), "stress_ss": ("stress along warp", "Pa"), "stress_rr": ("stress along weft", "Pa"),
    "stress_sr": ("stress of shear", "Pa"), "relative_speed": ("speed of the water along it", "m/s"),
    "water_shear": ("shear of the water on it", "Pa"), "stretch": ("stretch", "-"), "curvature": ("curvature", "1/m"),
    "shear_angle": ("shear angle", "rad"),
}
LARGEST = {"max_stretch": ("largest stretch", "-"), "max_depth": ("deepest marker in a body", "m"),
           "tumbles": ("turns of a cloth", "-"), "path": ("path of a cloth", "m")}
OF_BODIES = ("work", "torque_peak")
HEADLINES = [("work", "Work in a cycle"), ("torque_peak", "Peak torque"), ("stress", "Stress of the cloth"),
             ("relative_speed", "Water along the cloth"), ("water_shear", "Shear on the cloth"),
             ("turns", "Turns of a cloth in a cycle")]


def label_of(rest):
    """Returns a figure's name for people."""
    return LABELS.get(rest, rest.replace("_", " "))


def cycle_figures(results):
    """Returns the figures of the cycles, by machine, body and group: a value for each cycle, mean and spread of the later
    ones as summary.json has them."""
    path = results.folder / "cycles.csv"
    cycles = results.cycles if path.is_file() else None
    if not cycles or not cycles.rows:
        return None
    summary = results.summary
    owners = [*summary.get("bodies", {}), *results.groups]
    means = summary.get("cycles", {}).get("figures", {})
    figures = []
    for name in list(cycles)[4:]:
        owner, rest = owner_of(name, owners)
        mean = means.get(name, {})
        figures.append({"name": name, "owner": owner or MACHINE, "rest": rest, "label": label_of(rest), "unit": cycles.units[name],
                        "values": list(map(float, cycles[name])), "mean": mean.get("mean"), "std": mean.get("std")})
    order = [MACHINE, *owners]
    return {"numbers": list(map(int, cycles["cycle"])), "start_up": list(map(bool, cycles["start_up"])),
            "starts": list(map(float, cycles["start"])), "ends": list(map(float, cycles["end"])),
            "figures": sorted(figures, key=lambda figure: order.index(figure["owner"]))}


def cloth_figures(summary):
    """Returns the figures of the groups over the run: mean over the markers of their averages in time, and spread."""
    rows = []
    for group, cloth in summary.get("cloths", {}).items():
        means = [(f"{name}_mean", f"{name}_std", *told) for name, told in OF_THE_RUN.items()]
        for name, spread, label, unit in [*means, *((name, None, *told) for name, told in LARGEST.items())]:
            if cloth.get(name) is not None:
                rows.append({"owner": group, "label": label, "unit": unit, "value": cloth[name],
                             "std": cloth.get(spread), "path": ["cloths", group, name]})
    return rows


def body_figures(summary, plane):
    """Returns force, torque and power of the bodies in the last step."""
    rows, depth = [], "/m" if plane else ""
    for body, loads in summary.get("bodies", {}).items():
        parts = [("force", axis, place, f"N{depth}") for place, axis in enumerate("xyz"[:len(loads["force"])])]
        torque = loads["torque"]
        parts += ([("torque", axis, place, "N m") for place, axis in enumerate("xyz")] if isinstance(torque, list) else
                  [("torque", "", None, f"N m{depth}")])
        for name, axis, place, unit in parts:
            value = loads[name] if place is None else loads[name][place]
            rows.append({"owner": body, "label": f"{name} {axis}".strip(), "unit": unit, "value": value, "std": None,
                         "path": ["bodies", body, name, *([] if place is None else [place])]})
        rows.append({"owner": body, "label": "power", "unit": f"W{depth}", "value": loads["power"], "std": None,
                     "path": ["bodies", body, "power"]})
    return rows


def run_figures(summary):
    """Returns what the run took."""
    told = {"steps": ("steps", "-"), "time": ("simulated time", "s"), "wall_seconds": ("wall time", "s"),
            "seconds_per_step": ("wall time of a step", "s"), "max_divergence": ("largest divergence", "1/s"),
            "max_cfl": ("largest CFL number", "-"), "peak_memory_bytes": ("memory", "B"),
            "cloth_crossings": ("passages through another cloth", "-")}
    rows = [{"owner": "run", "label": label, "unit": unit, "value": summary[name], "std": None, "path": [name]}
            for name, (label, unit) in told.items() if summary.get(name) is not None]
    return rows + [{"owner": "run", "label": f"iterations, {name}", "unit": "-", "value": count, "std": None,
                    "path": ["iterations", name]} for name, count in summary.get("iterations", {}).items()]


def value_of(figure):
    """Returns what a figure is at best: mean and spread from the second cycle on, else the value of the first alone."""
    if figure["mean"] is not None:
        return {"value": figure["mean"], "std": figure["std"], "first": False, "note": "mean of a cycle, from the second on"}
    return {"value": figure["values"][-1], "std": None, "first": True, "note": "first cycle alone: start-up, no spread"}


def figure_rows(runs):
    """Returns the rows of a table of several runs: owner, label, unit, and for each run the figure or None."""
    rows = {}
    for place, run in enumerate(runs):
        for figure in (run["cycles"] or {"figures": []})["figures"]:
            key = (figure["owner"], figure["rest"], figure["label"], figure["unit"])
            rows.setdefault(key, [None] * len(runs))[place] = value_of(figure)
    return [{"owner": owner, "rest": rest, "label": label, "unit": unit, "values": values}
            for (owner, rest, label, unit), values in rows.items()]


def headlines(cycles):
    """Returns the figures that tell most: of the body with the largest one, of each group of cloths; none that is zero."""
    found = []
    for rest, title in HEADLINES if cycles else []:
        mine = [figure for figure in cycles["figures"] if figure["rest"] == rest and any(figure["values"])]
        if rest in OF_BODIES:
            mine = sorted(mine, key=lambda figure: -abs(value_of(figure)["value"]))[:1]
        found += [value_of(figure) | {"title": title} | {name: figure[name] for name in ("owner", "unit", "name")}
                  for figure in mine]
    return found
