# SPDX-License-Identifier: BSD-3-Clause
"""Phase averages in the plane of radius and height: a row for each phase, with velocity, turbulence and dissipation."""

import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure

from washfsi.plot.style import OUTLINE_COLOR, SOLID_COLOR, WIDTH, wrapped

ARROWS = 18  # along the longer side of the plane
LEAST_SHARE = 0.05  # of liquid in a bin that is drawn
DECADES = 3  # of the dissipation that are shown


def edges(middles):
    """Returns the ends of bins of equal width."""
    width = middles[1] - middles[0] if len(middles) > 1 else 2 * abs(middles[0]) or 1.0
    return np.append(middles - 0.5 * width, middles[-1] + 0.5 * width)


def limit_of(field):
    """Returns where colours saturate: a percentile of the sizes, so that single bins do not decide."""
    sizes = np.abs(field[np.isfinite(field)])
    return float(np.percentile(sizes, 99.5)) or 1.0 if sizes.size else 1.0


def panels_of(phases):
    """Returns the three columns: a title, the field, its colours and their range."""
    wet = np.where(phases["liquid_share"] >= LEAST_SHARE, 1.0, np.nan)
    turning, energy = wet * phases["mean/u_theta"], wet * phases["turbulence_energy"]
    lost = wet * (phases["dissipation"] + phases["model_dissipation"])
    swirl, most = limit_of(turning), limit_of(lost)
    return [("$u_\\theta$ [m/s], arrows $u_r$, $u_z$", turning, "RdBu_r", Normalize(-swirl, swirl)),
            ("turbulence energy [m$^2$/s$^2$]", energy, "viridis", Normalize(0, limit_of(energy))),
            ("dissipation [m$^2$/s$^3$]", lost, "magma", LogNorm(most / 10**DECADES, most))]


def every_few(middles, way):
    """Returns which bins have an arrow, about one each `way` [m]."""
    every = max(1, round(way / (middles[1] - middles[0]))) if len(middles) > 1 else 1
    return slice(every // 2, None, every)


def draw_arrows(axes, phases, phase, wet, fastest):
    """Draws the velocity in the plane, every few bins; `fastest` [m/s] is as long as the way to the next but one."""
    way = max(np.ptp(phases["r"]), np.ptp(phases["z"])) / ARROWS or 1.0
    some = (every_few(phases["z"], way), every_few(phases["r"], way))
    r, z = np.meshgrid(phases["r"], phases["z"])
    along, up = (np.where(wet, phases[f"mean/{name}"][phase], np.nan)[some] for name in ("u_r", "u_z"))
    axes.quiver(r[some], z[some], along, up, color=OUTLINE_COLOR, angles="xy", scale_units="xy", scale=fastest / (2 * way),
                width=0.008)


def row_title(phases, phase):
    """Returns the words beside a row."""
    if phases.period == 0:
        return "all times"
    begin, end = phases.span(phase)
    return f"{begin:.3g} to {end:.3g} s"


def draw_row(row, phases, phase, panels, fastest):
    """Draws a phase; returns the images."""
    wet = phases["liquid_share"][phase] >= LEAST_SHARE
    images = []
    for axes, (_, field, colours, norm) in zip(row, panels):
        shown = np.maximum(field[phase], norm.vmin) if isinstance(norm, LogNorm) else field[phase]
        images.append(axes.pcolormesh(edges(phases["r"]), edges(phases["z"]), shown, cmap=colours, norm=norm))
        axes.set(aspect="equal", facecolor=SOLID_COLOR)
        axes.tick_params(labelsize=7)
    draw_arrows(row[0], phases, phase, wet, fastest)
    row[0].set_ylabel(f"{row_title(phases, phase)}\n{phases.axis} [m]", fontsize=8)
    return images


def draw_phases(phases, case):
    """Returns the picture of all phases, with the same colours in each."""
    wet = (phases["liquid_share"] >= LEAST_SHARE).any(axis=(0, 1))
    reach = edges(phases["r"])[1:][wet].max(initial=phases["r"][0])
    height = np.ptp(edges(phases["z"]))
    panel = 0.3 * WIDTH * height / reach  # [in]
    figure = Figure(figsize=(1.2 * WIDTH, min(1.2 + len(phases) * (np.clip(panel, 0.6, 4) + 0.3), 100)), layout="compressed")
    grid = figure.subplots(len(phases), 3, sharex=True, sharey=True, squeeze=False)
    panels = panels_of(phases)
    speeds = np.hypot(phases["mean/u_r"], phases["mean/u_z"])
    rows = [draw_row(row, phases, phase, panels, limit_of(speeds)) for phase, row in enumerate(grid)]
    for column, (title, *_) in enumerate(panels):
        bar = figure.colorbar(rows[0][column], ax=list(grid[:, column]), location="top", extend="max", aspect=25,
                              pad=0.04 / len(phases))
        bar.set_label(title, fontsize=8)
        bar.ax.tick_params(labelsize=7)
        grid[-1, column].set_xlabel("r [m]", fontsize=8)
    grid[0, 0].set_xlim(0, reach)
    figure.suptitle(wrapped(f"{case}, means of phases"), fontsize=10)
    return figure
