// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/repeat_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "washfsi/shapes/endless.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

constexpr double same = 0.02;      // distances and ends that differ by less are the same [cells]
constexpr double beside = 2;       // distance from the surface up to which differences count [cells]
constexpr double overlap = 0.5;    // depth in two images from which on they overlap [cells]
constexpr double mismatch = 0.75;  // depth on one side of the box, and distance on the other, from which on they differ

/// Finds how one body repeats itself, as it lies at the start.
template <int Dim>
class RepeatFinder {
 public:
  RepeatFinder(const Grid<Dim>& grid, Body<Dim>& body)
      : grid_(grid),
        body_(body),
        pose_(body.motion.pose(0)),
        extent_(body.shape->extent().in_space(pose_)),
        sign_(extent_.of_opening ? -1 : 1),
        cell_(grid.spacing().minCoeff()) {}

  void find() {
    for (int d = 0; d < Dim; ++d)
      if (grid_.periodic(d) && is_long(d) && spans(d)) span(d);
    for (int d = 0; d < Dim; ++d)
      if (has_images(d)) body_.repeats.period[d] = period(d);
    body_.repeats.extent = body_.shape->extent();
    bool any_long = false;
    for (int d = 0; d < Dim; ++d) any_long = any_long || (has_images(d) && is_long(d));
    if (any_long) refuse_overlap();
  }

 private:
  double period(int axis) const { return grid_.upper()[axis] - grid_.lower()[axis]; }
  double size(int axis) const { return extent_.bounds.upper[axis] - extent_.bounds.lower[axis]; }
  double middle(int axis) const {
    return extent_.is_finite(axis) ? 0.5 * (extent_.bounds.lower[axis] + extent_.bounds.upper[axis])
                                   : pose_.center[axis];
  }
  bool is_long(int axis) const { return !extent_.is_finite(axis) || size(axis) > period(axis) - same * cell_; }
  bool has_images(int axis) const { return grid_.periodic(axis) && extent_.is_finite(axis); }
  void span(int axis) {
    body_.repeats.period[axis] = period(axis);
    body_.shape = std::make_unique<Endless<Dim>>(std::move(body_.shape), axis, middle(axis) - pose_.center[axis]);
    extent_ = body_.shape->extent().in_space(pose_);
  }
  // Distance from the body, or from its opening.
  double distance(const Point<Dim>& place) const { return sign_ * body_.shape->distance(pose_.in_body_frame(place)); }

  // Whether it is uniform along an axis: half a period to either side of its middle or, if endless, in the box. Depths
  // inside do not matter.
  bool spans(int axis) const {
    if (axis < 2 && (body_.motion.turns() || pose_.sine != 0 || pose_.cosine != 1)) return false;
    const Bounds<Dim> looked_at = surroundings(axis);
    const Point<Dim> size = looked_at.upper - looked_at.lower;
    Box<Dim> samples{};
    for (int d = 0; d < Dim; ++d)
      samples.upper[d] = std::clamp<PetscInt>(std::lround(size[d] / cell_), 1, 2 * grid_.cells()[d]);
    const int ranks = ranks_of(grid_.comm());
    int number = 0;
    bool differs = false;
    for_each<Dim>(samples, [&](const Index<Dim>& sample) {
      if (number++ % ranks != rank_of(grid_.comm()) || differs) return;
      Point<Dim> place;
      for (int d = 0; d < Dim; ++d) {
        const double part = (static_cast<double>(sample[d]) + 0.5) / static_cast<double>(samples.upper[d]);
        place[d] = looked_at.lower[d] + part * size[d];
      }
      Point<Dim> in_middle = place;
      in_middle[axis] = middle(axis);
      differs = std::abs(outside(place) - outside(in_middle)) > same * cell_;
    });
    return !any_rank(grid_.comm(), differs);
  }
  double outside(const Point<Dim>& place) const { return std::clamp(distance(place), 0.0, beside * cell_); }

  Bounds<Dim> surroundings(int axis) const {
    Bounds<Dim> bounds{grid_.lower(), grid_.upper()};
    for (int d = 0; d < Dim; ++d) {
      if (!extent_.is_finite(d)) continue;
      const double half = d == axis ? 0.5 * period(d) : 0.5 * size(d) + beside * cell_;
      bounds.lower[d] = middle(d) - half;
      bounds.upper[d] = middle(d) + half;
    }
    return bounds;
  }

