# SPDX-License-Identifier: BSD-3-Clause
"""The results of one run."""

import functools
import json
import pathlib

from washfsi.errors import ResultsError
from washfsi.options_file import read_options
from washfsi.phases import read_phases
from washfsi.series import Fields, Markers, Surfaces
from washfsi.table import read_table


class Results:
    """What a run has left in its output folder. Each file is read when it is first asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise ResultsError(f"no folder {self.folder}")

    def __repr__(self):
        return f"Results of {self.case} in {self.folder}"

    @functools.cached_property
    def summary(self):
        """Returns summary.json as a dictionary; empty while a run goes on."""
        path = self.folder / "summary.json"
        try:
            return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
        except ValueError as error:
            raise ResultsError(f"cannot read {path}: {error}") from None

    @functools.cached_property
    def options(self):
        """Returns every option of the run, of resolved.opts, as texts."""
        path = self.folder / "resolved.opts"
        return read_options(path) if path.is_file() else {}

    @property
    def case(self):
        """Returns the case's name, the folder's until there is a summary."""
        return self.summary.get("case", self.folder.resolve().name)

    @property
    def groups(self):
        """Returns the names of the groups of cloths, in their order."""
        names = self.summary.get("cloths") or [name for name in self.options.get("cloths", "").split(",") if name]
        return list(names)

    def _table(self, name):
        return read_table(self.folder / f"{name}.csv")

    @functools.cached_property
    def history(self):
        """Returns the history as a table."""
        return self._table("history")

    @functools.cached_property
    def tracks(self):
        """Returns the centres of the cloths over time as a table."""
        return self._table("tracks")

    @functools.cached_property
    def cycles(self):
        """Returns the figures of each complete cycle of agitation as a table."""
        return self._table("cycles")

    @functools.cached_property
    def statistics(self):
        """Returns means and stresses of the flow over the axis that is left, as a table."""
        return self._table("statistics")

    @functools.cached_property
    def phases(self):
        """Returns the means over azimuth and cycles, phase by phase."""
        return read_phases(self.folder / "phases.h5")

    @functools.cached_property
    def markers(self):
        """Returns the markers at the end as a table, with the names of their groups."""
        return self._table("cloth_final")

    def profile(self, name):
        """Returns the profile of this name as a table."""
        return self._table(f"profiles/{name}")

    def _series(self, kind, name):
        path = self.folder / f"{name}.h5"
        return kind(path) if path.is_file() else None

    def in_step(self):
        """Returns these results with the frames that all of flow, bodies, surfaces and cloth have, so that a number is one moment in
        each: of a damaged frame the others of its moment are left out too."""
        series = {name: getattr(self, name) for name in ("flow", "bodies", "surfaces", "cloth")}
        there = {name: one for name, one in series.items() if one}
        common = set.intersection(*(set(one.steps.tolist()) for one in there.values()))
        if not common:
            raise ResultsError(f"{self.folder}: no moment of which {', '.join(there)} all have a frame that can be read")
        results = Results(self.folder)
        vars(results).update(vars(self) | series | {name: one.of_steps(common) for name, one in there.items()})
        return results

    @functools.cached_property
    def flow(self):
        """Returns the series of the flow."""
        return Fields(self.folder / "flow.h5")

    @functools.cached_property
    def bodies(self):
        """Returns the series of the bodies' signed distances, None without bodies."""
        return self._series(Fields, "bodies")

    @functools.cached_property
    def surfaces(self):
        """Returns the series of the bodies' surfaces, None where the box has none."""
        return self._series(Surfaces, "surfaces")

    @functools.cached_property
    def cloth(self):
        """Returns the series of the cloths' markers, None without cloth."""
        return self._series(Markers, "cloth")
