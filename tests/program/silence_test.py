# SPDX-License-Identifier: BSD-3-Clause
"""Nothing that has no effect, and nothing that means what nobody wants, is taken in silence: the first is warned of, the second
refused in a line."""

import concurrent.futures
import math
import re
import unittest

from support import SOURCE, WASH, ProgramTest, run

INPUTS = SOURCE / "inputs"
MACHINE = ["-options_file", INPUTS / "wash.opts", "-grid_cells", "12,12,12", "-towel_markers", 4, "-contact_distance", 0]
HEAP = ["-options_file", INPUTS / "heap.opts"]
LOADER = ["-options_file", INPUTS / "front_loader_filled.opts", "-grid_cells", "20,20,10", "-contact_distance", 0]
BOX = ["-grid_cells", "8,8,8", "-time_end", 1, "-time_step", 0.1]
PLANE = ["-options_file", WASH]
PHASES = [*BOX, "-statistics_phases", 4, "-statistics_phase_period", 1]

# the case, the options, and what the line must hold
REFUSED = [
    (LOADER, ["-drum_wall_radius", 0.5], ["-drum_wall_inverted", "outside the box", "0.1"]),
    (BOX, ["-bodies", "tub", "-body_method", "mapping", "-tub_radius", 5, "-tub_inverted"], ["-tub_inverted", "outside the box"]),
    (PLANE, ["-drum_radius", 5], ["-drum_inverted", "outside the box"]),
    (MACHINE, ["-contact_body_distance", 5], ["-contact_body_distance 5", "at most"]),
    (PLANE, ["-contact_distance", 5], ["-contact_distance 5", "at most"]),
    (PHASES, ["-statistics_phase_center", "9,9,9"], ["-statistics_phase_center 9,9,9", "in the box"]),
    (PHASES, ["-statistics_phase_center", "0.5,1e30,0.5"], ["-statistics_phase_center", "in the box"]),
    (PHASES, ["-statistics_phase_bins_r", 200], ["-statistics_phase_bins_r 200", "at most 6"]),
    (PHASES, ["-statistics_phase_bins_z", 9], ["-statistics_phase_bins_z 9", "at most 8"]),
    (MACHINE, ["-contact_friction", "1e6"], ["-contact_friction 1e6", "from 0 to 5"]),
    (HEAP, ["-contact_body_friction", 77], ["-contact_body_friction 77", "from 0 to 5"]),
    (HEAP, ["-cloths_fabric", "crimp", "-cloths_ke_yarn", 1e7, "-cloths_crimp", 5], ["_crimp 5", "a strain"]),
    (HEAP, ["-cloths_fabric", "crimp", "-cloths_ke_yarn", 1e7, "-cloths_crimp", 0.05, "-cloths_crimp_width", 0.06],
     ["_crimp_width 0.06", "at most", "0.05"]),
    (MACHINE, ["-machine_axis", "9,9"], ["-machine_axis 9,9", "in the box"]),
    (MACHINE, ["-machine_orbit_center", "0.1,9"], ["-machine_orbit_center 0.1,9", "in the box"]),
    (MACHINE, ["-towel_thickness", 0.24], ["-towel_thickness 0.24", "a tenth"]),
    (MACHINE, ["-towel_tilt", 15], ["-towel_tilt 15", "pi"]),
    (HEAP, ["-towel_shape", "crumpled", "-towel_crumpling", 40], ["-towel_crumpling 40", "pi"]),
    (PLANE, ["-agitator_tip_radius", 0.05], ["-agitator_tip_radius 0.05", "-agitator_hub_radius"]),
    (BOX, ["-time_step", 10], ["-time_step 10", "-time_end"]),
    (MACHINE, ["-turbulence", "vreman", "-turbulence_constant", 50], ["-turbulence_constant 50", "from 0 to 10"]),
    (MACHINE, ["-time_tolerance", 2], ["-time_tolerance 2", "from 0 to 1"]),
    (MACHINE, ["-coupling_mobility_factor", 1e6], ["-coupling_mobility_factor", "to 100"]),
    (MACHINE, ["-coupling_slip_tolerance", 3], ["-coupling_slip_tolerance 3", "from 0 to 1"]),
    (BOX, ["-profiles", "line", "-line_from", "0,0,0", "-line_to", "1,0,0", "-line_points", 10**9], ["-line_points", "1000000"]),
    (BOX, ["-fluid_initial", "channel", "-fluid_initial_disturbance", 40], ["-fluid_initial_disturbance 40", "from 0 to 1"]),
    ([*BOX, "-bodies", "rock", "-body_method", "mapping", "-rock_shape", "stl", "-rock_file", INPUTS / "agitator_stl" / "agitator.stl"],
     ["-rock_scale", 1e-3, "-rock_sample_spacing", 0.5], ["-rock_sample_spacing 0.5", "two of the smallest cells"]),
    (MACHINE, ["-drum_axis", "1,0,0"], ["-drum_axis 1,0,0", "bodies turn about z"]),
    (MACHINE, ["-bodies_axis", "1,0,0"], ["-bodies_axis 1,0,0", "bodies turn about z"]),
    (LOADER, ["-drum_wall_axis", "0,1,0"], ["-drum_wall_axis 0,1,0", "bodies turn about z"]),
    (MACHINE, ["-water_level", 0.1], ["-water_level 0.1", "no surface"]),
    (PLANE, ["-water_shape", "drum"], ["-water_shape drum", "no surface"]),
]

