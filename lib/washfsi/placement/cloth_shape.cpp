// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/placement/cloth_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/placement/plate_mode.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Roots of cosh(b) cos(b) = 1: wave numbers times length of a free beam's modes.
double free_beam_root(PetscInt mode) {
  double root = (static_cast<double>(mode) + 0.5) * std::numbers::pi;
  for (int n = 0; n < 20; ++n)
    root -= (std::cos(root) - 1 / std::cosh(root)) / (-std::sin(root) + std::tanh(root) / std::cosh(root));
  return root;
}

// A mode of a free beam of unit length, 1 at its ends where it is largest.
double free_beam_mode(double root, double s) {
  const double ratio = (std::cosh(root) - std::cos(root)) / (std::sinh(root) - std::sin(root));
  // cosh - ratio sinh without their cancellation
  const double decay = 0.5 * ((1 - ratio) * std::exp(root * s) + (1 + ratio) * std::exp(-root * s));
  return 0.5 * (decay + std::cos(root * s) - ratio * std::sin(root * s));
}

// Angles that divide an ellipse into parts of equal length.
std::vector<double> equal_parts(double a, double b, PetscInt parts) {
  constexpr int fineness = 200;
  const PetscInt samples = fineness * parts;
  const MarkerRow row(MarkerLattice::centred, static_cast<std::size_t>(parts));
  const double step = 2 * std::numbers::pi / static_cast<double>(samples);
  std::vector<double> length{0};
  for (PetscInt n = 0; n < samples; ++n) {
    const double angle = (static_cast<double>(n) + 0.5) * step;
    length.push_back(length.back() + step * std::hypot(a * std::sin(angle), b * std::cos(angle)));
  }
  std::vector<double> angles;
  std::size_t n = 0;
  for (PetscInt k = 0; k < parts; ++k) {
    const double wanted = length.back() * row.place(static_cast<std::size_t>(k));
    while (length[n + 1] < wanted) ++n;
    angles.push_back(step * (static_cast<double>(n) + (wanted - length[n]) / (length[n + 1] - length[n])));
  }
  return angles;
}

// A marker's place along s (and r), in half lengths from the middle.
template <int Dim>
typename FlatCloth<Dim>::Coordinates place_in(const ClothGroup<Dim>& group, PetscInt i, PetscInt j) {
  typename FlatCloth<Dim>::Coordinates place;
  place[0] = 2 * group.row(0).place(static_cast<std::size_t>(i)) - 1;
  if constexpr (Dim == 3) place[1] = 2 * group.row(1).place(static_cast<std::size_t>(j)) - 1;
  return place;
}

// Calls displacement(place in half lengths) for each marker of a flat cloth.
template <int Dim, class Displacement>
Points<Dim> displaced(const ClothGroup<Dim>& group, const FlatCloth<Dim>& flat, const Displacement& displacement) {
  Points<Dim> result;
  for (PetscInt i = 0; i < group.markers[0]; ++i)
    for (PetscInt j = 0; j < group.markers[1]; ++j) {
      const auto place = place_in(group, i, j);
      result.push_back(flat.at(place) + displacement(place));
    }
  return result;
}

template <int Dim>
Points<Dim> crumpled(const ClothGroup<Dim>& group, double crumpling, const FlatCloth<Dim>& flat, Uniform& uniform) {
  Points<Dim> line{Point<Dim>::Zero()};
  double heading = 0;
  Point<Dim> center = Point<Dim>::Zero();
  const MarkerRow row = group.row(0);
  for (PetscInt i = 1; i < group.markers[0]; ++i) {
    heading += crumpling * (2 * uniform() - 1);
    line.push_back(line.back() +
                   group.sheet.ds * (std::cos(heading) * flat.along() + std::sin(heading) * flat.normal()));
    center += row.share(static_cast<std::size_t>(i)) * line.back() / row.parts();
  }
  auto straight = flat;
  straight.half[0] = 0;
  std::size_t marker = 0;
  return displaced(group, straight, [&](const auto&) -> Point<Dim> {
    return line[marker++ / static_cast<std::size_t>(group.markers[1])] - center;
  });
}

