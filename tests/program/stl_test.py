# SPDX-License-Identifier: BSD-3-Clause
"""A ball from an STL file takes the loads of the analytic ball, within the error of its facets; the shipped agitator is what
its script writes, closed and of the right volume, and runs."""

import json
import subprocess
import unittest

import numpy as np

from support import SOURCE, ProgramTest, read_columns

RADIUS = 0.4
CASE = ["-grid_cells", "24,24,24", "-grid_lower", "-1,-1,-1", "-grid_upper", "1,1,1", "-fluid_viscosity", 0.05,
        "-fluid_density", 1, "-bodies", "ball", "-body_method", "cut_stencil", "-ball_angular_speed", 3,
        "-ball_velocity", "0.5,0,0", "-ball_center", "-0.05,0,0", "-time_step", 0.02, "-time_end", 0.2]


def sphere_facets(parts):
    """Triangles of a sphere: the faces of an octahedron, each side divided into so many parts, pushed outwards."""
    corners = np.array([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
    facets = []
    for quarter in range(4):
        for pole in (1, -1):
            a, b, c = corners[quarter], corners[(quarter + 1) % 4], np.array([0, 0, pole], float)
            at = {(i, j): RADIUS * (p := (i * a + j * b + (parts - i - j) * c)) / np.linalg.norm(p)
                  for i in range(parts + 1) for j in range(parts + 1 - i)}
            for i, j in at:
                if i + j < parts:
                    facets.append([at[i, j], at[i + 1, j], at[i, j + 1]][::pole])
                if i + j < parts - 1:
                    facets.append([at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]][::pole])
    return facets


def write_ascii(path, facets):
    """Writes the triangles; their normals are for the reader to find."""
    lines = ["solid ball"]
    for facet in facets:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x!r} {y!r} {z!r}" for x, y, z in facet]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid ball", ""]))


class Stl(ProgramTest):
    """Loads of a turning and moving ball."""

    def loads(self, *options):
        self.run_well(2, *CASE, *options, "-output_dir", "out")
        body = json.loads((self.folder / "out" / "summary.json").read_text())["bodies"]["ball"]
        return np.array([body["force"][0], body["torque"][2]])

    def test_ball(self):
        exact = self.loads("-ball_shape", "sphere", "-ball_radius", RADIUS)
        errors = []
        for parts in (8, 16):
            write_ascii(self.folder / "ball.stl", sphere_facets(parts))
            found = self.loads("-ball_shape", "stl", "-ball_file", "ball.stl")
            errors.append(np.abs(found / exact - 1))
        print("relative errors of drag and torque, 8 and 16 facets a quarter:", *errors)
        self.assertLess(errors[0].max(), 0.06)
        self.assertLess(errors[1].max(), 0.02)
        self.assertLess(errors[1].max(), 0.5 * errors[0].max())


class Agitator(ProgramTest):
    """inputs/agitator_stl.opts, and the script that writes its surface."""

    SHIPPED = SOURCE / "inputs" / "agitator_stl" / "agitator.stl"

    def write(self, *words):
        """Writes an agitator; returns the file's bytes."""
        path = self.folder / "agitator.stl"
        subprocess.run([SOURCE / "scripts" / "write-agitator", path, *words], check=True, capture_output=True)
        return path.read_bytes()

    @staticmethod
    def volume(file):
        """Returns the volume within the facets of a binary STL file, those of solids that overlap counted twice."""
        facets = np.frombuffer(file[84:], np.dtype([("numbers", "<f4", (4, 3)), ("rest", "<u2")]))["numbers"][:, 1:]
        a, b, c = np.moveaxis(facets.astype(float), 1, 0)
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6

    def test_script_writes_the_shipped_one(self):
        self.assertEqual(self.write(), self.SHIPPED.read_bytes())

    def test_volume_is_that_of_its_parts(self):
        def prism(radius, height):
            return 18 * np.sin(np.pi / 18) * radius**2 * height
        for words, vanes, thickness in (((), 4, 30), (("--vanes", "3", "--thickness", "20", "--lean", "-25"), 3, 20)):
            expected = prism(160, 30) + prism(30, 165) + vanes * 130 * thickness * 65
            self.assertAlmostEqual(self.volume(self.write(*words)) / expected, 1, 6)

    def test_case_runs_to_and_fro(self):
        self.run_well(1, "-options_file", SOURCE / "inputs" / "agitator_stl.opts", "-grid_cells", "16,16,10",
                      "-towel_markers", 4, "-time_step", 5e-3, "-time_end", 0.2, "-output_dir", "out")
        history = read_columns(self.folder / "out" / "history.csv")
        self.assertLess(history["agitator_torque_z"][5:].max(), 0)  # against the way it turns, counter-clockwise
        self.assertGreater(history["agitator_power"][5:].min(), 0)


if __name__ == "__main__":
    unittest.main()
