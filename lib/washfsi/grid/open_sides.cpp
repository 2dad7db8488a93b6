// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/open_sides.hpp"

#include <algorithm>

#include "washfsi/grid/side_faces.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
OpenSides<Dim>::OpenSides(const Grid<Dim>& grid, const Sides<Dim>& sides) : grid_(grid) {
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends)
      if (side_of<Dim>(sides, axis, end).kind == BoundaryKind::outflow) layers_.emplace_back(grid, axis, end);
}

template <int Dim>
double OpenSides<Dim>::operator()(int axis, End end, const Index<Dim>& face, int component, double time) const {
  const auto layer = std::find_if(layers_.begin(), layers_.end(),
                                  [&](const auto& each) { return each.axis() == axis && each.end() == end; });
  return (*layer)(face, component, time > time_);
}

template <int Dim>
void OpenSides<Dim>::start(Vec local_velocity, double flux, double time) {
  const ConstFaceView<Dim> u(petsc::dm_of(local_velocity), local_velocity);
  for (auto& layer : layers_) layer.start(u);
  balance(flux);
  next_time_ = time;
  accept();
}

template <int Dim>
void OpenSides<Dim>::advance(Vec local_velocity, double flux, double time, double dt) {
  const ConstFaceView<Dim> u(petsc::dm_of(local_velocity), local_velocity);
  std::vector<double> inner;
  for (const auto& layer : layers_) inner.push_back(layer.inner_flux(u));
  inner = ordered_sum(grid_.comm(), inner);
  for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i].advance(u, inner[i] / layers_[i].area(), dt);
  balance(flux);
  next_time_ = time;
}

// Shifts the advanced values of all open sides alike so that the box gains and loses the same volume.
template <int Dim>
void OpenSides<Dim>::balance(double flux) {
  double out = 0, area = 0;
  for (const auto& layer : layers_) {
    out += layer.flux();
    area += layer.area();
  }
  out = ordered_sum(grid_.comm(), out) + flux;
  for (auto& layer : layers_) layer.add_outward(-out / area);
}

template <int Dim>
void OpenSides<Dim>::accept() {
  for (auto& layer : layers_) layer.accept();
  time_ = next_time_;
}

template <int Dim>
void OpenSides<Dim>::register_state(StateList& state) {
  for (auto& layer : layers_) layer.register_state(state);
  if (!empty()) state.add_number("/outflow/time", time_);
}

template class OpenSides<2>;
template class OpenSides<3>;

}  // namespace washfsi
