// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/body_markers.hpp"

#include <gtest/gtest.h>

#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

Body<2> ball(double x, double radius) {
  Body<2> body;
  body.name = "ball";
  body.shape = std::make_unique<Sphere<2>>(radius);
  body.motion.center = Point<2>(x, 0.5);
  return body;
}

GridShape<2> unit_box(PetscInt n) {
  GridShape<2> shape;
  shape.cells = {n, n};
  return shape;
}

// What lies behind another body's markers has no water to hold.
TEST(BodyMarkers, DoNotActBehindAnotherBodysSurface) {
  const Grid<2> grid(PETSC_COMM_WORLD, unit_box(50));
  std::vector<Body<2>> bodies;
  bodies.push_back(ball(0.4, 0.2));
  bodies.push_back(ball(0.6, 0.2));
  const double cell = grid.spacing()[0];
  const KernelMoments moments(DeltaKernel::yang, 2);
  BodyMarkers<2> markers(grid, bodies, {grid.spacing(), 1.2, moments});
  const PosedBodies<2> posed(bodies, 0);
  const double behind = cell * moments.retraction(10);
  int covered = 0;
  for (std::size_t p = 0; p < markers.patches(); ++p)
    for (std::size_t m = markers.start(p); m < markers.start(p + 1); ++m) {
      const std::size_t body = markers.body_of(p);
      const Point<2> place = posed.in_space(body, markers.arm(m));
      const double depth = -posed.distance(1 - body, place);
      EXPECT_EQ(markers.at(posed, p, m).acts, depth <= behind) << place.transpose();
      covered += depth > behind ? 1 : 0;
    }
  EXPECT_GT(covered, 20);
}

}  // namespace
}  // namespace washfsi::test
