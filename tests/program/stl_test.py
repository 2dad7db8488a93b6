# SPDX-License-Identifier: BSD-3-Clause
"""A ball from an STL file takes the loads of the analytic ball, within the error of its facets."""

import json
import unittest

import numpy as np

from support import ProgramTest

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


if __name__ == "__main__":
    unittest.main()
