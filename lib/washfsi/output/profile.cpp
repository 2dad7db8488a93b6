// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/profile.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/grid/interpolate.hpp"
#include "washfsi/output/history.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

template <int Dim>
void Profile<Dim>::write(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec velocity, Vec pressure, double time,
                         const std::string& folder) const {
  const GhostedVelocity<Dim> local_u(boundary, grid.face_dm(), velocity, time);
  const petsc::LocalVector local_p(grid.cell_dm(), pressure);
  const ConstFaceView<Dim> u(grid.face_dm(), local_u);
  const ConstCellView<Dim> p(grid.cell_dm(), local_p);
  const auto n = static_cast<std::size_t>(points);
  std::vector<double> samples(n * (Dim + 1), 0.0);  // the rank that owns a point's cell fills it in
  const auto place_of = [&](std::size_t i) -> Point<Dim> {
    return from + (n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0) * (to - from);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point<Dim> place = grid.folded(place_of(i)).cwiseMax(grid.lower()).cwiseMin(grid.upper());
    if (grid.owner(grid.cell_of(place)) != rank_of(grid.comm())) continue;
    for (int c = 0; c < Dim; ++c) {
      samples[i * (Dim + 1) + c] = interpolate_face<Dim>(grid, u, place, c);
    }
    samples[i * (Dim + 1) + Dim] =
        interpolate_linearly<Dim>(grid, place, Point<Dim>::Constant(0.5), [&](Index<Dim> index) {
          for (int d = 0; d < Dim; ++d)  // beyond walls there is no pressure: takes the nearest cell's
            if (!grid.periodic(d)) index[d] = std::clamp<PetscInt>(index[d], 0, grid.cells()[d] - 1);
          return p(index);
        });
  }
  samples = ordered_sum(grid.comm(), samples);

  std::vector<Column> columns;
  for (int d = 0; d < Dim; ++d) columns.push_back({std::string(1, "xyz"[d]), "m"});
  for (int d = 0; d < Dim; ++d) columns.push_back({std::string(1, "uvw"[d]), "m/s"});
  columns.push_back({"p", "Pa"});
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < n; ++i) {
    const Point<Dim> place = place_of(i);
    std::vector<double> row(place.data(), place.data() + Dim);
    row.insert(row.end(), &samples[i * (Dim + 1)], &samples[i * (Dim + 1)] + Dim + 1);
    rows.push_back(row);
  }
  make_writable_folder(grid.comm(), folder + "/profiles");
  write_table(grid.comm(), folder + "/profiles/" + name + ".csv", columns, rows);
}

namespace {

template <int Dim>
Profile<Dim> profile_from_options(Options& options, const std::string& name) {
  Profile<Dim> profile;
  profile.name = name;
  options.block(name + "_", "Profile " + name, [&](OptionBlock& block) {
    block.require("from", "the first point of the line");
    block.require("to", "the last point of the line");
    block.template point<Dim>("from", profile.from, "m", "first point of the line");
    block.template point<Dim>("to", profile.to, "m", "last point of the line");
    block.integer("points", profile.points, {1.0, 1e6, false, "a whole number from 1 to 1000000"},
                  "number of points on the line");
  });
  return profile;
}

}  // namespace

template <int Dim>
std::vector<Profile<Dim>> profiles_from_options(Options& options, const Point<Dim>& lower, const Point<Dim>& upper) {
  std::vector<std::string> names;
  options.block("", "Profiles",
                [&](OptionBlock& block) { block.names("profiles", names, "names of the lines sampled at the end"); });
  if (names.empty()) names = options.examples("line", "LINE");
  std::vector<Profile<Dim>> profiles;
  for (const auto& name : names) {
    options.claim_prefix(name, "-profiles");
    profiles.push_back(profile_from_options<Dim>(options, name));
    for (const auto& end : {profiles.back().from, profiles.back().to})
      if (((end - lower).minCoeff() < 0 || (upper - end).minCoeff() < 0) && !options.help())
        throw InputError("-" + name + "_from, -" + name + "_to: the line leaves the grid");
  }
  options.leave_out_dropped("profiles", names,
                            [&](const std::string& name) { (void)profile_from_options<Dim>(options, name); });
  return profiles;
}

template struct Profile<2>;
template struct Profile<3>;
template std::vector<Profile<2>> profiles_from_options<2>(Options&, const Point<2>&, const Point<2>&);
template std::vector<Profile<3>> profiles_from_options<3>(Options&, const Point<3>&, const Point<3>&);

}  // namespace washfsi
