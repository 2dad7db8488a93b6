# SPDX-License-Identifier: BSD-3-Clause
"""The view of the playback shows the subject as large as fits: what has to be seen, and where the camera stands for it."""

import itertools
import sys
import types
import unittest

import numpy as np

import browser
from support import SOURCE

sys.path.insert(0, str(SOURCE / "python"))
from washfsi.report.scene import AROUND, WAKE, Subject, scene_of, stream_of  # noqa: E402

WEB = SOURCE / "python" / "washfsi" / "report" / "web"
MARGIN = 0.05  # share of the picture that is free at each side
RANDOM = np.random.default_rng(5)


def subject_of(points):
    """Returns the subject that some points make."""
    subject = Subject()
    subject.add(np.asarray(points, float))
    return subject


class Flow:
    """A series of one frame with a uniform velocity, in a box from -20 to 20 m."""

    def __init__(self, dim, velocity):
        self.dim, self.lower, self.upper = dim, np.full(dim, -20.0), np.full(dim, 20.0)
        self.velocity = np.tile(np.array(velocity, float), (4, 4, 1))

    def __len__(self):
        return 1

    def frame(self, _):
        """Returns the frame."""
        return {"velocity": self.velocity}


class Scene(unittest.TestCase):
    """What has to be seen of a run."""

    def scene(self, subject, enclosed=False, velocity=(0, 0, 0), fluid="water", dim=2):
        """Returns the scene of a run, with its points as they are before they are packed."""
        results = types.SimpleNamespace(flow=Flow(dim, velocity), options={"fluid": fluid})
        return scene_of(results, subject, enclosed, types.SimpleNamespace(add=np.array))

    def test_the_farthest_points_stand_for_all(self):
        cube = list(itertools.product((0, 1), repeat=3))
        inside = RANDOM.uniform(0.05, 0.95, (500, 3))
        self.assertEqual(sorted(map(tuple, subject_of([*inside, *cube]).points)), [tuple(map(float, corner)) for corner in cube])
        ball = RANDOM.normal(size=(20000, 3))
        ball /= np.linalg.norm(ball, axis=1, keepdims=True)
        kept = subject_of(ball).points
        self.assertLess(len(kept), 250)
        for direction in RANDOM.normal(size=(50, 3)):
            self.assertGreater((kept @ direction).max(), 0.985 * np.linalg.norm(direction))

    def test_points_that_are_no_numbers_are_left_out(self):
        self.assertEqual(subject_of([[np.nan, 0, 0]]).points.shape, (0, 3))
        self.assertEqual(subject_of([[np.nan, 0, 0], [1, 2, 3]]).points.tolist(), [[1, 2, 3]])

    def test_a_moving_body_counts_in_every_frame(self):
        quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        motion = np.array([[*np.eye(3).ravel(), 0, 0, 0], [*quarter.ravel(), 0, 0, 5]])
        subject = Subject()
        subject.add_moving(np.array([[0, 0, 0], [2.0, 0, 0]]), motion)
        np.testing.assert_allclose(subject.points.min(axis=0), [0, 0, 0])
        np.testing.assert_allclose(subject.points.max(axis=0), [2, 2, 5])

    def test_a_stream_is_a_velocity_common_to_most_of_the_water(self):
        uniform = np.tile([0.0, 3.0, 0.0], (8, 8, 1))
        np.testing.assert_allclose(stream_of(uniform + RANDOM.normal(0, 0.3, uniform.shape)), [0, 1, 0], atol=0.1)
        turning = np.stack(np.meshgrid(np.arange(-4, 5.0), np.arange(-4, 5.0), [0.0])[:2], axis=-1)
        np.testing.assert_array_equal(stream_of(np.stack([-turning[..., 1], turning[..., 0]], axis=-1)), [0, 0])
        np.testing.assert_array_equal(stream_of(np.zeros((4, 4, 3))), [0, 0, 0])

    def test_water_round_the_subject_and_its_wake_are_seen(self):
        circle = subject_of([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
        rest, stream = self.scene(circle), self.scene(circle, velocity=(-2, 0, 0))
        side = 1 + AROUND * 2
        self.assertEqual((rest["lower"], rest["upper"], rest["open"]), ([-side, -side], [side, side], True))
        self.assertEqual((stream["lower"], stream["upper"]), ([-side - WAKE * 2, -side], [side, side]))

    def test_nothing_is_seen_beyond_the_box(self):
        large = self.scene(subject_of([[-30, -9, 0], [15, 9, 0]]))
        self.assertEqual((large["lower"], large["upper"]), ([-20, -20], [20, 20]))
        self.assertEqual(large["points"].min(), -20)

    def test_without_open_water_only_the_subject_is_seen(self):
        points = [[1, 0, 0], [-1, 0, 0], [0, 2, 0]]
        for scene in (self.scene(subject_of(points), fluid="none"), self.scene(subject_of(points), enclosed=True)):
            self.assertEqual((scene["lower"], scene["upper"], scene["open"]), ([-1, 0], [1, 2], False))

    def test_without_a_subject_all_of_the_box_is_seen(self):
        for dim in (2, 3):
            scene = self.scene(Subject(), dim=dim)
            self.assertEqual((scene["lower"], scene["upper"], scene["open"]), ([-20] * dim, [20] * dim, False))
            self.assertEqual({tuple(point[:dim]) for point in scene["points"]}, set(itertools.product((-20, 20), repeat=dim)))


@unittest.skipUnless(browser.there(), browser.MISSING)
class Camera(unittest.TestCase):
    """Where the camera stands, as the page finds it."""

    @classmethod
    def setUpClass(cls):
        cls.page = browser.Browser()
        cls.addClassCleanup(cls.page.close)
        cls.page.driver.get("data:text/html,")

    def of_page(self, file, call, *given):
        """Returns what a function of a script of the page returns."""
        code = (WEB / file).read_text(encoding="utf-8")
        return self.page.driver.execute_script(f"{code}\nreturn {call}(...arguments);", *given)

    def shares(self, points, axes, slopes):
        """Returns where a fitted camera sees points: shares of half of the picture, to the right and up."""
        place = self.of_page("fit.js", "fittedPlace", points.tolist(), axes.tolist(), list(slopes))
        seen = points @ axes.T - place
        self.assertGreater(seen[:, 2].min(), 0)
        return seen[:, :2] / seen[:, 2:] / slopes

    def test_the_picture_is_filled_to_its_margin(self):
        corners = np.array(list(itertools.product((0.0, 1.0), repeat=3)))
        for aspect in (0.4, 1, 1200 / 760, 5):
            for size in ((1, 1, 1), (10, 1, 0.1), (0.1, 0.1, 8), (3, 2, 0)):
                points = RANDOM.normal(size=3) + corners * size
                axes = np.linalg.qr(RANDOM.normal(size=(3, 3)))[0]
                shares = self.shares(points, axes, np.array([aspect, 1]) * np.tan(np.radians(15)))
                low, high = shares.min(axis=0), shares.max(axis=0)
                filled = np.isclose(low, 2 * MARGIN - 1) & np.isclose(high, 1 - 2 * MARGIN)
                with self.subTest(aspect=aspect, size=size):
                    self.assertTrue(filled.any(), (low, high))  # one of width and height, to both sides
                    self.assertTrue((np.abs(shares) < 1 - 2 * MARGIN + 1e-9).all(), (low, high))

    def test_times_have_the_digits_of_the_run(self):
        for time, end, text in ((1.2, 1.5708, "1.20 s"), (9, 12, "9.0 s"), (75.3, 100, "75 s"), (0.3, 0.4, "0.300 s"),
                                (0, 0, "0 s"), (1e4, 2e4, "10000 s")):
            self.assertEqual(self.of_page("numbers.js", "timeText", time, end), text)


if __name__ == "__main__":
    unittest.main()
