# SPDX-License-Identifier: BSD-3-Clause
"""Contact that must not fail: stacks that lie still, cloths that start in contact, and towels that fall onto thin things."""

import json
import unittest

import h5py
import numpy as np

from support import ProgramTest, read_columns, run

# Cloths of 8 x 8 markers that lie one on another, a millimetre apart, without water.
STACK = """
-grid_cells 12,12,12
-grid_upper 0.3,0.3,0.3
-fluid none
-gravity 0,0,-9.81
-cloths a
-a_count 3
-a_size 0.2
-a_markers 8
-a_ke 800
-a_kb 1e-5
-a_excess_mass 0.3
-a_placement stack
-a_center 0.15,0.15,0.003
-a_distance 0.001
-contact barrier
-time_step 2e-3
-time_end 0.6
-output_interval 1
""".split()
SMOOTH = ["-contact_friction", 0, "-contact_body_friction", 0]
# A towel above something that stands on its axis.
DROP = """
-grid_cells 20,20,20
-grid_lower -0.2,-0.2,-0.1
-grid_upper 0.2,0.2,0.3
-fluid none
-gravity 0,0,-9.81
-cloths a
-a_size 0.2
-a_markers 10
-a_ke 800
-a_kb 1e-4
-a_excess_mass 0.3
-a_center 0.011,0.007,0.06
-contact barrier
-bodies b
-time_step 2e-3
-time_end 0.35
-output_interval 0.05
""".split()


def segment(points, start, end):
    """Distances of points from a segment."""
    way = np.subtract(end, start)
    part = np.clip((points - start) @ way / (way @ way), 0, 1)
    return np.linalg.norm(points - start - part[..., None] * way, axis=-1)


def box(points, center, size):
    beyond = np.abs(points - center) - np.divide(size, 2)
    return np.linalg.norm(np.maximum(beyond, 0), axis=-1) + np.minimum(beyond.max(axis=-1), 0)


def cone(points, radius, height, base):
    """A solid cone that stands on its base."""
    flat = np.stack([np.linalg.norm(points[..., :2], axis=-1), points[..., 2] - base], axis=-1)
    outside = np.minimum(segment(flat, (0, 0), (radius, 0)), segment(flat, (radius, 0), (0, height)))
    inside = (flat[..., 1] > 0) & (flat[..., 0] / radius + flat[..., 1] / height < 1)
    return np.where(inside, -outside, outside)


# What towels fall onto: the options of its shape, and its signed distance, written here anew.
THINGS = {
    "post of 6 mm": (["-b_shape", "capsule", "-b_from", "0,0,-0.1", "-b_to", "0,0,0", "-b_radius", 0.003],
                     lambda x: segment(x, (0, 0, -0.1), (0, 0, 0)) - 0.003),
    "plate of 2 mm on edge": (["-b_shape", "box", "-b_size", "0.12,0.002,0.08", "-b_center", "0,0,-0.04"],
                              lambda x: box(x, (0, 0, -0.04), (0.12, 0.002, 0.08))),
    "plate of 1 mm": (["-b_shape", "box", "-b_size", "0.1,0.1,0.001"], lambda x: box(x, (0, 0, 0), (0.1, 0.1, 0.001))),
    "corner of a box": (["-b_shape", "box", "-b_size", "0.03,0.03,0.05", "-b_center", "0,0,-0.03", "-b_turn", 30],
                        None),
    "tip of a cone": (["-b_shape", "revolution", "-b_profile", "0,0,0.02,0,0,0.06", "-b_center", "0,0,-0.06"],
                      lambda x: cone(x, 0.02, 0.06, -0.06)),
}
SAMPLES = np.array([(i, j, 12 - i - j) for i in range(13) for j in range(13 - i)]) / 12


def least_distance(markers, width, distance):
    """Of all triangles of a cloth, each in 91 places."""
    grid = markers.reshape(-1, width, 3)
    corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    a, b, c, d = (corner.reshape(-1, 3) for corner in corners)
    return min(distance(np.einsum("si,itx->tsx", SAMPLES, np.stack(triangle))).min() for triangle in ((a, b, c), (a, c, d)))