# the case, the options that have no effect with their values, and the reason that is told
IDLE = [
    (MACHINE, ["-contact_friction", 0.4], ["-contact", "none"], "-contact is none"),
    (MACHINE, ["-contact_pressure", 3e3], [], "-contact is barrier"),
    (PLANE, ["-contact_friction", 0.3], [], "-contact is penalty"),
    (PLANE, ["-contact_distance", 0.01], ["-contact", "none"], "-contact is none"),
    (MACHINE, ["-turbulence_constant", 0.1], [], "-turbulence is none"),
    (MACHINE, ["-statistics_axes", "z", "-statistics_spectra", 0.1], [], "-statistics is false"),
    (MACHINE, ["-statistics_start", 0.1], [], "neither -statistics nor -statistics_phases"),
    (MACHINE, ["-statistics_phase_bins_r", 4, "-statistics_phase_center", "0,0,0.1"], [], "-statistics_phases is 0"),
    (HEAP, ["-turbulence", "vreman", "-fluid_viscosity", 2, "-advection", "upwind", "-delta_kernel", "bao", "-towel_permeance", 0.1,
            "-wall_model", "equilibrium", "-statistics_phases", 1, "-fluid_initial", "uniform", "-contact_drainage", "true"], [],
     "-fluid is none"),
    (PLANE, ["-cloth_drag", 3], [], "-fluid is water"),
    (PLANE, ["-coupling_time_scheme", "backward_euler", "-long_damping", 1e-3], [], "-coupling_scheme is semi_implicit"),
    (PLANE, ["-coupling_order", 2, "-coupling_tolerance", 1e-3, "-coupling_sweeps", 3], ["-coupling_scheme", "midpoint"],
     "-coupling_scheme is midpoint"),
    (PLANE, ["-cloth_limits_advection", "true"], ["-advection", "upwind"], "-advection is upwind"),
    (PLANE, ["-fluid_initial_velocity", "1,0"], [], "-fluid_initial is rest"),
    (PLANE, ["-fluid_initial_seed", 4], ["-fluid_initial", "uniform"], "-fluid_initial is uniform"),
    (PLANE, ["-body_slip_tolerance", 0.01, "-body_marker_spacing", 2], [], "-body_method is mapping"),
    (PLANE, ["-pressure_tolerance", 1e-8], ["-fluid_projection", "false"], "-fluid_projection is false"),
    (PLANE, ["-long_inner_radius", 0.3], [], "-long_placement is random"),
    (PLANE, ["-long_amplitude", 0.1, "-long_mode", 2, "-long_crumpling", 0.1], [], "-long_shape is flat"),
    (PLANE, ["-long_hold_stiffness", 10], [], "-long_hold is none"),
    (PLANE, ["-drum_frequency", 3], [], "body drum does not move"),
    (HEAP, ["-towel_radius", 0.4], ["-towel_placement", "stack"], "-towel_placement is stack"),
    (BOX, ["-gravity", "0,0,-9.81", "-contact", "barrier", "-rest_speed", 1], [], "-cloths names none"),
    (BOX, ["-body_method", "ghost", "-body_balance", "true"], [], "-bodies names none"),
    ([*BOX, *(word for axis in "xyz" for end in ("lower", "upper") for word in (f"-bc_{axis}_{end}", "periodic"))],
     ["-wall_model", "equilibrium"], [], "the box has no walls"),
]

WARNED = [
    (MACHINE, ["-gravity", "0,0,-9810"], "-gravity 0,0,-9810"),
    (MACHINE, ["-towel_excess_mass", 93], "-towel_excess_mass 93"),
    (MACHINE, ["-cycle_time", 1e-9], "-cycle_time: cycles of 1e-09 s"),
    (MACHINE, ["-statistics_phases", 1000], "-statistics_phases 1000"),
    (MACHINE, ["-statistics_phases", 2, "-statistics_phase_axis", "x"], "-statistics_phase_axis x"),
]

# options, the finding and what it tells
DOUBTED = [
    (MACHINE, ["-history_interval", 9], "history interval"),
    (MACHINE, ["-contact_verify_interval", 9], "intersections interval"),
    (MACHINE, ["-statistics_phases", 4, "-statistics_start", 9], "start of statistics"),
    (MACHINE, ["-statistics_phases", 4, "-statistics_interval", 9], "statistics interval"),
    (MACHINE, ["-statistics_phases", 4, "-statistics_phase_period", 9], "phases"),
    (LOADER, ["-drum_lifter_offset", "0.9,0,0"], "part drum_lifter"),
]


