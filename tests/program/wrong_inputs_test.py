# SPDX-License-Identifier: BSD-3-Clause
"""Each mistake of a user ends with one line that says what is wrong, and with the exit status promised for it."""

import concurrent.futures
import json
import os
import re
import subprocess
import unittest
import unittest.mock

import h5py

from support import CAVITY, EXPLICIT_WASH, SHEET, WASH, ProgramTest, read_columns, run

SECONDS = 30  # after which a run is taken to hang
AT_ONCE = 4   # runs that are refused at the start: they mostly wait
WRONG_INPUT, DIVERGED, CANNOT_WRITE = 2, 3, 4
CASE = ["-options_file", WASH, "-time_end", 0.01, "-output_dir", "out"]

# what is wrong, the options, and the words that the message must hold
WRONG_OPTIONS = [
    ("negative viscosity", ["-fluid_viscosity", "-1"], ["-fluid_viscosity -1"]),
    ("eddies in the plane", ["-turbulence", "sigma"], ["-turbulence sigma", "three dimensions"]),
    ("unknown eddies", ["-turbulence", "smagorinsky"], ["-turbulence smagorinsky", "vreman", "sigma", "wale"]),
    ("negative constant of eddies", ["-turbulence", "wale", "-turbulence_constant", "-1"], ["-turbulence_constant -1"]),
    ("advection from too many steps", ["-advection_steps", "4"], ["-advection_steps 4", "2 or 3"]),
    ("unknown wall model", ["-wall_model", "log"], ["-wall_model log", "none", "equilibrium"]),
    ("wall model without viscosity", ["-wall_model", "equilibrium", "-fluid_viscosity", "0"], ["-wall_model", "-fluid_viscosity"]),
    ("zero cells", ["-grid_cells", "0,64"], ["-grid_cells", " 0"]),
    ("misspelt option", ["-fluid_viscosty", "1"], ["-fluid_viscosty 1", "-fluid_viscosity"]),
    ("misspelt option of a body", ["-drum_radios", "0.3"], ["-drum_radios 0.3", "-drum_radius"]),
    ("too few numbers", ["-grid_cells", "64"], ["-grid_cells 64"]),
    ("too many numbers", ["-grid_lower", "-1,-1,-1"], ["-grid_lower -1,-1,-1"]),
    ("number missing from a list", ["-grid_cells", "64,"], ["-grid_cells 64,"]),
    ("no value", ["-fluid_density"], ["-fluid_density"]),
    ("not a number", ["-fluid_density", "nan"], ["-fluid_density nan"]),
    ("infinite number", ["-time_end", "inf"], ["-time_end inf"]),
    ("number with a unit", ["-drum_radius", "0.3m"], ["-drum_radius 0.3m"]),
    ("whole number too large", ["-long_count", "99999999999"], ["-long_count 99999999999"]),
    ("unknown shape", ["-agitator_shape", "teapot"], ["-agitator_shape teapot", "vaned"]),
    ("shape without its size", ["-drum_shape", "box"], ["-drum_size"]),
    ("combination without parts", ["-drum_shape", "union"], ["-drum_parts"]),
    ("polygon that crosses itself", ["-drum_shape", "polygon", "-drum_vertices", "0,0,3,0,0,1,2,2"],
     ["-drum_vertices 0,0,3,0,0,1,2,2", "cross"]),
    ("smooth mask without a mask to smooth", ["-body_method", "ghost", "-body_mask", "smooth"],
     ["-body_mask smooth", "mapping"]),
    ("strong form without a Jacobian", ["-long_model", "love"], ["-long_model love", "-coupling_scheme"]),
    ("coupling without fluid", ["-fluid", "none", "-cloth_coupling", "midpoint"], ["-cloth_coupling midpoint", "-fluid none"]),
    ("option of cloth for all groups", ["-cloths_drag", 3], ["-cloths_drag", "did you mean -cloth_drag?"]),
    ("option of all groups for cloth", ["-cloth_ke", 5], ["-cloth_ke", "no part of this run reads this option"]),
    ("option of walls for all bodies", ["-bodies_method", "mapping"], ["-bodies_method", "did you mean -body_method?"]),
    ("option of all bodies for walls", ["-body_center", "0,0"], ["-body_center", "no part of this run reads this option"]),
    ("unknown preset", ["-preset", "dishwasher"], ["-preset dishwasher", "none", "machine"]),
    ("unknown contact", ["-contact", "glue"], ["-contact glue", "none", "penalty", "barrier"]),
    ("penalty contact without a pressure", ["-contact", "penalty", "-contact_pressure", 0], ["-contact penalty", "-contact_pressure"]),
    ("barrier as soft as nothing", ["-contact", "barrier", "-contact_stiffness", "0"], ["-contact_stiffness 0", "> 0"]),
    ("barrier wider than a cell", ["-contact", "barrier", "-contact_distance", "0.1"],
     ["-contact_distance 0.1", "half of the least spacing"]),
    ("barrier with two deltas", ["-contact", "barrier", "-contact_distance", "0.005", "-delta_spread_width", "3"],
     ["-contact barrier", "-delta_spread_width", "-delta_interpolate_width"]),
    ("old and new name", ["-coupling_scheme", "explicit", "-cloth_coupling", "midpoint"],
     ["-cloth_coupling", "-coupling_scheme"]),
    ("ring too large", ["-long_shape", "ellipse", "-long_semi_axes", "1,1"], ["-long_placement", "outside the grid"]),
    ("ring with edges", ["-long_shape", "ellipse", "-long_lattice", "nodal"], ["-long_lattice nodal", "no edges"]),
    ("strong form on the nodal lattice", ["-long_model", "love", "-long_lattice", "nodal", "-coupling_scheme", "explicit"],
     ["-long_model love", "centred"]),
    ("unknown lattice", ["-long_lattice", "staggered"], ["-long_lattice staggered", "centred", "nodal"]),
    ("ring with ends", ["-long_shape", "ellipse", "-long_end_force_first", "1,0"], ["-long_end_force", "no ends"]),
    ("unknown solver of the cloth", ["-cloth_snes_type", "foo"], ["-cloth_", "foo"]),
    ("wall that moves with the drum", ["-drum_angular_speed", "1", "-bc_x_upper_velocity", "0,1"],
     ["-bc_x", "velocity", "drum"]),
    ("statistics along walls", ["-statistics", "true", "-statistics_axes", "x"],
     ["-statistics_axes x", "periodic"]),
    ("statistics without an axis", ["-statistics", "true"], ["-statistics", "periodic"]),
    ("statistics from before the start", ["-statistics_start", "-1"], ["-statistics_start -1"]),
    ("negative interval of statistics", ["-statistics_interval", "-1"], ["-statistics_interval -1"]),
    ("phases in the plane", ["-statistics_phases", "4"], ["-statistics_phases 4", "three dimensions"]),
    ("negative phases", ["-statistics_phases", "-4"], ["-statistics_phases -4"]),
    ("negative bins of phases", ["-statistics_phase_bins_r", "-3"], ["-statistics_phase_bins_r -3"]),
    ("gradient towards walls", ["-fluid_pressure_gradient", "-1,0"],
     ["-fluid_pressure_gradient -1,0", "along x", "not periodic"]),
    ("bulk velocity towards walls", ["-fluid_bulk_velocity", "0,1"],
     ["-fluid_bulk_velocity 0,1", "along y", "not periodic"]),
    ("channel in a box", ["-fluid_initial", "channel"], ["-fluid_initial channel", "periodic"]),
    ("unknown profile", ["-fluid_initial_profile", "plug"], ["-fluid_initial_profile plug", "turbulent", "laminar"]),
    ("negative seed", ["-fluid_initial_seed", "-1"], ["-fluid_initial_seed -1"]),
    ("negative disturbance", ["-fluid_initial_disturbance", "-1"], ["-fluid_initial_disturbance -1"]),
    ("couette without its cylinders", ["-fluid_initial", "couette"], ["-fluid_initial couette"]),
    ("rotation with a drum at rest", ["-fluid_initial", "rotation"], ["-fluid_initial rotation", "drum"]),
    ("rotation with no body", ["-fluid_initial", "rotation", "-fluid_initial_body", "door"],
     ["-fluid_initial_body door", "drum,agitator"]),
    ("rotation with a body at rest", ["-fluid_initial", "rotation", "-fluid_initial_body", "drum"],
     ["-fluid_initial_body drum", "does not turn"]),
    ("unknown flow at the start", ["-fluid_initial", "spin"], ["-fluid_initial spin", "rotation"]),
    ("no such table of a motion", ["-drum_motion_file", "nowhere.csv"], ["-drum_motion_file nowhere.csv"]),
    ("two units of one speed", ["-drum_rpm", "45", "-drum_angular_speed", "1"], ["-drum_rpm 45", "-drum_angular_speed"]),
    ("negative ramp", ["-drum_ramp", "-1"], ["-drum_ramp -1"]),
    ("stroke shorter than its ramps", ["-drum_rpm", "45", "-drum_stroke", "1", "-drum_ramp", "0.6"],
     ["-drum_stroke 1", "-drum_ramp 0.6"]),
    ("negative stroke", ["-drum_stroke", "-1"], ["-drum_stroke -1"]),
    ("negative pause", ["-drum_pause", "-1"], ["-drum_pause -1"]),
    ("pause without strokes", ["-drum_pause", "1"], ["-drum_pause 1", "-drum_stroke"]),
    ("cycles without strokes", ["-drum_cycles", "3"], ["-drum_cycles 3", "-drum_stroke"]),
    ("cycles that are no whole number", ["-drum_cycles", "1.5"], ["-drum_cycles 1.5"]),
    ("ramp of an oscillation", ["-agitator_ramp", "0.1"], ["-agitator_ramp 0.1", "-agitator_frequency"]),
    ("ramp between the steps", ["-drum_rpm", "45", "-drum_ramp", "1e-3", "-time_step", "1e-3"],
     ["-drum_ramp 0.001", "-time_step 0.001"]),
    ("stroke between the steps", ["-drum_rpm", "45", "-drum_stroke", "1e-3", "-time_step", "1e-3"],
     ["-drum_stroke 0.001", "-time_step 0.001"]),
    ("no such table of speeds", ["-drum_speed_file", "nowhere.csv"], ["-drum_speed_file nowhere.csv"]),
    ("unknown unit of angles", ["-drum_angle_unit", "turns"], ["-drum_angle_unit turns", "rad|deg"]),
    ("unit of no angles", ["-drum_angle_unit", "deg"], ["-drum_angle_unit deg", "-drum_motion_file"]),
    ("one name for two parts", ["-bodies", "drum,agitator,long"], ["-bodies long"]),
    ("body named twice", ["-bodies", "drum,drum"], ["-bodies drum,drum"]),
    ("no such options file", ["-options_file", "nowhere.opts"], ["-options_file nowhere.opts"]),
    ("options file without a name", ["-options_file"], ["-options_file"]),
    ("options file that is a folder", ["-options_file", "."], ["-options_file ."]),
    ("word without a dash", ["fluid_viscosity", "3"], ["fluid_viscosity"]),
    ("text with a blank", ["-restart", "two words.h5"], ["-restart two words.h5"]),
    ("case name with a blank", ["-case_name", "two words"], ["-case_name two words"]),
    ("file without a name", ["-drum_motion_file"], ["-drum_motion_file", "name of a file"]),
    ("no such checkpoint", ["-restart", "nowhere.h5"], ["-restart nowhere.h5"]),
    ("cloth outside the drum", ["-short_placement", "line", "-short_center", "0,0.33"],
     ["-short_placement", "drum"]),
    ("no room for the cloth", ["-drum_radius", "0.2"], ["-long_placement"]),
    ("periodic on one side", ["-bc_x_lower", "periodic"], ["-bc_x_lower", "periodic"]),
    ("flow in but not out", ["-bc_x_lower", "inflow", "-bc_x_lower_velocity", "0.1,0"], ["-bc_", "net flux", "outflow"]),
    ("inflow that points out", ["-bc_x_lower", "inflow", "-bc_x_lower_velocity", "-1,0", "-bc_x_upper", "outflow"],
     ["-bc_x_lower_velocity -1,0"]),
    ("outflow with a velocity", ["-bc_x_upper", "outflow", "-bc_x_upper_velocity", "1,0"], ["-bc_x_upper_velocity"]),
    ("profile of a wall", ["-bc_x_upper_profile", "parabolic"], ["-bc_x_upper_profile parabolic", "inflow"]),
    ("unknown kind of side", ["-bc_x_upper", "open"], ["-bc_x_upper open", "outflow"]),
    ("corners the wrong way round", ["-grid_upper", "-1,-1"], ["-grid_upper -1,-1"]),
    ("names that differ in case", ["-bodies", "drum,Drum"], ["-bodies Drum", "taken"]),
    ("name of a part in another case", ["-bodies", "Grid"], ["-bodies Grid", "taken"]),
    ("body without a shape", ["-bodies", "rock"], ["-rock_shape is missing"]),
    ("number out of all range", ["-long_thickness", "5e-324"], ["-long_thickness 5e-324", "1e-100"]),
    ("cloth that is never solved", ["-coupling_tolerance", "1e3"], ["-coupling_tolerance 1e3", "0.1"]),
    ("oscillation between the steps", ["-agitator_frequency", "1e5", "-time_step", "1e-3"],
     ["-agitator_frequency 1e+05", "-time_step 0.001"]),
    ("slip side that slides", ["-bc_x_lower", "slip", "-bc_x_lower_velocity", "0,1"],
     ["-bc_x_lower_velocity 0,1", "slip"]),
    ("wall behind a drum at rest", ["-drum_angular_speed", "0", "-bc_x_upper_velocity", "0,1"],
     ["-bc_x", "velocity", "drum"]),
    ("more cells than PETSc counts", ["-grid_cells", "100000,100000"], ["-grid_cells 100000,100000", "unknowns"]),
    ("more markers than there is memory", ["-long_count", "1000000000"], ["-long_markers", "-long_count"]),
    ("solver without a prefix", ["-pc_type", "hypre"], ["-pc_type hypre", "-pressure_pc_type"]),
    ("number that PETSc dies of", ["-momentum_ksp_gmres_restart", "100000000"],
     ["-momentum_ksp_gmres_restart 100000000"]),
    ("multigrid without a level", ["-pressure_pc_type", "mg", "-pressure_pc_mg_levels", "0"],
     ["-pressure_pc_mg_levels 0"]),
    ("multigrid with half a level", ["-pressure_pc_type", "mg", "-pressure_pc_mg_levels", "2.5"],
     ["-pressure_pc_mg_levels 2.5", "whole number"]),
    ("more levels than the grid has", ["-pressure_pc_type", "mg", "-pressure_pc_mg_levels", "20"],
     ["-pressure_pc_mg_levels 20", "at most 4 levels"]),
    ("unknown kind of matrix", ["-mat_type", "foo"], ["-mat_type foo"]),
    ("solver in capitals", ["-PRESSURE_KSP_TYPE", "foo"], ["-PRESSURE_KSP_TYPE foo"]),
    ("misspelt solver option", ["-pressure_ksp_tpye", "cg"], ["-pressure_ksp_tpye cg"]),
    ("markers too far apart", ["-body_method", "direct_forcing", "-body_marker_spacing", "3"],
     ["-body_marker_spacing 3", "from 0.5 to 2"]),
    ("slip that is never taken away", ["-body_method", "direct_forcing", "-body_slip_tolerance", "0.5"],
     ["-body_slip_tolerance 0.5", "0.1"]),
    ("unknown solver", ["-pressure_ksp_type", "foo"], ["-pressure_ksp_type", "foo"]),
]

