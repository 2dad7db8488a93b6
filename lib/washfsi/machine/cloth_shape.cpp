// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/cloth_shape.hpp"

#include <cmath>
#include <numbers>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Where along its length a marker is, 0 to 1.
double place_along(PetscInt marker, PetscInt markers) {
  return (static_cast<double>(marker) + 0.5) / static_cast<double>(markers);
}

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
  const double step = 2 * std::numbers::pi / static_cast<double>(samples);
  std::vector<double> length{0};
  for (PetscInt n = 0; n < samples; ++n) {
    const double angle = (static_cast<double>(n) + 0.5) * step;
    length.push_back(length.back() + step * std::hypot(a * std::sin(angle), b * std::cos(angle)));
  }
  std::vector<double> angles;
  std::size_t n = 0;
  for (PetscInt k = 0; k < parts; ++k) {
    const double wanted = length.back() * place_along(k, parts);
    while (length[n + 1] < wanted) ++n;
    angles.push_back(step * (static_cast<double>(n) + (wanted - length[n]) / (length[n + 1] - length[n])));
  }
  return angles;
}

template <int Dim>
Points<Dim> crumpled(const ClothGroup<Dim>& group, double crumpling, const Point<Dim>& middle, const Point<Dim>& along,
                     Uniform& uniform) {
  Points<Dim> result{Point<Dim>::Zero()};
  double heading = 0;
  Point<Dim> center = Point<Dim>::Zero();
  for (PetscInt k = 1; k < group.markers; ++k) {
    heading += crumpling * (2 * uniform() - 1);
    result.push_back(result.back() +
                     group.fibre.spacing * (std::cos(heading) * along + std::sin(heading) * turned_left<Dim>(along)));
    center += result.back() / static_cast<double>(group.markers);
  }
  for (auto& place : result) place += middle - center;
  return result;
}

}  // namespace

template <int Dim>
ShapeOptions<Dim> ShapeOptions<Dim>::from_options(Options& options, const std::string& group) {
  ShapeOptions shape;
  std::vector<double> axes{shape.semi_axes[0], shape.semi_axes[1]};
  options.block(group + "_", "Shape of " + group, [&](OptionBlock& block) {
    block.reals("semi_axes", axes, 2, 2, "m", "of an ellipse, along and across the cloth's direction");
    block.integer("mode", shape.mode, at_least_one, "which bending mode of a free cloth");
    block.real("amplitude", shape.amplitude, "m", any_number, "of the mode, at the ends");
    block.real("crumpling", shape.crumpling, "rad", non_negative, "largest turn from edge to edge of crumpled cloth");
  });
  if (!(axes[0] > 0 && axes[1] > 0))
    throw InputError("-" + group + "_semi_axes " + to_text(axes[0]) + "," + to_text(axes[1]) +
                     ": both must be above 0");
  std::copy(axes.begin(), axes.end(), shape.semi_axes);
  return shape;
}

template <int Dim>
Points<Dim> shaped_cloth(const ClothGroup<Dim>& group, const ShapeOptions<Dim>& shape, const Segment<Dim>& segment,
                         Uniform& uniform) {
  const Point<Dim> along = (segment.to - segment.from).normalized(), across = turned_left<Dim>(along);
  const Point<Dim> middle = 0.5 * (segment.from + segment.to);
  if (group.shape == "crumpled") return crumpled<Dim>(group, shape.crumpling, middle, along, uniform);
  Points<Dim> result;
  if (group.shape == "ellipse") {
    for (const double angle : equal_parts(shape.semi_axes[0], shape.semi_axes[1], group.markers))
      result.push_back(middle + shape.semi_axes[0] * std::cos(angle) * along +
                       shape.semi_axes[1] * std::sin(angle) * across);
    return result;
  }
  const double root = free_beam_root(shape.mode), amplitude = group.shape == "mode" ? shape.amplitude : 0;
  for (PetscInt k = 0; k < group.markers; ++k) {
    const double s = place_along(k, group.markers);
    result.push_back(segment.from + s * (segment.to - segment.from) + amplitude * free_beam_mode(root, s) * across);
  }
  return result;
}

template struct ShapeOptions<2>;
template struct ShapeOptions<3>;
template Points<2> shaped_cloth<2>(const ClothGroup<2>&, const ShapeOptions<2>&, const Segment<2>&, Uniform&);
template Points<3> shaped_cloth<3>(const ClothGroup<3>&, const ShapeOptions<3>&, const Segment<3>&, Uniform&);

}  // namespace washfsi
