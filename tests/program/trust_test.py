# SPDX-License-Identifier: BSD-3-Clause
"""What makes a case doubtful is said, with what to do; -strict refuses it; the summary has it too."""

import json
import unittest

import numpy as np

from support import SOURCE, ProgramTest, read_columns, run

WATER = ["-grid_cells", "16,16,16", "-fluid_viscosity", 1e-3, "-time_step", 1e-3, "-time_end", 1, "-check"]
WASH = ["-options_file", SOURCE / "inputs" / "wash.opts", "-grid_cells", "12,12,12", "-towel_markers", 4]
# explicit: cloths that lie in each other cannot be solved for
SHEET = ["-options_file", SOURCE / "inputs" / "sheet.opts", "-check", "-coupling_scheme", "explicit", "-time_cfl", 0,
         "-time_step", 1e-5]
STL = [*WATER, "-bodies", "rock", "-body_method", "mapping", "-rock_shape", "stl", "-rock_file", "rock.stl"]
DRUM = ["-grid_cells", "16,16,12", "-fluid_viscosity", 1, "-time_step", 5e-3, "-time_end", 0.02, "-bodies", "drum", "-body_method",
        "mapping", "-drum_inverted", "-drum_shape", "cylinder", "-drum_radius", 0.4, "-drum_height", 2, "-drum_center", "0.5,0.5,0.5", "-drum_angular_speed", 1]
LOW, HIGH = (0.3, 0.3, 0.3), (0.7, 0.6, 0.7)


def box(low, high, inwards=False):
    """Returns the twelve facets of a box."""
    facets = []
    for axis in range(3):
        for side in (0, 1):
            corners = []
            for along, across in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis] = (low, high)[side][axis]
                corner[(axis + 1) % 3] = (low, high)[along][(axis + 1) % 3]
                corner[(axis + 2) % 3] = (low, high)[across][(axis + 2) % 3]
                corners.append(corner)
            for triple in ((0, 1, 2), (0, 2, 3)):
                facet = [corners[n] for n in triple]
                facets.append(facet if (side == 1) != inwards else facet[::-1])
    return facets