class Silence(ProgramTest):
    def checks(self, cases):
        """Runs checks, some at a time: they mostly wait; yields each with its outcome."""
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            yield from zip(cases, pool.map(self.check_apart, range(len(cases)), cases))

    def check_apart(self, number, options):
        """Runs a check in a folder of its own."""
        folder = self.folder / str(number)
        folder.mkdir()
        return run(1, *options, "-check", "-output_dir", "out", folder=folder)

    def check(self, *options):
        """Runs a check, which must end well; returns its lines."""
        return self.run_well(1, *options, "-check", "-output_dir", "out").splitlines()

    def test_what_means_nothing_is_refused_in_a_line(self):
        cases = [[*case, *options] for case, options, _ in REFUSED]
        for (_, options, words), (_, outcome) in zip(REFUSED, self.checks(cases)):
            with self.subTest(options=options):
                self.assertEqual(outcome.returncode, 2, outcome.stdout + outcome.stderr)
                line, = outcome.stderr.splitlines()
                for word in words:
                    self.assertIn(word, line)

    def test_what_has_no_effect_is_warned_of(self):
        cases = [[*case, *idle, *others] for case, idle, others, _ in IDLE]
        for (_, idle, _, reason), (_, outcome) in zip(IDLE, self.checks(cases)):
            with self.subTest(options=idle):
                self.assertEqual(outcome.returncode, 0, outcome.stderr)
                told, = [line for line in outcome.stdout.splitlines() if line.startswith(f"warning: {reason}")]
                self.assertEqual(set(re.findall(r"-\w+", told.split("without effect:")[1])),
                                 {word for word in map(str, idle) if re.match(r"-[a-z]", word)})

    def test_what_is_probably_in_another_unit_is_warned_of(self):
        for case, options, start in WARNED:
            with self.subTest(options=options):
                self.assertTrue([line for line in self.check(*case, *options) if line.startswith(f"warning: {start}")])

    def test_what_never_comes_is_doubted(self):
        for case, options, name in DOUBTED:
            with self.subTest(options=options):
                self.assertTrue([line for line in self.check(*case, *options) if line[6:8] == "  " and line[8:30].strip() == name])

    def test_an_effect_that_a_later_place_takes_away_is_a_note(self):
        lines = self.check("-options_file", INPUTS / "thesis" / "wash33.opts", "-contact", "none")
        self.assertIn("note: -contact is none, so without effect: -contact_distance", lines)
        self.assertEqual([line for line in lines if line.startswith("warning")], [])

    def test_what_is_switched_off_is_no_matter(self):
        lines = self.check(*PLANE, "-contact_friction", 0, "-turbulence_constant", "0.0", "-cloth_drag", 0, "-statistics_axes", "")
        self.assertEqual([line for line in lines if line.startswith("warning")], [])

    def test_a_default_for_all_has_an_effect_if_it_has_one_on_any(self):
        lines = self.check(*PLANE, "-cloths_hold_stiffness", 5, "-long_hold", "middle")
        self.assertEqual([line for line in lines if line.startswith("warning")], [])

    def test_resolved_options_are_no_matter(self):
        """A run records all options, those without effect too: who repeats it is not told again, but of what he adds."""
        self.check(*MACHINE, "-contact", "none", "-contact_friction", 0.3, "-statistics_start", 0.1)
        self.assertIn("-contact_friction 0.3\n", (self.folder / "out" / "resolved.opts").read_text(encoding="utf-8"))
        repeated = ["-options_file", (self.folder / "out" / "resolved.opts").rename(self.folder / "before.opts")]
        self.assertEqual([line for line in self.check(*repeated) if line.startswith(("warning", "note: -"))], [])
        self.assertIn("warning: -turbulence is none, so without effect: -turbulence_constant",
                      self.check(*repeated, "-turbulence_constant", 0.1))

    def test_strict_refuses_warnings_of_options(self):
        outcome = run(1, *BOX, "-turbulence_constant", 0.1, "-strict", "-output_dir", "out", folder=self.folder)
        self.assertEqual(outcome.returncode, 2, outcome.stdout)
        self.assertIn("-strict: 1 warning, the first -turbulence is none", outcome.stderr)

    def test_shipped_cases_have_no_option_without_effect(self):
        for path in sorted([*INPUTS.glob("*.opts"), INPUTS / "vanes" / "vanes3.opts", INPUTS / "thesis" / "dt.opts"]):
            cells = re.search(r"^-grid_cells (\S+)", path.read_text(encoding="utf-8"), re.M)
            if cells and math.prod(map(int, cells[1].split(","))) > 20000:
                continue  # takes long to set up
            with self.subTest(path.stem):
                lines = self.check("-options_file", path)
                self.assertEqual([line for line in lines if line.startswith("warning")], [])


if __name__ == "__main__":
    unittest.main()
