// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/driving.hpp"

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
DrivingOptions<Dim> DrivingOptions<Dim>::from_options(Options& options) {
  DrivingOptions<Dim> driving;
  options.block("", "Driven water", [&](OptionBlock& block) {
    block.template point<Dim>("fluid_pressure_gradient", driving.pressure_gradient, "Pa/m",
                              "gradient of the mean pressure along periodic axes; a negative one drives the water "
                              "forwards, by the force density -gradient");
    block.template point<Dim>("fluid_bulk_velocity", driving.bulk_velocity, "m/s",
                              "mean velocity over the box that the pressure gradient is adjusted to keep, along each "
                              "periodic axis where it is not 0");
  });
  return driving;
}

template <int Dim>
Driving<Dim>::Driving(const Grid<Dim>& grid, const DrivingOptions<Dim>& options)
    : grid_(grid), options_(options), guess_(options.pressure_gradient), gradient_(options.pressure_gradient) {
  for (int d = 0; d < Dim; ++d) {
    const bool has_gradient = options.pressure_gradient[d] != 0;
    const std::string given = has_gradient ? "-fluid_pressure_gradient " + list_text<Dim>(options.pressure_gradient)
                                           : "-fluid_bulk_velocity " + list_text<Dim>(options.bulk_velocity);
    if (drives(d) && !grid.periodic(d))
      throw InputError(given + ": must be 0 along " + "xyz"[d] + ", which is not periodic");
    if (has_gradient && keeps_bulk(d))
      throw InputError(given + ": must be 0 along " + "xyz"[d] + ", where -fluid_bulk_velocity is not");
  }
}

template <int Dim>
bool Driving<Dim>::is_there() const {
  for (int d = 0; d < Dim; ++d)
    if (drives(d)) return true;
  return false;
}

template <int Dim>
const Point<Dim>& Driving<Dim>::begin_trial() {
  return gradient_ = guess_;
}

template <int Dim>
void Driving<Dim>::add_reaction_of_undriven(Vec driven_share, Vec force) const {
  if (!is_there()) return;
  const ConstFaceView<Dim> share(grid_.face_dm(), driven_share);
  const FaceView<Dim> f(grid_.face_dm(), force);
  grid_.for_each_inner_face([&](const Index<Dim>& face, auto c) { f(face, c) += guess_[c] * (1 - share(face, c)); });
}

template <int Dim>
void Driving<Dim>::keep_bulk(double dt, Vec density, Vec driven_share, Vec velocity) {
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const ConstFaceView<Dim> rho(grid_.face_dm(), density);
  const ConstFaceView<Dim> share(grid_.face_dm(), driven_share ? driven_share : density);
  for (int c = 0; c < Dim; ++c) {
    if (!keeps_bulk(c)) continue;
    const auto response = [&](const Index<Dim>& face) {
      return (driven_share ? share(face, c) : 1) * dt / rho(face, c);
    };
    std::vector<double> sums(2, 0.0);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
      sums[0] += options_.bulk_velocity[c] - u(face, c);
      sums[1] += response(face);
    });
    sums = ordered_sum(grid_.comm(), sums);
    if (!(sums[1] > 0)) continue;  // no fluid on this axis' faces
    const double force = sums[0] / sums[1];
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) { u(face, c) += force * response(face); });
    gradient_[c] -= force;
  }
}

template <int Dim>
void Driving<Dim>::accept(bool is_first) {
  for (int c = 0; c < Dim; ++c)
    if (keeps_bulk(c) && !is_first) guess_[c] = gradient_[c];
}

template <int Dim>
void Driving<Dim>::register_state(StateList& state) {
  if (!is_there()) return;
  StateEntry& entry = state.add(numbers_entry("/driving", {guess_.data(), Dim}));
  entry.if_other = StateEntry::IfOther::begin_anew;
  entry.set = [this](const StateEntry::Values& values) {
    for (int d = 0; d < Dim; ++d)
      if (keeps_bulk(d)) guess_[d] = values[static_cast<std::size_t>(d)];
  };
}

template <int Dim>
Point<Dim> mean_velocity(const Grid<Dim>& grid, Vec velocity, Vec share) {
  const ConstFaceView<Dim> u(grid.face_dm(), velocity), part(grid.face_dm(), share ? share : velocity);
  std::vector<double> sums(Dim, 0.0);
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& face) {
      sums[static_cast<std::size_t>(c)] += (share ? part(face, c) : 1) * u(face, c);
    });
  sums = ordered_sum(grid.comm(), sums);
  return Point<Dim>(sums.data()) / grid.cell_count();
}

template Point<2> mean_velocity<2>(const Grid<2>&, Vec, Vec);
template Point<3> mean_velocity<3>(const Grid<3>&, Vec, Vec);
template struct DrivingOptions<2>;
template struct DrivingOptions<3>;
template class Driving<2>;
template class Driving<3>;

}  // namespace washfsi