template <int Dim>
Points<Dim> ellipse(const ClothGroup<Dim>& group, const double (&semi_axes)[2], const FlatCloth<Dim>& flat) {
  Points<Dim> result;
  for (const double angle : equal_parts(semi_axes[0], semi_axes[1], group.markers[0]))
    result.push_back(flat.middle + semi_axes[0] * std::cos(angle) * flat.along() +
                     semi_axes[1] * std::sin(angle) * flat.normal());
  return result;
}

Points<2> bending_mode(const ClothGroup<2>& group, const ShapeOptions<2>& shape, const FlatCloth<2>& flat) {
  const double root = free_beam_root(shape.mode);
  return displaced(group, flat, [&](const auto& place) -> Point<2> {
    return shape.amplitude * free_beam_mode(root, 0.5 * (place[0] + 1)) * flat.normal();
  });
}

Points<3> bending_mode(const ClothGroup<3>& group, const ShapeOptions<3>& shape, const FlatCloth<3>& flat) {
  const PlateMode mode(bending_of(group.sheet.fabric), group.size[0], group.size[1], static_cast<int>(shape.mode));
  double most = 0;
  (void)displaced(group, flat, [&](const auto& place) -> Point<3> {
    most = std::max(most, std::abs(mode(place[0], place[1])));
    return Point<3>::Zero();
  });
  if (!(most > 1e-6))  // modes have the rms 1
    throw InputError("-" + group.name + "_mode " + std::to_string(shape.mode) +
                     ": moves no marker of this cloth; a single row cannot twist");
  return displaced(group, flat, [&](const auto& place) -> Point<3> {
    return shape.amplitude / most * mode(place[0], place[1]) * flat.normal();
  });
}

}  // namespace

template <int Dim>
ShapeOptions<Dim> ShapeOptions<Dim>::from_options(Options& options, const std::string& group) {
  ShapeOptions shape;
  std::vector<double> axes{shape.semi_axes[0], shape.semi_axes[1]};
  constexpr Range one_to_forty{1.0, 40.0, false, "a whole number from 1 to 40"};
  options.block(
      group + "_", "Shape of " + group,
      [&](OptionBlock& block) {
        if (Dim == 2)
          block.reals("semi_axes", axes, 2, 2, "m", "of an ellipse, along and across the cloth's direction");
        block.integer("mode", shape.mode, one_to_forty, "which bending mode of a free cloth");
        block.real("amplitude", shape.amplitude, "m", any_number, "of the mode, where it is largest");
        block.real("crumpling", shape.crumpling, "rad", {0.0, std::numbers::pi, false, "a number from 0 to pi"},
                   "largest turn from edge to edge of crumpled cloth; 0: flat");
      },
      "cloths_");
  if (!(axes[0] > 0 && axes[1] > 0))
    throw InputError("-" + group + "_semi_axes " + to_text(axes[0]) + "," + to_text(axes[1]) +
                     ": both must be above 0");
  std::copy(axes.begin(), axes.end(), shape.semi_axes);
  return shape;
}

template <int Dim>
Points<Dim> shaped_cloth(const ClothGroup<Dim>& group, const ShapeOptions<Dim>& shape, const FlatCloth<Dim>& flat,
                         Uniform& uniform) {
  if (group.shape == ClothShape::crumpled) return crumpled<Dim>(group, shape.crumpling, flat, uniform);
  if (group.shape == ClothShape::ellipse) return ellipse<Dim>(group, shape.semi_axes, flat);
  if (group.shape == ClothShape::mode) return bending_mode(group, shape, flat);
  const double amplitude = group.shape == ClothShape::bar_mode ? shape.amplitude : 0;
  return displaced(group, flat, [&](const auto& place) -> Point<Dim> {
    return amplitude * std::sin(0.5 * std::numbers::pi * place[0]) * flat.along();
  });
}

template struct ShapeOptions<2>;
template struct ShapeOptions<3>;
template Points<2> shaped_cloth<2>(const ClothGroup<2>&, const ShapeOptions<2>&, const FlatCloth<2>&, Uniform&);
template Points<3> shaped_cloth<3>(const ClothGroup<3>&, const ShapeOptions<3>&, const FlatCloth<3>&, Uniform&);

}  // namespace washfsi