class ContactRobustness(ProgramTest):
    def frames(self, name="out"):
        with h5py.File(self.folder / name / "cloth.h5") as file:
            frames = sorted(file["frames"].values(), key=lambda frame: frame.attrs["time"])
            return [(frame["position"][:], frame["velocity"][:]) for frame in frames]

    def history(self, *options, ranks=1, name="out"):
        self.run_well(ranks, *options, "-output_dir", name)
        return read_columns(self.folder / name / "history.csv")

    def motion(self, *options):
        """The largest speed at the end, and how far the cloths of a stack have turned [degrees] and gone aside [m]."""
        history = self.history(*STACK, *options)
        self.assertEqual(history["intersections"].max(), 0)
        frames = self.frames()
        (start, _), (end, velocity) = frames[0], frames[-1]
        turns, ways = [], []
        for before, after in zip(start.reshape(-1, 64, 3), end.reshape(-1, 64, 3)):
            arms, later = (places[:, :2] - places[:, :2].mean(axis=0) for places in (before, after))
            product = arms.T @ later
            turns.append(np.degrees(np.arctan2(product[0, 1] - product[1, 0], product.trace())))
            ways.append(np.abs((after - before).mean(axis=0)[:2]).max())
        heights = end.reshape(-1, 64, 3)[:, :, 2].mean(axis=1)
        return np.abs(velocity).max(), np.abs(turns).max(), max(ways), heights

    def test_a_stack_lies_still(self):
        for options in (SMOOTH, ["-contact_friction", 0.4], [*SMOOTH, "-a_center", "0.15,0.15,0.0102", "-a_distance", 0.0045],
                        [*SMOOTH, "-time_step", 4e-3, "-a_distance", 2e-4]):
            with self.subTest(options=options):
                speed, turn, way, heights = self.motion(*options)
                self.assertLess(speed, 1e-6)
                self.assertLess(turn, 1e-3)
                self.assertLess(way, 1e-6)
                self.assertGreater(np.diff([0, *heights]).min(), 0)

    def test_a_stack_that_starts_in_contact_is_not_thrown_apart(self):
        speed, turn, way, heights = self.motion(*SMOOTH, "-gravity", "0,0,0")
        self.assertEqual((speed, turn, way), (0, 0, 0))
        np.testing.assert_allclose(heights, (0.003, 0.004, 0.005), rtol=0, atol=1e-15)
        out = self.run_well(1, *STACK, "-check")
        self.assertIn("3 pairs start nearer than 0.004 m, from 0.001 m", out)
        self.assertIn("3 pairs start nearer than 0.01 m, from 0.003 m", out)

    def test_what_falls_comes_to_rest_whatever_the_step(self):
        """Short steps hardly damp by themselves: what is left of the motion is lost where cloths meet."""
        falls = [*STACK, "-a_count", 2, "-a_markers", 6, "-a_center", "0.15,0.15,0.014", "-a_distance", 0.004, "-time_step", 2e-4,
                 "-time_end", 0.3]
        damped = self.history(*falls)["kinetic_energy"]
        bounces = self.history(*falls, "-contact_damping", 0)["kinetic_energy"]
        self.assertLess(damped[-1], 1e-6 * damped.max())
        self.assertGreater(bounces[-1], 1e3 * damped[-1])

    def test_the_gap_of_a_stack_is_that_of_the_barriers_law(self):
        """A sheet that carries the weight of w per area is as near as -kappa b'(s) = w has it."""
        _, _, _, heights = self.motion("-a_center", "0.15,0.15,0.0102", "-a_distance", 0.0045, "-time_end", 1)
        distance = 0.16 * 0.2 / 8
        for below, gap in enumerate(np.diff(heights)):
            weight = 0.3 * 9.81 * (2 - below)
            s = np.linspace(0.5, 1, 100001)[1:-1]
            pressure = 1e4 * (2 * (s - 1) * np.log(s) + (s - 1)**2 / s)
            expected = distance * s[np.argmin(np.abs(pressure - weight))]
            self.assertLess(abs(gap - expected), 0.02 * distance)

    def test_what_starts_in_contact_goes_on_to_the_bit_after_a_restart(self):
        for ranks in (1, 2):
            options = [*STACK, "-a_count", 2, "-a_direction", "1,0.02,0.001", "-time_end"]
            straight = self.history(*options, 0.1, ranks=ranks, name="straight")
            self.history(*options, 0.05, ranks=ranks, name="half")
            restarted = self.history(*options, 0.1, "-restart", "half/checkpoint.h5", ranks=ranks, name="half")
            for column, values in straight.items():
                with self.subTest(ranks=ranks, column=column):
                    np.testing.assert_array_equal(restarted[column], values)

    def test_nothing_goes_through_a_towel_that_falls_onto_it(self):
        for name, (shape, distance) in THINGS.items():
            history = self.history(*DROP, *shape)
            with self.subTest(thing=name):
                self.assertEqual(history["intersections"].max(), 0)
                self.assertEqual(history["body_intersections"].max(), 0)
                self.assertGreater(history["a_body_contact_force"].max(), 0)
                if distance:
                    least = min(least_distance(places, 10, distance) for places, _ in self.frames())
                    print(f"{name}: {1e3 * least:.2f} mm at least")
                    self.assertGreater(least, 0)

    def test_a_post_between_markers_is_told_of(self):
        """Without contact; the barrier refuses to begin with it."""
        post = THINGS["post of 6 mm"][0]
        history = self.history(*DROP, *post, "-contact", "none", "-contact_verify_interval", 0.05,
                               "-coupling_scheme", "implicit")
        self.assertGreater(history["body_intersections"].max(), 0)
        self.assertGreater(history["a_depth"].max(), 1e-3)
        outcome = run(1, *DROP, *post, "-a_center", "0.011,0.007,-0.02", "-output_dir", "within", folder=self.folder)
        self.assertEqual(outcome.returncode, 2, outcome.stdout)
        self.assertIn("-contact barrier: at the start a 1 reaches 0.0027 m into b at", outcome.stderr)

    def test_tilted_towels_hit_the_floor_and_each_other(self):
        for direction, across in (("1,0.2,0.5", "0,1,0"), ("1,0.1,0.02", "0.02,0.05,1")):
            history = self.history(*STACK, "-a_direction", direction, "-a_across", across, "-a_center", "0.15,0.15,0.16",
                                   "-a_distance", 0.015, "-time_end", 0.3, "-time_step", 4e-3)
            self.assertEqual(history["intersections"].max(), 0)
            self.assertGreater(history["a_contact_force"].max(), 0)

    def test_a_post_does_not_go_through_a_towel_in_water(self):
        self.history(*DROP, *THINGS["post of 6 mm"][0], "-fluid", "water", "-fluid_viscosity", 0.1, "-a_excess_mass", 2,
                     "-a_center", "0.011,0.007,0.02", "-body_method", "direct_forcing", "-coupling_order", 1, "-time_step", 4e-3,
                     "-time_cfl", 0.5, "-time_end", 0.6)
        least = min(least_distance(places, 10, THINGS["post of 6 mm"][1]) for places, _ in self.frames())
        self.assertGreater(least, 0)

    def test_a_failure_names_the_contact(self):
        self.history(*STACK, "-time_end", 0.02)
        outcome = run(1, *STACK, "-restart", "out/checkpoint.h5", "-time_end", 0.03, "-cloth_snes_max_it", 0,
                      folder=self.folder)
        self.assertEqual(outcome.returncode, 3, outcome.stderr)
        self.assertRegex(outcome.stderr, r"the tightest contact: a \d (is|and) .* m (from a side of the box|apart) at \(")
        for words in ("velocity was last seen", "mobility"):
            self.assertNotIn(words, outcome.stderr)

    def test_the_options_of_a_run_without_water_make_the_same_run(self):
        first = self.history(*STACK, "-time_end", 0.02, name="first")
        again = self.history("-options_file", "first/resolved.opts", name="again")
        np.testing.assert_array_equal(again["a_center_z"], first["a_center_z"])
        self.assertEqual(json.loads((self.folder / "again" / "summary.json").read_text())["status"], "finished")


if __name__ == "__main__":
    unittest.main()