CRIMP = ["-towel_fabric", "crimp", "-towel_ke_yarn", "40000", "-towel_crimp", "0.05"]
WRONG_OPTIONS_OF_SHEETS = [
    ("Poisson's ratios without symmetry", ["-towel_poisson", "0.3,0.5"], ["-towel_poisson 0.3,0.5", "symmetric"]),
    ("unknown fabric", ["-towel_fabric", "felt"], ["-towel_fabric felt", "linear", "crimp"]),
    ("fabric with crimp but without its yarns", CRIMP[:2] + CRIMP[4:], ["-towel_ke_yarn"]),
    ("yarns softer than their crimp", CRIMP + ["-towel_ke_yarn", "5000,1000"], ["-towel_ke_yarn 1000", "2000"]),
    ("knee without width", CRIMP + ["-towel_crimp_width", "0"], ["-towel_crimp_width 0"]),
    ("crimp of linear fabric", ["-towel_crimp", "0.05"], ["-towel_crimp 0.05"]),
    ("strong form of a fabric with crimp", CRIMP + ["-towel_model", "love", "-coupling_scheme", "explicit"],
     ["-towel_model love", "linear"]),
    ("fabric without stiffness", ["-towel_ke", "4000,0"], ["-towel_ke 0"]),
    ("markers that are no whole number", ["-towel_markers", "6,5.5"], ["-towel_markers", "5.5"]),
    ("too many directions", ["-towel_size", "0.1,0.1,0.1"], ["-towel_size 0.1,0.1,0.1"]),
    ("ring in space", ["-towel_shape", "ellipse"], ["-towel_shape ellipse"]),
    ("strong form of woven cloth", ["-towel_model", "love", "-coupling_scheme", "explicit"], ["-towel_model love"]),
    ("weft along warp", ["-towel_across", "0.5,0.1,1"], ["-towel_across", "-towel_direction"]),
    ("mode that a strip has not", ["-towel_markers", "8,1", "-towel_size", "0.08,0.08", "-towel_shape", "mode"],
     ["-towel_mode 1"]),
    ("prefix of the machine", ["-cloths", "machine"], ["-cloths machine"]),
]