class Trust(ProgramTest):
    def write_stl(self, facets):
        corners = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % tuple(c) for c in facet) +
                          "endloop\nendfacet\n" for facet in facets)
        (self.folder / "rock.stl").write_text(f"solid rock\n{corners}endsolid rock\n")

    def findings(self, *options, ranks=1):
        """Returns the lines on what was looked at, by its name."""
        lines = [line for line in self.run_well(ranks, *options).splitlines() if line[:6] in ("  ok  ", "  warn", "  fail")]
        return {line[8:30].strip(): line for line in lines}

    def assert_found(self, found, name, verdict, text):
        self.assertIn(name, found)
        self.assertTrue(found[name].startswith(f"  {verdict}"), found[name])
        self.assertIn(text, found[name])

    def refused(self, *options):
        outcome = run(1, *options, folder=self.folder)
        self.assertEqual(outcome.returncode, 2, outcome.stdout)
        line, = [line for line in outcome.stderr.splitlines() if line.startswith("washfsi: ")]
        return line

    def test_shells_within_others_are_told_of(self):
        """A cavity whose facets face outwards fills what it should leave free."""
        inner = [0.4] * 3, [0.5] * 3
        for cavity, told in ((box(*inner), True), (box(*inner, inwards=True), False), (box([0.6] * 3, [0.9] * 3), False)):
            self.write_stl(box(LOW, HIGH) + cavity)
            printed = self.run_well(1, *STL)
            self.assertEqual("warning: -rock_file rock.stl: two shells, united: one lies within the other" in printed, told, printed)

    def test_bodies_without_water_hold_none(self):
        """A plate thinner than a cell is there for cloths to touch; one outside the box is not."""
        dry = ["-options_file", SOURCE / "inputs" / "heap.opts", "-check", "-bodies", "plate", "-plate_shape", "box"]
        found = self.findings(*dry, "-plate_size", "0.1,0.1,0.002", "-plate_center", "0.1,0.1,0.3")
        self.assert_found(found, "body plate", "ok", "")
        self.assertEqual([line for line in found.values() if "water" in line or "cells across" in line], [])
        found = self.findings(*dry, "-plate_size", "0.1,0.1,0.1", "-plate_center", "9,9,9")
        self.assert_found(found, "body plate", "warn", "outside the box")

    def test_what_projection_would_keep_is_not_asked_for_without_it(self):
        options = ["-options_file", SOURCE / "inputs" / "drape.opts", "-grid_cells", "13,13,13", "-sheet_markers", 12, "-contact_distance", 0]
        found = self.findings(*options, "-max_steps", 3)
        self.assertEqual({"volume", "energy open"} & found.keys(), set())
        self.assert_found(found, "CFL number", "ok", "")
        self.assertIn("volume", self.findings(*options, "-max_steps", 3, "-fluid_projection", "true"))

    def test_the_shipped_case(self):
        found = self.findings("-options_file", SOURCE / "inputs" / "wash.opts", "-check")
        self.assert_found(found, "viscosity", "warn", "1006 times water's")
        self.assert_found(found, "agitator cells across", "ok", "2.3 in its thinnest tenth")
        self.assert_found(found, "boundary layer", "ok", "4.1 cells")
        self.assert_found(found, "towel marker spacing", "ok", "1.39 cells")
        self.assert_found(found, "Reynolds number", "ok", "the reach of agitator")
        self.assert_found(found, "body drum", "ok", "cells")
        self.assert_found(found, "cycles", "warn", "1 of")

    def test_work_that_the_advection_scheme_takes(self):
        run_of = [*WASH, "-cloths", "", "-max_steps", 60]
        for advection, verdict in (("upwind", "warn"), ("central", None)):
            with self.subTest(advection):
                found = self.findings(*run_of, "-advection", advection, "-body_limits_advection", "false")
                if verdict:
                    self.assert_found(found, "numerical dissipation", verdict, "J put in (limit 10)")
                    self.check_dissipation(float(found["numerical dissipation"].split()[3]))
                else:
                    self.assertNotIn("numerical dissipation", found)

    def check_dissipation(self, percent):
        """Holds the finding against the history's columns: powers, over the work of the bodies."""
        history = read_columns(self.folder / "out" / "history.csv")
        steps = np.diff(history["time"], prepend=0)
        work = sum((history[name] * steps).sum() for name in ("agitator_power", "drum_power"))
        self.assertAlmostEqual(percent, 100 * (history["numerical_dissipation"] * steps).sum() / work, delta=0.06 * percent)

    def test_blades_too_narrow_for_their_jets(self):
        tank = ["-options_file", SOURCE / "inputs" / "stirred_tank.opts", "-impeller_parts", "blade", "-check"]
        name = "impeller sheet width"
        self.assertNotIn(name, self.findings(*tank))
        water = [*tank, "-fluid_viscosity", 1e-3, "-turbulence", "vreman", "-wall_model", "equilibrium"]
        self.assert_found(self.findings(*water), name, "warn", "3.3 cells from edge")
        self.assert_found(self.findings(*water, "-impeller_blade_size", "0.05,0.002,0.05"), name, "ok", "cells from edge to edge")

    def test_thin_liquids_beside_cloth(self):
        thin = [*WASH, "-fluid_viscosity", 1e-3, "-check"]
        self.assert_found(self.findings(*thin), "water beside cloth", "warn", "-cloth_limits_advection")
        self.assert_found(self.findings(*WASH, "-fluid_viscosity", 2, "-check"), "water beside cloth", "ok", "central differences")
        for options in (["-cloth_limits_advection"], ["-advection", "upwind"], ["-cloths", ""]):
            with self.subTest(options):
                self.assertNotIn("water beside cloth", self.findings(*thin, *options))

    def test_surfaces_of_stl_files(self):
        self.write_stl(box(LOW, HIGH))
        self.assert_found(self.findings(*STL), "rock cells across", "ok", "4.8")
        self.write_stl(box([1e3 * x for x in LOW], [1e3 * x for x in HIGH]))
        self.assertIn("-rock_scale 0.001", self.refused(*STL))
        self.write_stl(box([1e-3 * x for x in LOW], [1e-3 * x for x in HIGH]))
        self.assert_found(self.findings(*STL), "body rock", "fail", "-rock_scale")
        self.write_stl(box(LOW, HIGH, inwards=True))
        self.assertIn("face inwards; turn them round", self.refused(*STL))
        self.write_stl(box(LOW, HIGH)[1:])
        self.assertIn("it is open", self.refused(*STL))
        self.write_stl(box(LOW, HIGH) + box((0.5, 0.5, 0.5), (0.8, 0.8, 0.8)))
        self.assert_found(self.findings(*STL), "body rock", "ok", "to (0.812,0.812,0.812)")

    def test_bodies_where_they_do_not_belong(self):
        ball = ["-body_method", "mapping", "-ball_radius", 0.2, "-ball_center"]
        self.assert_found(self.findings(*WATER, "-bodies", "ball", *ball, "3,0,0"), "body ball", "fail", "outside the box")
        found = self.findings(*WATER, "-bodies", "ball", *ball, "0.5,0.5,0.5", "-ball_radius", 3)
        self.assert_found(found, "body ball", "fail", "it fills the box, all 4096 cells: no water is left")
        two = [*WATER, "-bodies", "ball,egg", *ball, "0.4,0.5,0.5", "-egg_center", "0.6,0.5,0.5"]
        self.assert_found(self.findings(*two, "-egg_radius", 0.2), "bodies ball, egg", "warn", "share 40 cells")
        self.assert_found(self.findings(*two, "-egg_radius", 0.5), "bodies ball, egg", "fail", "ball lies wholly within egg")

    def test_a_box_in_millimetres(self):
        found = self.findings(*WASH, "-grid_lower", "-356.4,-356.4,0", "-grid_upper", "356.4,356.4,237.6", "-check")
        self.assert_found(found, "box", "warn", "713 m")

    def test_walls_that_rest_where_a_drum_turns(self):
        found = self.findings(*DRUM, "-bc_z_upper", "slip", "-check")
        self.assert_found(found, "drum over bc_z_lower", "warn", "up to 0.398 m/s past 124 cells of a wall that rests (limit 0)")
        self.assertEqual([name for name in found if " over " in name], ["drum over bc_z_lower"])
        found = self.findings(*DRUM, "-drum_radius", 0.53, "-check")  # it is cut off by all sides
        self.assertEqual(len([name for name in found if " over " in name]), 6)
        for options in (["-drum_height", 0.65], ["-drum_angular_speed", 0], ["-drum_inverted", "false"]):
            with self.subTest(options):
                self.assertEqual([name for name in self.findings(*DRUM, *options, "-check") if " over " in name], [])

    def test_energy_of_water_that_turns_at_the_start(self):
        for height, of_what in ((0.65, "of the 15.4 J of the start"), (2, "of the 21.8 J of the start")):
            with self.subTest(height):
                found = self.findings(*DRUM, "-drum_height", height, "-fluid_initial", "rotation")
                self.assert_found(found, "energy open", "ok", of_what)
                self.assertLess(float(found["energy open"].split()[3]), 0.1)

    def test_a_motion_in_degrees(self):
        (self.folder / "turn.csv").write_text("time,x,y,z,angle\n0,0,0,0,0\n0.1,0,0,0,60\n0.2,0,0,0,0\n")
        found = self.findings(*WATER, "-bodies", "ball", "-body_method", "mapping", "-ball_radius", 0.2, "-ball_center", "0.5,0.5,0.5",
                              "-ball_motion_file", "turn.csv")
        self.assert_found(found, "ball speed", "warn", "degrees")

    def test_markers_and_cloths(self):
        name = "towel marker spacing"
        self.assert_found(self.findings(*SHEET, "-towel_markers", 2, "-grid_cells", "64,64,64"), name, "fail", "12.7 cells")
        self.assert_found(self.findings(*SHEET, "-towel_markers", 30, "-grid_cells", "8,8,8"), name, "fail", "0.0794 cells")
        same = [word for name, value in (("size", "0.08,0.06"), ("markers", "8,6"), ("center", "0,0,0.08"),
                                         ("direction", "0.5,0.1,1"), ("across", "0.2,1,0"))
                for word in (f"-shirt_{name}", value)]
        self.assert_found(self.findings(*SHEET, "-cloths", "towel,shirt", *same), "distance of cloths", "fail",
                          "place them apart")

    def test_intervals_beyond_the_run(self):
        found = self.findings(*SHEET, "-checkpoint_interval", 100)
        self.assert_found(found, "checkpoint interval", "warn", "nothing is kept")

    def test_strict(self):
        line = self.refused(*WASH, "-check", "-strict")
        self.assertIn("-strict: ", line)
        self.assertIn("1006 times water's", line)
        self.run_well(1, *WATER, "-strict", "-bodies", "")

    def test_the_summary_has_what_was_found_at_start_and_end(self):
        out = self.run_well(2, *WASH, "-body_method", "mapping", "-time_step", 4e-3, "-max_steps", 3, "-cycle_time", 4e-3)
        self.assertIn("energy open", out)
        self.assertIn("\n  ok    Reynolds number", out)  # always told
        self.assertNotIn("\n  ok    body drum", out)
        trust = json.loads((self.folder / "out" / "summary.json").read_text())["trust"]
        start = {entry["name"]: entry for entry in trust["start"]}
        self.assertEqual(start["viscosity"]["verdict"], "warn")
        self.assertAlmostEqual(start["viscosity"]["value"], 1006.4)
        self.assertEqual(start["viscosity"]["limit"], 2)
        self.assertIn("advice", start["viscosity"])
        end = {entry["name"] for entry in trust["end"]}
        self.assertLessEqual({"energy open", "energy lost at moving walls", "CFL number", "volume", "towel stretch",
                              "towel depth in bodies", "crossings", "agitator_work of cycles"}, end)


if __name__ == "__main__":
    unittest.main()
