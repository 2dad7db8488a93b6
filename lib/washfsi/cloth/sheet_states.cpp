// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet_states.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "washfsi/cloth/sheet_membrane.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Tangents at a marker, between its neighbours as far as it has any.
template <int Dim>
Point<Dim> tangent_between(std::span<const Point<Dim>> x, std::size_t before, std::size_t after) {
  const Point<Dim> along = x[after] - x[before];
  const double length = along.norm();
  return length > 0 ? Point<Dim>(along / length) : Point<Dim>::Zero();
}

}  // namespace

template <int Dim>
double largest_stretch(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const SheetLattice<Dim> lattice(sheet, positions);
  double most = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (lattice.has_edge_s(k)) most = std::max(most, lattice.edge_s(k).norm() / sheet.ds - 1);
    if (lattice.has_edge_r(k)) most = std::max(most, lattice.edge_r(k).norm() / sheet.dr - 1);
  }
  return most;
}

template <int Dim>
Points<Dim> normals(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const SheetLattice<Dim> lattice(sheet, positions);
  Points<Dim> result;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Point<Dim> s =
        tangent_between<Dim>(positions, k >= lattice.m ? k - lattice.m : k, lattice.has_edge_s(k) ? k + lattice.m : k);
    if constexpr (Dim == 2) {
      result.push_back(turned_left<2>(s));
    } else {
      const Point<Dim> r =
          tangent_between<Dim>(positions, k % lattice.m > 0 ? k - 1 : k, lattice.has_edge_r(k) ? k + 1 : k);
      const Point<Dim> normal = s.cross(r);
      result.push_back(normal.norm() > 0 ? Point<Dim>(normal.normalized()) : Point<Dim>::Zero());
    }
  }
  return result;
}

template <int Dim>
std::vector<Outwards<Dim>> outwards(const Sheet& sheet, std::span<const Point<Dim>> x) {
  const SheetLattice<Dim> lattice(sheet, x);
  const std::size_t m = lattice.m;
  std::vector<Outwards<Dim>> result(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (k < m && !sheet.closed && lattice.has_edge_s(k)) result[k].s = tangent_between<Dim>(x, k + m, k);
    if (k >= m && !lattice.has_edge_s(k)) result[k].s = tangent_between<Dim>(x, k - m, k);
    if (k % m == 0 && lattice.has_edge_r(k)) result[k].r = tangent_between<Dim>(x, k + 1, k);
    if (k % m > 0 && !lattice.has_edge_r(k)) result[k].r = tangent_between<Dim>(x, k - 1, k);
  }
  return result;
}

namespace {

/// Sum over the edges or quads beside a marker that exist, and their number.
struct Beside {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
  /// The mean; on the centred lattice, whose outermost markers lie within the edges, with zeros for missing ones of
  /// `all`.
  double mean_of(int all, MarkerLattice lattice) const { return lattice == MarkerLattice::nodal ? mean() : sum / all; }
};

template <int Dim>
MarkerState marker_state(const SheetLattice<Dim>& lattice, const Membrane& pulls, std::size_t k) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  const double q = sheet.thickness, per_section = 6 / (q * q);
  Beside pull_s, pull_r, pull_shear, stretch, angle;
  Point<Dim> twist = Point<Dim>::Zero();
  const auto see_s = [&](std::size_t e) {
    pull_s.add(pulls.s[e] / lattice.share_s(e));
    stretch.add(std::abs(lattice.edge_s(e).norm() / sheet.ds - 1));
  };
  const auto see_r = [&](std::size_t e) {
    pull_r.add(pulls.r[e] / lattice.share_r(e));
    stretch.add(std::abs(lattice.edge_r(e).norm() / sheet.dr - 1));
  };
  const auto see_quad = [&](std::size_t e) {
    const Point<Dim> a = lattice.tangent_s(e), b = lattice.tangent_r(e);
    pull_shear.add(pulls.shear[e]);
    angle.add(std::abs(std::asin(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0))));
    twist += lattice.mixed_difference(e);
  };
  const bool has_before_s = k >= m, has_before_r = k % m > 0;
  if (has_before_s) see_s(k - m);
  if (lattice.has_edge_s(k)) see_s(k);
  if (has_before_r) see_r(k - 1);
  if (lattice.has_edge_r(k)) see_r(k);
  if (has_before_s && has_before_r) see_quad(k - m - 1);
  if (has_before_s && lattice.has_edge_r(k)) see_quad(k - m);
  if (has_before_r && lattice.has_edge_s(k)) see_quad(k - 1);
  if (lattice.has_quad(k)) see_quad(k);
  if (angle.count > 0) twist /= angle.count;

  MarkerState state;
  state.membrane_stress = {std::abs(pull_s.mean_of(2, sheet.lattice)) / q,
                           std::abs(pull_r.mean_of(2, sheet.lattice)) / q,
                           std::abs(pull_shear.mean_of(4, sheet.lattice)) / q};
  const Moments<Dim> moments(lattice, k);
  state.bending_stress = {per_section * moments.s.norm(), per_section * moments.r.norm(),
                          per_section * lattice.bending.twist * twist.norm()};
  state.stretch = stretch.mean_of(sheet.width > 1 ? 4 : 2, sheet.lattice);
  double squares = 2 * twist.squaredNorm();
  if (lattice.bends_along_s(k)) squares += lattice.second_difference_s(k).squaredNorm();
  if (lattice.bends_along_r(k)) squares += lattice.second_difference_r(k).squaredNorm();
  state.curvature = std::sqrt(squares);
  state.shear_angle = angle.mean();
  return state;
}

}  // namespace

