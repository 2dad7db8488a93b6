// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/sums.hpp"

#include <string_view>

#include "washfsi/grid/cell_velocity.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

template <int Dim>
Bins<Dim>::Bins(const Grid<Dim>& grid, const std::vector<std::string>& homogeneous) : grid_(grid) {
  constexpr std::string_view letters = "xyz";
  for (const std::string& name : homogeneous) {
    const std::size_t axis = name.size() == 1 ? letters.find(name[0]) : Dim;
    if (axis >= Dim || !grid.periodic(static_cast<int>(axis)))
      throw InputError("-statistics_axes " + join(homogeneous, ",") + ": must be periodic axes of the box");
    homogeneous_[axis] = true;
  }
  for (int d = 0; d < Dim; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    if (homogeneous.empty()) homogeneous_[axis] = grid.periodic(d);
    if (homogeneous_[axis])
      cells_per_bin_ *= static_cast<double>(grid.cells()[axis]);
    else
      axes_.push_back(d), count_ *= static_cast<std::size_t>(grid.cells()[axis]);
  }
  if (static_cast<int>(axes_.size()) == Dim)
    throw InputError("-statistics: needs a periodic axis, along which means are taken");
}

template <int Dim>
std::size_t Bins<Dim>::of(const Index<Dim>& cell) const {
  std::size_t bin = 0;
  for (std::size_t n = axes_.size(); n-- > 0;)
    bin = bin * static_cast<std::size_t>(grid_.cells()[axes_[n]]) + static_cast<std::size_t>(cell[axes_[n]]);
  return bin;
}

template <int Dim>
std::vector<std::string> moment_names() {
  std::vector<std::string> names;
  for (int c = 0; c < Dim; ++c) names.emplace_back(1, "uvw"[c]);
  names.emplace_back("p");
  for (int c = 0; c < Dim; ++c) names.emplace_back(2, "uvw"[c]);
  for (int c = 0; c < Dim; ++c)
    for (int d = c + 1; d < Dim; ++d) names.push_back({"uvw"[c], "uvw"[d]});
  names.emplace_back("pp");
  return names;
}

template <int Dim>
std::vector<double> bin_means(const Grid<Dim>& grid, const Bins<Dim>& bins, const FlowMoment& flow) {
  const std::size_t moments = moment_names<Dim>().size();
  const ConstFaceView<Dim> u(grid.face_dm(), flow.velocity);
  const ConstCellView<Dim> p(grid.cell_dm(), flow.pressure);
  std::vector<double> sums(bins.count() * moments, 0.0);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    double* sum = &sums[bins.of(cell) * moments];
    Point<Dim> velocity;
    for (int c = 0; c < Dim; ++c) velocity[c] = cell_velocity<Dim>(u, cell, c);
    const double pressure = p(cell);
    for (int c = 0; c < Dim; ++c) *sum++ += velocity[c];
    *sum++ += pressure;
    for (int c = 0; c < Dim; ++c) *sum++ += velocity[c] * velocity[c];
    for (int c = 0; c < Dim; ++c)
      for (int d = c + 1; d < Dim; ++d) *sum++ += velocity[c] * velocity[d];
    *sum += pressure * pressure;
  });
  sums = ordered_sum(grid.comm(), sums);
  for (double& sum : sums) sum /= bins.cells_per_bin();
  return sums;
}

template std::vector<std::string> moment_names<2>();
template std::vector<std::string> moment_names<3>();
template std::vector<double> bin_means<2>(const Grid<2>&, const Bins<2>&, const FlowMoment&);
template std::vector<double> bin_means<3>(const Grid<3>&, const Bins<3>&, const FlowMoment&);
template class Bins<2>;
template class Bins<3>;

}  // namespace washfsi