FOREIGN = ["PETSC ERROR", "[0]", "HDF5-DIAG", "Segmentation", "terminate called", "MPI_ABORT"]
MPIRUN_BOX = re.compile(r"^-{70,}\n.*?^-{70,}\n", re.DOTALL | re.MULTILINE)
MPI_IO_LINE = re.compile(r"^mca_.*\n", re.MULTILINE)  # Open MPI's own remark when a file cannot be written


def ranks_for(number):
    """Returns the ranks that try a wrong option: every tenth on two, since all are refused in one way."""
    return 2 if number % 10 == 0 else 1


class WrongInputs(ProgramTest):
    def assert_refused(self, status, words, *options, ranks=2, launcher=()):
        """Runs the program, which must end with a status and with one line of ours that holds some words."""
        self.assert_one_line(run(ranks, *options, folder=self.folder, seconds=SECONDS, launcher=launcher), status, words)

    def assert_one_line(self, outcome, status, words):
        """Asserts that a run ended with a status and with one line of ours that holds some words."""
        self.assertEqual(outcome.returncode, status, outcome.stderr)
        for sign in FOREIGN:
            self.assertNotIn(sign, outcome.stdout + outcome.stderr)
        lines = [line for line in MPI_IO_LINE.sub("", MPIRUN_BOX.sub("", outcome.stderr)).splitlines() if line]
        self.assertEqual(len(lines), 1, outcome.stderr)
        self.assertTrue(lines[0].startswith("washfsi: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])

    def refuse_each(self, case, mistakes):
        """Runs a case with each of the mistakes, in a folder of its own; each must be refused before it writes results."""
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            runs = [pool.submit(self.try_mistake, case, options, number) for number, (_, options, _) in enumerate(mistakes)]
        for started, (what, _, words) in zip(runs, mistakes):
            with self.subTest(what):
                folder, outcome = started.result()
                self.assert_one_line(outcome, WRONG_INPUT, words)
                self.assertFalse((folder / "out").exists(), "it wrote results")

    def try_mistake(self, case, options, number):
        folder = self.folder / str(number)
        folder.mkdir()
        return folder, run(ranks_for(number), *case, *options, folder=folder, seconds=SECONDS)

    def test_wrong_options(self):
        self.refuse_each(CASE, WRONG_OPTIONS)

    def test_wrong_options_of_sheets(self):
        self.refuse_each(["-options_file", SHEET, "-output_dir", "out"], WRONG_OPTIONS_OF_SHEETS)

    def test_options_files_with_garbage(self):
        for what, text, words in (("itself", "-options_file self.opts", ["line 1", "includes itself"]),
                                  ("missing file", "\n-options_file nowhere.opts", ["line 2", "nowhere.opts"]),
                                  ("number for a name", "- 5", ["line 1"]), ("no option", "garbage", ["line 1"]),
                                  ("quote without an end", '-output_dir "out', ["line 1", '"out', "no end"]),
                                  ("NUL byte", "-fluid_viscosity 1\n-a\0b 5", ["line 2", "NUL"])):
            with self.subTest(what):
                (self.folder / "self.opts").write_text(text, encoding="utf-8")
                self.assert_refused(WRONG_INPUT, ["self.opts", *words], "-options_file", "self.opts", ranks=1)

    def test_resource_file_with_garbage(self):
        path = self.folder / ".petscrc"
        path.write_text("garbage here\n", encoding="utf-8")
        self.assert_refused(WRONG_INPUT, [".petscrc, line 1"], "-options_file", CAVITY)
        path.unlink()

    def test_preset_where_petsc_reads_options_by_itself(self):
        path = self.folder / ".petscrc"
        path.write_text("-preset machine\n", encoding="utf-8")
        self.assert_refused(WRONG_INPUT, [".petscrc", "-preset", "command line"], "-options_file", CAVITY)
        path.unlink()
        with unittest.mock.patch.dict(os.environ, PETSC_OPTIONS="-preset machine"):
            self.assert_refused(WRONG_INPUT, ["PETSC_OPTIONS", "-preset", "command line"], "-options_file", CAVITY)

    def test_command_line_wins_wherever_the_file_stands(self):
        outcome = run(1, "-fluid_viscosity", 0.5, "-output_dir", "first", "-options_file", CAVITY, "-grid_cells", "8,8",
                      "-max_steps", 1, folder=self.folder)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertIn("-fluid_viscosity 0.5\n", (self.folder / "first" / "resolved.opts").read_text(encoding="utf-8"))

    def test_report_that_cannot_be_written(self):
        self.assert_refused(WRONG_INPUT, ["-log_view ascii:/nowhere/x"], "-options_file", CAVITY, "-grid_cells", "8,8",
                            "-max_steps", 1, "-log_view", "ascii:/nowhere/x")

    def test_numbers_that_petsc_refuses(self):
        for option, value in (("-pressure_ksp_max_it", "-5"), ("-pressure_ksp_rtol", "nan")):
            with self.subTest(option):
                self.assert_refused(WRONG_INPUT, [f"{option} {value}: "], *CASE, "-output_dir", "out", option, value)

    def test_accuracy_that_nothing_can_follow(self):
        self.assert_refused(WRONG_INPUT, ["-time_tolerance 0.001", "-time_cfl"], "-options_file", SHEET, "-time_cfl", 0,
                            "-time_step", 0.01, "-time_tolerance", 1e-3)
        self.assert_refused(WRONG_INPUT, ["-time_tolerance 0.001", "implicit"], "-options_file", SHEET,
                            "-coupling_scheme", "implicit", "-time_tolerance", 1e-3)

    def test_version(self):
        outcome = run(1, "--version", folder=self.folder)
        self.assertRegex(outcome.stdout, r"^washfsi \d+\.\d+\.\d+")
        self.assertEqual(outcome.returncode, 0)

    def test_too_many_ranks_for_the_grid(self):
        self.assert_refused(WRONG_INPUT, ["-grid_cells", "4 ranks"],
                            "-options_file", CAVITY, "-grid_cells", "4,4", ranks=4)

    def test_checkpoint_of_another_grid(self):
        case = ["-options_file", CAVITY, "-max_steps", 1, "-output_dir", "out"]
        self.run_well(2, *case)
        self.assert_refused(WRONG_INPUT, ["-restart out/checkpoint.h5"],
                            *case, "-grid_cells", "32,32", "-restart", "out/checkpoint.h5")

    def test_checkpoint_of_another_weft(self):
        case = ["-options_file", SHEET, "-time_end", 0.01, "-output_dir", "out"]
        self.run_well(2, *case)
        self.assert_refused(WRONG_INPUT, ["-restart out/checkpoint.h5", "markers"], *case, "-time_end", 0.02,
                            "-towel_size", "0.08,0.05", "-restart", "out/checkpoint.h5")

    def test_checkpoint_that_is_none(self):
        (self.folder / "checkpoint.h5").write_text("no HDF5 file")
        self.assert_refused(WRONG_INPUT, ["-restart checkpoint.h5"], *CASE, "-restart", "checkpoint.h5")

    def test_table_of_a_motion_that_is_none(self):
        table = self.folder / "motion.csv"
        for content, words in [("", "at least 2 rows"), ("0,0,0,0\n1,0,0\n", "line 2"), ("0,0,0,0\n0,0,0,1\n", "line 2")]:
            table.write_text(content)
            self.assert_refused(WRONG_INPUT, ["-drum_motion_file", words], *CASE, "-drum_motion_file", table, ranks=1)

    def test_table_of_speeds_that_is_none(self):
        table = self.folder / "speed.csv"
        for content, words, options in [("", "at least 2 rows", []), ("time,speed\n0,1\n1,1,1\n", "line 3", []),
                                        ("0,0\n0,1\n", "line 2", []), ("0,0\n1,fast\n", "line 2", []),
                                        ("0,0\n1,1\n", "repeated", ["-drum_cycles", 2]),
                                        ("0,0\n1,1\n", "-drum_rpm", ["-drum_rpm", 2]),
                                        ("0,0\n1,1\n", "-drum_ramp", ["-drum_ramp", 2])]:
            table.write_text(content)
            self.assert_refused(WRONG_INPUT, ["-drum_speed_file", words], *CASE, "-drum_speed_file", table, *options,
                                ranks=1)

    def test_stl_file_that_is_none(self):
        (self.folder / "part.stl").write_text("solid part\nfacet normal 0 0 1\n")
        case = ["-grid_cells", "8,8,8", "-time_end", 1, "-time_step", 0.1, "-bodies", "part", "-body_method", "mapping", "-part_shape", "stl"]
        self.assert_refused(WRONG_INPUT, ["-part_file part.stl", "cut short"], *case, "-part_file", "part.stl")
        self.assert_refused(WRONG_INPUT, ["-part_file nowhere.stl"], *case, "-part_file", "nowhere.stl")
        self.assert_refused(WRONG_INPUT, ["-part_file"], *case)

    def test_options_file_that_is_none(self):
        for line in ("grid_cells = 64 64", "-grid_cells 64 64", "-grid_cells = 64,64"):
            with self.subTest(line):
                (self.folder / "case.opts").write_text(line + "\n")
                self.assert_refused(WRONG_INPUT, ["-options_file case.opts"], "-options_file", "case.opts", ranks=1)

    def test_end_not_after_the_checkpoint(self):
        case = ["-options_file", CAVITY, "-time_end", 0.012, "-output_dir", "out"]
        self.run_well(2, *case)
        self.assert_refused(WRONG_INPUT, ["-time_end 0.012"], *case, "-restart", "out/checkpoint.h5")

    def test_no_options(self):
        self.assert_refused(WRONG_INPUT, ["-grid_cells"])

    def assert_diverges(self, words, *options):
        """Runs a case that writes a checkpoint every step until it diverges; that of the step before must be left."""
        self.assert_refused(DIVERGED, words, *options, "-output_dir", "out")
        out = self.folder / "out"
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "failed")
        steps = read_columns(out / "history.csv")["step"]
        with h5py.File(out / "checkpoint.h5") as checkpoint:
            self.assertEqual(checkpoint.attrs["step"], steps[-1])
        self.assertEqual(list(out.glob("*.part")), [])

    def test_step_too_long_for_the_cloth(self):
        self.assert_diverges(["step", "velocity", "at ("], *EXPLICIT_WASH, "-time_end", 0.3,
                             "-time_step", 3e-3, "-checkpoint_interval", 3e-3)

    def test_step_too_long_for_the_flow(self):
        self.assert_diverges(["step", "velocity", "at ("], "-options_file", CAVITY, "-time_end", 300,
                             "-time_step", 0.5, "-checkpoint_interval", 0.5, "-time_max_cfl", 1e99)

    def test_folder_below_a_file(self):
        (self.folder / "file").touch()
        self.assert_refused(CANNOT_WRITE, ["file/out"], *CASE, "-output_dir", "file/out")

    def test_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        for size in ("4k", "64k", "300k", "1200k", "3000k"):  # of files that are written at different times
            mount = ["unshare", "--mount", "sh", "-c", f'mount -t tmpfs -o size={size} tmpfs "$0" && exec "$@"', disk]
            if subprocess.run([*mount, "true"], capture_output=True, check=False).returncode != 0:
                self.skipTest("only root may mount a small disk")
            with self.subTest(size):
                self.assert_refused(CANNOT_WRITE, ["disk/"], *CASE, "-time_end", 0.5, "-output_interval", 0.002,
                                    "-checkpoint_interval", 0.005, "-output_dir", disk, launcher=mount)


if __name__ == "__main__":
    unittest.main()