  void refuse_overlap() const {
    Box<Dim> images{};
    for (int d = 0; d < Dim; ++d) {
      const auto most = static_cast<PetscInt>(has_images(d) ? std::ceil(size(d) / period(d)) + 1 : 0);
      images.lower[d] = -most;
      images.upper[d] = most + 1;
    }
    bool overlaps = false;
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
      int inside = 0;
      if (overlaps) return;
      for_each<Dim>(images, [&](const Index<Dim>& image) { inside += is_inside(cell, image) ? 1 : 0; });
      overlaps = inside > 1;
    });
    if (any_rank(grid_.comm(), overlaps)) refuse();
  }

  bool is_inside(const Index<Dim>& cell, const Index<Dim>& image) const {
    Point<Dim> place = grid_.cell_center(cell);
    for (int d = 0; d < Dim; ++d) {
      if (!has_images(d)) continue;
      const double whole = std::floor((place[d] - middle(d)) / period(d) + 0.5) + static_cast<double>(image[d]);
      place[d] -= period(d) * whole;
    }
    return distance(place) < -overlap * cell_;
  }

  [[noreturn]] void refuse() const {
    std::string axes, lengths;
    for (int d = 0; d < Dim; ++d) {
      if (!has_images(d) || !is_long(d)) continue;
      axes += (axes.empty() ? "" : " and ") + std::string(1, "xyz"[d]);
      lengths += (lengths.empty() ? "" : " and ") + to_text(period(d)) + " m";
    }
    throw InputError("-bodies " + body_.name + ": " + (extent_.of_opening ? "its opening" : "it") +
                     " overlaps its own images along " + axes + ", where the box is periodic after " + lengths +
                     "; a body must be shorter than that, or the same all along it");
  }

  const Grid<Dim>& grid_;
  Body<Dim>& body_;
  Pose<Dim> pose_;
  Extent<Dim> extent_;  ///< extent in space
  double sign_, cell_;
};

// Whether a body passes one end of an axis without meeting a body at the other.
template <int Dim>
bool is_cut_off(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t body, int axis) {
  const double near = mismatch * grid.spacing().minCoeff();
  Box<Dim> ends = grid.owned();
  ends.upper[axis] = std::min<PetscInt>(ends.upper[axis], 1);
  bool cut = false;
  for_each<Dim>(ends, [&](const Index<Dim>& cell) {
    Point<Dim> lower = grid.cell_center(cell), upper = lower;
    lower[axis] = grid.lower()[axis];
    upper[axis] = grid.upper()[axis];
    const auto differ = [&](const Point<Dim>& one, const Point<Dim>& other) {
      if (posed.distance(body, one) > -near) return false;
      double nearest = std::numeric_limits<double>::max();
      for (std::size_t b = 0; b < posed.size(); ++b) nearest = std::min(nearest, posed.distance(b, other));
      return nearest > near;
    };
    cut = cut || differ(lower, upper) || differ(upper, lower);
  });
  return any_rank(grid.comm(), cut);
}

template <int Dim>
void refuse_what_is_cut_off(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies) {
  const PosedBodies<Dim> posed(bodies, 0);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int d = 0; d < Dim; ++d) {
      if (!grid.periodic(d) || bodies[b].repeats.period[d] > 0 || !is_cut_off(grid, posed, b, d)) continue;
      const std::string axis(1, "xyz"[d]);
      throw InputError("-bodies " + bodies[b].name + ": it goes on without end along " + axis +
                       ", where the box is periodic, and does not meet itself or another body behind the side; end it "
                       "within the box, or let it be the same all along " +
                       axis);
    }
}

}  // namespace

template <int Dim>
std::vector<Body<Dim>> repeat_bodies(const Grid<Dim>& grid, std::vector<Body<Dim>> bodies) {
  bool any = false;
  for (int d = 0; d < Dim; ++d) any = any || grid.periodic(d);
  if (!any) return bodies;
  for (auto& body : bodies) RepeatFinder<Dim>(grid, body).find();
  refuse_what_is_cut_off<Dim>(grid, bodies);
  return bodies;
}

template std::vector<Body<2>> repeat_bodies<2>(const Grid<2>&, std::vector<Body<2>>);
template std::vector<Body<3>> repeat_bodies<3>(const Grid<3>&, std::vector<Body<3>>);

}  // namespace washfsi
