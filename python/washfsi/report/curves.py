# SPDX-License-Identifier: BSD-3-Clause
"""What is plotted over time: columns of the history in panels, and the balance of energy."""

import numpy as np

MOST_ROWS = 4000  # of a curve; longer ones keep their peaks


def kept(values, most=MOST_ROWS):
    """Returns the rows of a curve to draw: all, or of each of many stretches the lowest and the highest, and the ends."""
    rows = len(values)
    if rows <= most:
        return np.arange(rows)
    edges = np.linspace(0, rows, most // 2, dtype=int)
    parts = [(low, values[low:high]) for low, high in zip(edges, edges[1:])]
    return np.unique([0, rows - 1, *(low + find(part) for low, part in parts for find in (np.argmin, np.argmax))])


def integral(time, values):
    """Returns the sum of a rate over time, as the program sums it: each row stands for the interval that it ends."""
    return np.concatenate([[0.0], np.cumsum(np.diff(time) * values[1:])])


def total(history, names):
    """Returns the sum of some columns."""
    return sum((history[name] for name in names), np.zeros(history.rows))


def energy_balance(history, bodies, groups):
    """Returns the parts of the energy since the first row [J, in the plane J/m] by name: put in, kept, lost, open."""
    time = history["time"]
    powers = [name for name in [*(f"{body}_power" for body in bodies), "load_power"] if name in history]
    stores = {"kept as motion": ["kinetic_energy"],
              "kept in cloth": [f"{group}_elastic_energy" for group in groups]}
    losses = {"lost to friction": ["dissipation"], "lost to advection": ["numerical_dissipation"],
              "lost at moving walls": ["mask_dissipation"], "lost in cloth": ["cloth_dissipation"]}
    parts = {"put in": integral(time, total(history, powers))} if powers else {}
    for name, columns in stores.items():
        stored = total(history, there(history, columns))
        parts |= {name: stored - stored[0]} if there(history, columns) else {}
    for name, columns in losses.items():
        parts |= {name: integral(time, total(history, there(history, columns)))} if there(history, columns) else {}
    put_in = parts.get("put in", np.zeros(history.rows))
    spent = sum((part for name, part in parts.items() if name != "put in"), np.zeros(history.rows))
    return parts | {"open": put_in - spent}


def there(history, names):
    """Returns those of some columns that the history has."""
    return [name for name in names if name in history]


def columns_of(history, owners, ends):
    """Returns label by column for the owners' columns that end with one of some words, the first that there is."""
    found = {}
    for owner in owners:
        column = next(iter(there(history, [f"{owner}_{end}" for end in ends])), None)
        if column:
            found[column] = owner
    return found


def stress_columns(history, groups):
    """Returns label by column: the stress of each group and its two parts."""
    found = {}
    for group in groups:
        for part, name in (("", ""), ("membrane_", ", by tension"), ("bending_", ", by bending")):
            for end, way in (("stress_mean", ""), ("stress_ss_mean", " along warp"), ("stress_rr_mean", " along weft")):
                column = f"{group}_{part}{end}"
                if column in history and (part or not way):
                    found[column] = f"{group}{name}{way}"
    return found


def panels_of(history, bodies, groups):
    """Returns title, note and label by column of each panel that the history has columns for."""
    panels = [
        ("Torque on the bodies", "of water and cloth on the body; the motor supplies the opposite",
         columns_of(history, bodies, ["torque_z", "torque"])),
        ("Power of the bodies", "that the body puts into water and cloth", columns_of(history, bodies, ["power"])),
        ("Stress of the cloth", "mean over the markers at this moment", stress_columns(history, groups)),
        ("Washing action: speed of the water along the cloth", "relative to the cloth, one and a half cells away",
         columns_of(history, groups, ["relative_speed_mean"])),
        ("Washing action: shear of the water on the cloth", "viscosity times relative speed over distance",
         columns_of(history, groups, ["water_shear_mean"])),
        ("Turns of the cloths", "in the plane of radius and height, mean over the cloths",
         columns_of(history, groups, ["tumbles"])),
        ("Kinetic energy", "of water and cloth", {name: "" for name in there(history, ["kinetic_energy"])}),
        ("Passages through another cloth", "of markers, so far; only the water keeps cloths apart",
         {name: "" for name in there(history, ["cloth_crossings"])}),
        ("CFL number", "of the step", {name: "" for name in there(history, ["cfl"])}),
    ]
    return [panel for panel in panels if any(np.any(history[name]) for name in panel[2])]


class Curves:
    """The panels of a run for the page."""

    def __init__(self, results, pack):
        self.history, self.pack = results.history, pack
        self.bodies, self.groups = list(results.summary.get("bodies", {})), results.groups

    def curve(self, label, column, values):
        """Returns one curve for the page; rows that are no number are left out."""
        rows = kept(np.nan_to_num(values))
        return {"label": label, "column": column, "time": self.pack.add(self.history["time"][rows]),
                "values": self.pack.add(values[rows])}

    def energy_panel(self):
        """Returns the panel of the balance of energy, None where neither bodies nor loads can put any in."""
        parts = energy_balance(self.history, self.bodies, self.groups)
        if "put in" not in parts:  # walls drive the flow, or it runs down: nothing to balance with
            return None
        curves = [self.curve(name, "", part) for name, part in parts.items() if np.any(part)]
        unit = self.history.units.get("kinetic_energy", "J")
        return {"title": "Balance of energy", "unit": unit, "curves": curves,
                "note": "summed from the first row on; open is what is found nowhere, or passed open or moving sides"} if curves else None

    def panels(self):
        """Returns all panels: torque and power, the balance of energy, the rest."""
        made = [{"title": title, "note": note, "unit": self.history.units[next(iter(names))],
                 "curves": [self.curve(label, column, self.history[column]) for column, label in names.items()]}
                for title, note, names in panels_of(self.history, self.bodies, self.groups)]
        place = sum(panel["title"].endswith("the bodies") for panel in made)
        energy = self.energy_panel() if "kinetic_energy" in self.history else None
        return made[:place] + ([energy] if energy else []) + made[place:]


def curves_of(results, pack):
    """Returns the panels of a run, none without a history."""
    path = results.folder / "history.csv"
    return Curves(results, pack).panels() if path.is_file() and results.history.rows > 1 else []
