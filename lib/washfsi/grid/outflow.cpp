// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/outflow.hpp"

#include <algorithm>

#include "washfsi/grid/field_slab.hpp"

namespace washfsi {

namespace {

// A box without cells, so that loops over it do nothing.
template <int Dim>
bool empty(const Box<Dim>& box) {
  for (int d = 0; d < Dim; ++d)
    if (box.lower[d] >= box.upper[d]) return true;
  return false;
}

}  // namespace

template <int Dim>
OutflowLayer<Dim>::OutflowLayer(const Grid<Dim>& grid, int axis, End end)
    : grid_(grid), axis_(axis), end_(end), owned_(all_cells().common(grid.owned())), kept_(all_cells()) {
  for (int d = 0; d < Dim; ++d) {
    const bool wraps = grid.periodic(d);
    kept_.lower[d] = wraps ? grid.local().lower[d] : std::max(kept_.lower[d], grid.local().lower[d]);
    kept_.upper[d] = wraps ? grid.local().upper[d] : std::min(kept_.upper[d], grid.local().upper[d]);
  }
  if (empty(owned_)) owned_ = kept_ = {all_cells().lower, all_cells().lower};  // at most its ghosts reach the side
  now_.resize(Dim * kept_.count());
  next_ = now_;
}

template <int Dim>
Box<Dim> OutflowLayer<Dim>::all_cells() const {
  Box<Dim> all{};
  all.upper = grid_.cells();
  (end_ == End::lower ? all.upper[axis_] : all.lower[axis_]) = end_ == End::lower ? 1 : all.upper[axis_] - 1;
  return all;
}

template <int Dim>
std::size_t OutflowLayer<Dim>::offset(const Box<Dim>& box, Index<Dim> cell, int component) const {
  std::size_t position = 0;
  for (int d = Dim; d-- > 0;) {
    const PetscInt inside = std::clamp(cell[d], box.lower[d], box.upper[d] - 1);
    position = position * static_cast<std::size_t>(box.upper[d] - box.lower[d]) +
               static_cast<std::size_t>(inside - box.lower[d]);
  }
  return Dim * position + component;
}

// The face one spacing inside the layer: a cell beside an upper side has it as its own lower face.
template <int Dim>
Index<Dim> OutflowLayer<Dim>::nearest_inside(const Index<Dim>& cell, int component) const {
  return component == axis_ && end_ == End::lower ? shifted<Dim>(cell, axis_, 1) : cell;
}

template <int Dim>
void OutflowLayer<Dim>::start(const ConstFaceView<Dim>& local_velocity) {
  for_each<Dim>(kept_, [&](const Index<Dim>& cell) {
    for (int c = 0; c < Dim; ++c) next_[offset(kept_, cell, c)] = local_velocity(nearest_inside(cell, c), c);
  });
}

template <int Dim>
double OutflowLayer<Dim>::inner_flux(const ConstFaceView<Dim>& local_velocity) const {
  double sum = 0;
  for_each<Dim>(owned_, [&](const Index<Dim>& cell) { sum += local_velocity(nearest_inside(cell, axis_), axis_); });
  return (end_ == End::lower ? -sum : sum) * grid_.cell_volume() / grid_.spacing()[axis_];
}

template <int Dim>
void OutflowLayer<Dim>::advance(const ConstFaceView<Dim>& local_velocity, double speed, double dt) {
  const double courant = std::max(speed, 0.0) * dt / grid_.spacing()[axis_];
  for_each<Dim>(kept_, [&](const Index<Dim>& cell) {
    for (int c = 0; c < Dim; ++c) {
      const std::size_t here = offset(kept_, cell, c);
      next_[here] = (now_[here] + courant * local_velocity(nearest_inside(cell, c), c)) / (1 + courant);
    }
  });
}

template <int Dim>
double OutflowLayer<Dim>::flux() const {
  double sum = 0;
  for_each<Dim>(owned_, [&](const Index<Dim>& cell) { sum += next_[offset(kept_, cell, axis_)]; });
  return (end_ == End::lower ? -sum : sum) * grid_.cell_volume() / grid_.spacing()[axis_];
}

template <int Dim>
void OutflowLayer<Dim>::add_outward(double speed) {
  for_each<Dim>(
      kept_, [&](const Index<Dim>& cell) { next_[offset(kept_, cell, axis_)] += end_ == End::lower ? -speed : speed; });
}

template <int Dim>
double OutflowLayer<Dim>::area() const {
  const Point<Dim> extent = grid_.upper() - grid_.lower();
  return extent.prod() / extent[axis_];
}

template <int Dim>
double OutflowLayer<Dim>::operator()(const Index<Dim>& face, int component, bool advanced) const {
  return (advanced ? next_ : now_)[offset(kept_, face, component)];
}

template <int Dim>
std::vector<double> OutflowLayer<Dim>::values() const {
  std::vector<double> values;
  for_each<Dim>(owned_, [&](const Index<Dim>& cell) {
    for (int c = 0; c < Dim; ++c) values.push_back(now_[offset(kept_, cell, c)]);
  });
  return values;
}

template <int Dim>
void OutflowLayer<Dim>::set_values(const std::vector<double>& whole) {
  for_each<Dim>(kept_, [&](const Index<Dim>& cell) {
    const Index<Dim> image = grid_.inside(cell);
    for (int c = 0; c < Dim; ++c) now_[offset(kept_, cell, c)] = whole[offset(all_cells(), image, c)];
  });
}

template <int Dim>
void OutflowLayer<Dim>::register_state(StateList& state) {
  const std::string name = std::string("/outflow/") + "xyz"[axis_] + (end_ == End::lower ? "_lower" : "_upper");
  state.add({.name = name,
             .slab = box_slab<Dim>(all_cells(), owned_, Dim),
             .get = [this] { return values(); },
             .set = [this](const StateEntry::Values& whole) { set_values(whole); },
             .spread = StateEntry::Spread::parts_of_whole,
             .get_local = [this] { return now_; },
             .set_local = [this](StateEntry::Values local) { now_ = std::move(local); }});
}

template class OutflowLayer<2>;
template class OutflowLayer<3>;

}  // namespace washfsi
