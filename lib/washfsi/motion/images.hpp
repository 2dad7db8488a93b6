// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/grid/index.hpp"
#include "washfsi/shapes/extent.hpp"

namespace washfsi {

/// The repetition of a body along the periodic axes of a box.
template <int Dim>
struct Repeats {
  Point<Dim> period = Point<Dim>::Zero();        ///< period of its images along each axis; 0 where it has none [m]
  Extent<Dim> extent = Extent<Dim>::infinite();  ///< extent in its frame

  bool any() const { return !period.isZero(0); }
  /// Whether it is uniform along an axis and continues through the sides: all its images are one.
  bool spans(int axis) const { return period[axis] > 0 && !extent.is_finite(axis); }
};

/// The images of a body at one moment: its distance is that from the nearest of them.
template <int Dim>
class Images {
 public:
  Images(const Repeats<Dim>& repeats, const Pose<Dim>& pose) : repeats_(repeats), any_(repeats.any()) {
    if (any_) find(pose);
  }

  /// The distance of a place from the nearest image, and which that is: how many periods from the body itself.
  struct Nearest {
    double distance;
    Index<Dim> image;
  };
  /// Finds it; `distance(place)` is that of the body itself.
  template <class Distance>
  Nearest nearest(const Point<Dim>& place, const Distance& distance) const {
    if (!any_) return {distance(place), {}};
    const Aside from = first(place);
    Nearest best{distance(from.place), from.image};
    if (next_image(from) < std::max(0.0, sign_ * best.distance)) look_further(from, distance, best);
    return best;
  }

  /// Approximate distance to the next image [m]; infinite without one.
  double gap() const;
  /// Whether there are images other than the body itself.
  bool any() const { return any_; }
  /// How far an image lies from the body itself [m].
  Point<Dim> shift(const Index<Dim>& image) const {
    Point<Dim> shift;
    for (int d = 0; d < Dim; ++d) shift[d] = static_cast<double>(image[d]) * repeats_.period[d];
    return shift;
  }

 private:
  /// A place as one image sees it.
  struct Aside {
    Point<Dim> place;
    Index<Dim> image;
  };
  void find(const Pose<Dim>& pose);
  Aside first(const Point<Dim>& place) const;
  double next_image(const Aside& from) const;
  double least_distance(const Point<Dim>& place) const {
    return ((place - middle_).cwiseAbs() - half_).cwiseMax(0.0).norm();
  }

  // Takes an image if the place is deeper in it, or nearer to it, than to the first.
  template <class Distance>
  void look_further(const Aside& from, const Distance& distance, Nearest& best) const {
    for_each<Dim>(others_, [&](const Index<Dim>& other) {
      if (other == Index<Dim>{}) return;
      const Point<Dim> place = from.place - shift(other);
      const double least = least_distance(place);
      if (least > 0 && least >= sign_ * best.distance) return;
      const double found = distance(place);
      if (sign_ * found >= sign_ * best.distance) return;
      best.distance = found;
      for (int d = 0; d < Dim; ++d) best.image[d] = from.image[d] + other[d];
    });
  }

  const Repeats<Dim>& repeats_;
  bool any_;
  double sign_ = 1;           ///< -1 where the bounds are of the opening: a place open in one image is open
  Point<Dim> middle_, half_;  ///< middle and half size of the bounds in space [m]; infinite without bounds
  Box<Dim> others_{};         ///< images that may be nearer than the first, counted from it
};

extern template class Images<2>;
extern template class Images<3>;

}  // namespace washfsi
