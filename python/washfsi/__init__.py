# SPDX-License-Identifier: BSD-3-Clause
"""Results of washfsi as tables and fields with units, and a way to start runs.

    import washfsi
    results = washfsi.run("inputs/wash2d.opts", "out", options={"time_end": 0.2}, ranks=2)
    results = washfsi.Results("out")
    print(results.history["time"], results.history.units["time"])
"""

from washfsi.errors import ResultsError, RunError
from washfsi.phases import Phases
from washfsi.results import Results
from washfsi.running import run
from washfsi.series import Fields, Frame, Markers, Surfaces
from washfsi.table import Table, read_table

__all__ = ["Fields", "Frame", "Markers", "Phases", "Results", "ResultsError", "RunError", "Surfaces", "Table",
           "read_table", "run"]
