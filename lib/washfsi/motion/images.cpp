// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/images.hpp"

#include <algorithm>

namespace washfsi {

// Finds which images may be nearer than the first, whose middle is within half a period of a place.
template <int Dim>
void Images<Dim>::find(const Pose<Dim>& pose) {
  const Extent<Dim> extent = repeats_.extent.in_space(pose);
  sign_ = extent.of_opening ? -1 : 1;
  for (int d = 0; d < Dim; ++d) {
    const bool finite = extent.is_finite(d);
    middle_[d] = finite ? 0.5 * (extent.bounds.lower[d] + extent.bounds.upper[d]) : pose.center[d];
    half_[d] = finite ? 0.5 * (extent.bounds.upper[d] - extent.bounds.lower[d]) : std::numeric_limits<double>::max();
    const bool has_others = finite && repeats_.period[d] > 0;
    const auto most = static_cast<PetscInt>(has_others ? std::ceil(half_[d] / repeats_.period[d] + 0.5) : 0);
    others_.lower[d] = -most;
    others_.upper[d] = most + 1;
  }
}

// A place relative to the image whose middle is nearest along each axis.
template <int Dim>
typename Images<Dim>::Aside Images<Dim>::first(const Point<Dim>& place) const {
  Aside aside{place, {}};
  for (int d = 0; d < Dim; ++d) {
    const double period = repeats_.period[d];
    if (period == 0) continue;
    aside.image[d] = static_cast<PetscInt>(std::floor((place[d] - middle_[d]) / period + 0.5));
    aside.place[d] -= static_cast<double>(aside.image[d]) * period;
  }
  return aside;
}

// A lower bound of the distance from all other images.
template <int Dim>
double Images<Dim>::next_image(const Aside& from) const {
  double least = std::numeric_limits<double>::max();
  for (int d = 0; d < Dim; ++d)
    if (others_.upper[d] > 1)
      least = std::min(least, repeats_.period[d] - std::abs(from.place[d] - middle_[d]) - half_[d]);
  return least;
}

template <int Dim>
double Images<Dim>::gap() const {
  double least = std::numeric_limits<double>::infinity();
  for (int d = 0; d < Dim && any_; ++d)
    if (others_.upper[d] > 1) least = std::min(least, repeats_.period[d] - 2 * half_[d]);
  return least;
}

template class Images<2>;
template class Images<3>;

}  // namespace washfsi
