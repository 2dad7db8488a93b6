// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/wall_law/body_wall_law.hpp"

namespace washfsi {

/// How the water slides along patches of markers: where a law of friction acts, no slip is asked only along the
/// normals. All values are of this rank's patches.
template <int Dim>
class PatchSliding {
 public:
  explicit PatchSliding(PatchRange own) : own_(own) {}

  /// From the next `turn` on, the water slides where this law acts. `law` is for these patches and stays alive.
  void let_slide(const BodyWallLaw<Dim>& law);
  const BodyWallLaw<Dim>* law() const { return law_; }
  /// Turns the normals with their bodies: in_space(normals) turns vectors from the frames of the bodies into space.
  template <class InSpace>
  void turn(const InSpace& in_space) {
    if (law_) normals_ = in_space(frame_normals_);
  }

  /// How the water slides along a patch; not at all without a law.
  PatchSlide slide(std::size_t patch) const { return law_ ? law_->patch_slides()[own_.begin + patch] : PatchSlide{}; }
  /// The part of a patch's velocity or force on which no slip acts: without what is free to slide.
  Point<Dim> constrained(const Point<Dim>& value, std::size_t patch) const;

 private:
  PatchRange own_;
  const BodyWallLaw<Dim>* law_ = nullptr;
  Points<Dim> frame_normals_, normals_;  ///< normals of the patches: in their bodies' frames; in space
};

template <int Dim>
void PatchSliding<Dim>::let_slide(const BodyWallLaw<Dim>& law) {
  if (law_ == &law) return;
  law_ = &law;
  const auto first = law.patch_normals().begin();
  frame_normals_.assign(first + static_cast<std::ptrdiff_t>(own_.begin), first + static_cast<std::ptrdiff_t>(own_.end));
}

template <int Dim>
Point<Dim> PatchSliding<Dim>::constrained(const Point<Dim>& value, std::size_t patch) const {
  const double part = slide(patch).part;
  if (part == 0 || normals_.empty()) return value;
  return value - part * (value - value.dot(normals_[patch]) * normals_[patch]);
}

}  // namespace washfsi
