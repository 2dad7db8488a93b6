// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/fibre.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace washfsi {

namespace {

template <int Dim>
Point<Dim> second_difference(std::span<const Point<Dim>> x, std::size_t k, double ds) {
  return (x[k + 1] - 2 * x[k] + x[k - 1]) / (ds * ds);
}

}  // namespace

template <int Dim>
std::vector<double> tensions(const Fibre& fibre, std::span<const Point<Dim>> positions) {
  std::vector<double> result(positions.empty() ? 0 : positions.size() - 1);
  for (std::size_t k = 0; k < result.size(); ++k) {
    const double stretch = (positions[k + 1] - positions[k]).squaredNorm() / (fibre.spacing * fibre.spacing);
    result[k] = fibre.ke * 0.5 * (stretch - 1);
  }
  return result;
}

template <int Dim>
void add_energy_forces(const Fibre& fibre, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces) {
  const auto& x = positions;
  const double ds = fibre.spacing;
  const std::vector<double> tension = tensions<Dim>(fibre, x);
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const Point<Dim> pull = tension[k] / ds * (x[k + 1] - x[k]);
    forces[k] += pull;
    forces[k + 1] -= pull;
  }
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const Point<Dim> couple = fibre.kb / ds * second_difference<Dim>(x, k, ds);
    forces[k - 1] -= couple;
    forces[k] += 2 * couple;
    forces[k + 1] -= couple;
  }
}

template <int Dim>
void add_energy_stiffness(const Fibre& fibre, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add) {
  using Block = StiffnessBlock<Dim>;
  const double ds = fibre.spacing;
  const std::vector<double> tension = tensions<Dim>(fibre, positions);
  for (std::size_t k = 0; k + 1 < positions.size(); ++k) {
    const Point<Dim> edge = positions[k + 1] - positions[k];
    const double pull = geometric == GeometricStiffness::all ? tension[k] : std::max(tension[k], 0.0);
    const Block block = fibre.ke / (ds * ds * ds) * edge * edge.transpose() + pull / ds * Block::Identity();
    add(k, k, block);
    add(k + 1, k + 1, block);
    add(k, k + 1, -block);
    add(k + 1, k, -block);
  }
  constexpr std::array weights{1.0, -2.0, 1.0};
  const double bending = fibre.kb / (ds * ds * ds);
  for (std::size_t k = 1; k + 1 < positions.size(); ++k)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        add(k - 1 + a, k - 1 + b, bending * weights[a] * weights[b] * Block::Identity());
}

template <int Dim>
void add_damping_forces(const Fibre& fibre, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces) {
  const double factor = fibre.damping * fibre.ke / std::pow(fibre.spacing, 3);
  for (std::size_t k = 0; k + 1 < positions.size(); ++k) {
    const Point<Dim> edge = positions[k + 1] - positions[k];
    const Point<Dim> drag = factor * edge.dot(velocities[k + 1] - velocities[k]) * edge;
    forces[k] += drag;
    forces[k + 1] -= drag;
  }
}

template <int Dim>
double elastic_energy(const Fibre& fibre, std::span<const Point<Dim>> positions, std::size_t first, std::size_t last) {
  const std::vector<double> tension = tensions<Dim>(fibre, positions);
  double energy = 0;
  for (std::size_t k = first; k < last; ++k) {
    if (k + 1 >= positions.size()) continue;
    energy += 0.5 * fibre.spacing * tension[k] * tension[k] / fibre.ke;
    if (k == 0) continue;
    energy += 0.5 * fibre.kb * fibre.spacing * second_difference<Dim>(positions, k, fibre.spacing).squaredNorm();
  }
  return energy;
}

template <int Dim>
std::vector<MarkerState> marker_states(const Fibre& fibre, std::span<const Point<Dim>> positions) {
  const auto& x = positions;
  const double q = fibre.thickness;
  const std::vector<double> tension = tensions<Dim>(fibre, x);
  const auto stretch = [&](std::size_t k) { return std::abs((x[k + 1] - x[k]).norm() / fibre.spacing - 1); };
  std::vector<MarkerState> result(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    // tension and moment vanish at the free ends, half a spacing beyond the last markers
    const bool has_before = k > 0, has_after = k + 1 < x.size();
    const double pull = (has_before ? tension[k - 1] : 0) + (has_after ? tension[k] : 0);
    result[k].membrane_stress = 0.5 * std::abs(pull) / q;
    result[k].stretch = 0.5 * ((has_before ? stretch(k - 1) : 0) + (has_after ? stretch(k) : 0));
    if (!has_before || !has_after) continue;
    result[k].curvature = second_difference<Dim>(x, k, fibre.spacing).norm();
    result[k].bending_stress = 6 * fibre.kb * result[k].curvature / (q * q);
  }
  return result;
}

template std::vector<double> tensions<2>(const Fibre&, std::span<const Point<2>>);
template std::vector<double> tensions<3>(const Fibre&, std::span<const Point<3>>);
template void add_energy_forces<2>(const Fibre&, std::span<const Point<2>>, std::span<Point<2>>);
template void add_energy_forces<3>(const Fibre&, std::span<const Point<3>>, std::span<Point<3>>);
template void add_damping_forces<2>(const Fibre&, std::span<const Point<2>>, std::span<const Point<2>>,
                                    std::span<Point<2>>);
template void add_damping_forces<3>(const Fibre&, std::span<const Point<3>>, std::span<const Point<3>>,
                                    std::span<Point<3>>);
template void add_energy_stiffness<2>(const Fibre&, std::span<const Point<2>>, GeometricStiffness, const AddBlock<2>&);
template void add_energy_stiffness<3>(const Fibre&, std::span<const Point<3>>, GeometricStiffness, const AddBlock<3>&);
template double elastic_energy<2>(const Fibre&, std::span<const Point<2>>, std::size_t, std::size_t);
template double elastic_energy<3>(const Fibre&, std::span<const Point<3>>, std::size_t, std::size_t);
template std::vector<MarkerState> marker_states<2>(const Fibre&, std::span<const Point<2>>);
template std::vector<MarkerState> marker_states<3>(const Fibre&, std::span<const Point<3>>);

}  // namespace washfsi
