// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/closed_walls.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

/// A ball and, if it has a radius, another a third of the box to its right.
class Balls {
 public:
  explicit Balls(double radius_of_other = 0)
      : grid_(PETSC_COMM_WORLD, shape()),
        markers_(grid_, bodies(radius_of_other), {grid_.spacing(), 1, KernelMoments(DeltaKernel::yang, 2)}),
        walls_(grid_, bodies_, markers_) {
    const PosedBodies<2> posed(bodies_, 0);
    for (std::size_t p = begin(); p < end(); ++p)
      for (std::size_t m = markers_.start(p); m < markers_.start(p + 1); ++m)
        states_.push_back(markers_.at(posed, p, m));
    walls_.update(states_, 0);
  }

  /// A value on each patch of this rank, by the direction from the ball's middle and by its number of markers.
  template <class Value>
  Points<2> values(Value&& value) const {
    Points<2> result;
    for (std::size_t p = begin(); p < end(); ++p) {
      Point<2> middle = Point<2>::Zero();
      for (std::size_t m = markers_.start(p); m < markers_.start(p + 1); ++m) middle += markers_.arm(m);
      result.push_back(markers_.body_of(p) > 0 ? Point<2>(Point<2>::Zero())
                                               : value(middle.normalized(), markers_.start(p + 1) - markers_.start(p)));
    }
    return result;
  }

  /// The largest of what is left of values, over the largest of them.
  double left_of(const Points<2>& values) const {
    Points<2> left = values;
    walls_.remove_from(left);
    double most = 0, of_all = 0;
    for (std::size_t p = 0; p < left.size(); ++p) {
      most = std::max(most, left[p].norm());
      of_all = std::max(of_all, values[p].norm());
    }
    return largest(PETSC_COMM_WORLD, most) / largest(PETSC_COMM_WORLD, of_all);
  }

 private:
  static GridShape<2> shape() {
    GridShape<2> shape;
    shape.cells.fill(40);
    shape.ghost_width = 3;
    return shape;
  }
  const std::vector<Body<2>>& bodies(double radius_of_other) {
    bodies_.resize(radius_of_other > 0 ? 2 : 1);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      bodies_[b].shape = std::make_unique<Sphere<2>>(b == 0 ? 0.2 : radius_of_other);
      bodies_[b].motion.center = {0.4 + 0.33 * static_cast<double>(b), 0.52};
    }
    return bodies_;
  }
  std::size_t begin() const { return markers_.own().begin; }
  std::size_t end() const { return markers_.own().end; }

  Grid<2> grid_;
  std::vector<Body<2>> bodies_;
  BodyMarkers<2> markers_;
  ClosedWalls<2> walls_;
  std::vector<BodyMarkers<2>::State> states_;
};

Point<2> push(const Point<2>& out, std::size_t markers) {
  return static_cast<double>(markers) * out;
}

TEST(ClosedWalls, LoseAPressureThatNoWaterFeels) {
  const Balls ball;
  EXPECT_LT(ball.left_of(ball.values(push)), 0.02);
}

TEST(ClosedWalls, KeepWhatTurnsOrMovesTheWater) {
  const Balls ball;
  EXPECT_NEAR(ball.left_of(ball.values([](const Point<2>& out, std::size_t markers) {
    return Point<2>(static_cast<double>(markers) * Point<2>(-out[1], out[0]));
  })),
              1, 0.02);
  EXPECT_NEAR(ball.left_of(ball.values(
                  [](const Point<2>&, std::size_t markers) { return Point<2>(static_cast<double>(markers), 0); })),
              1, 0.1);
}

TEST(ClosedWalls, AreOpenWhereAnotherBodyCoversThem) {
  const Balls apart(0.05), together(0.2);
  EXPECT_LT(apart.left_of(apart.values(push)), 0.02);
  EXPECT_EQ(together.left_of(together.values(push)), 1);
}

}  // namespace
}  // namespace washfsi::test