template <int Dim>
std::vector<MarkerState> marker_states(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const SheetLattice<Dim> lattice(sheet, positions);
  const Membrane pulls = resultants_of(lattice, strains_of(lattice));
  std::vector<MarkerState> result;
  for (std::size_t k = 0; k < positions.size(); ++k) result.push_back(marker_state(lattice, pulls, k));
  return result;
}

namespace {

// Collects this rank's values; find(part) gives a value for each marker of a part.
template <int Dim, class Find>
auto values_by_part(const Cloths<Dim>& cloths, const Find& find) {
  std::invoke_result_t<Find, const LatticePart&> result(cloths.owned());
  for (const LatticePart& part : cloths.lattices().parts()) {
    const auto values = find(part);
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) result[part.own_first + i - part.own_begin] = values[i];
  }
  return result;
}

}  // namespace

template <int Dim>
Points<Dim> normals(const Cloths<Dim>& cloths, const Points<Dim>& positions) {
  const Points<Dim> x = cloths.lattices().with_halo(positions);
  return values_by_part(
      cloths, [&](const LatticePart& part) { return normals<Dim>(cloths.group_of(part).sheet, part.seen(x)); });
}

template <int Dim>
std::vector<Outwards<Dim>> outwards(const Cloths<Dim>& cloths, const Points<Dim>& positions) {
  const Points<Dim> x = cloths.lattices().with_halo(positions);
  return values_by_part(
      cloths, [&](const LatticePart& part) { return outwards<Dim>(cloths.group_of(part).sheet, part.seen(x)); });
}

template <int Dim>
std::vector<MarkerState> marker_states(const Cloths<Dim>& cloths, const Points<Dim>& positions) {
  const Points<Dim> x = cloths.lattices().with_halo(positions);
  return values_by_part(
      cloths, [&](const LatticePart& part) { return marker_states<Dim>(cloths.group_of(part).sheet, part.seen(x)); });
}

template <int Dim>
std::vector<double> largest_stretches(const Cloths<Dim>& cloths, const Points<Dim>& positions) {
  const Points<Dim> x = cloths.lattices().with_halo(positions);
  std::vector<double> stretches(cloths.groups().size(), 0.0);
  for (const LatticePart& part : cloths.lattices().parts()) {
    double& most = stretches[cloths.pieces()[part.piece].group];
    most = std::max(most, largest_stretch<Dim>(cloths.group_of(part).sheet, part.seen(x)));
  }
  for (double& stretch : stretches) stretch = largest(cloths.comm(), stretch);
  return stretches;
}

template double largest_stretch<2>(const Sheet&, std::span<const Point<2>>);
template double largest_stretch<3>(const Sheet&, std::span<const Point<3>>);
template Points<2> normals<2>(const Sheet&, std::span<const Point<2>>);
template Points<3> normals<3>(const Sheet&, std::span<const Point<3>>);
template std::vector<MarkerState> marker_states<2>(const Sheet&, std::span<const Point<2>>);
template std::vector<MarkerState> marker_states<3>(const Sheet&, std::span<const Point<3>>);
template Points<2> normals<2>(const Cloths<2>&, const Points<2>&);
template Points<3> normals<3>(const Cloths<3>&, const Points<3>&);
template std::vector<Outwards<2>> outwards<2>(const Sheet&, std::span<const Point<2>>);
template std::vector<Outwards<3>> outwards<3>(const Sheet&, std::span<const Point<3>>);
template std::vector<Outwards<2>> outwards<2>(const Cloths<2>&, const Points<2>&);
template std::vector<Outwards<3>> outwards<3>(const Cloths<3>&, const Points<3>&);
template std::vector<MarkerState> marker_states<2>(const Cloths<2>&, const Points<2>&);
template std::vector<MarkerState> marker_states<3>(const Cloths<3>&, const Points<3>&);
template std::vector<double> largest_stretches<2>(const Cloths<2>&, const Points<2>&);
template std::vector<double> largest_stretches<3>(const Cloths<3>&, const Points<3>&);

}  // namespace washfsi
