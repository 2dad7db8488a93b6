// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/cloth_wall_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/cloth/sheet_states.hpp"
#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// |s| over the friction on both sides of a plate with laminar layers.
double blasius_ease(const PureLiquid& liquid, double speed, double length) {
  const double reynolds = speed * length * liquid.density / liquid.viscosity;
  return std::sqrt(reynolds) / (2 * 0.664 * liquid.density * speed);
}

double mean_width(const DeltaOptions& delta) {
  return 0.5 * (delta.spread_width + delta.interpolate_width);
}

}  // namespace

ClothLayer cloth_layer(const PureLiquid& liquid, double distance, double speed, double length) {
  constexpr double viscous_layer = 5;  // y+ up to which a layer is laminar
  const double nu = liquid.viscosity / liquid.density;
  ClothLayer layer;
  layer.y_plus = wall_distance(speed * distance / nu);
  const double part = layer.y_plus > 1e-3 ? reichardt(layer.y_plus) / layer.y_plus : 1;  // E over that of a line
  layer.ease = part * distance / (2 * liquid.viscosity);
  if (speed > 0) layer.ease = std::min(layer.ease, blasius_ease(liquid, speed, length));
  const double laminar = std::exp(-std::pow(layer.y_plus / viscous_layer, 2));
  layer.memory = std::numbers::pi / 4 * distance * distance / nu * laminar;
  return layer;
}

double edge_friction(double density, double speed, double pressure) {
  if (!(pressure > 0)) return 0;
  constexpr double most = 5, least_speed = 0.01;
  const double share = pressure / (pressure + density * speed * speed);
  return most * share * pressure / (speed + least_speed * std::sqrt(pressure / density));
}

namespace {

// Friction G of a marker with these edge directions. Its component across the cloth is arbitrary; callers project it
// away.
template <int Dim>
Block<Dim> friction_of(const ClothLayer& layer, double edge, const Outwards<Dim>& outwards, const Block<Dim>& along) {
  Block<Dim> friction = Block<Dim>::Identity() / layer.ease;
  for (const Point<Dim>& towards : {outwards.s, outwards.r}) {
    const Point<Dim> b = along * towards;
    if (!b.isZero(0)) friction += edge / b.squaredNorm() * b * b.transpose();
  }
  return friction;
}

}  // namespace

template <int Dim>
ClothWallModel<Dim>::ClothWallModel(const Model<Dim>& model)
    : model_(model), kernel_(model.transfer.delta().kernel, mean_width(model.transfer.delta())) {}

// p of each piece.
template <int Dim>
std::vector<double> ClothWallModel<Dim>::mean_pressures(const Points<Dim>& normals, const Points<Dim>& forces) const {
  const Cloths<Dim>& cloths = model_.cloths;
  const std::size_t pieces = cloths.pieces().size();
  std::vector<double> sums(2 * pieces, 0.0);
  for (std::size_t m = 0; m < normals.size(); ++m) {
    const std::size_t piece = cloths.piece_of_marker()[m];
    sums[2 * piece] += normals[m].dot(forces[m]);
    sums[2 * piece + 1] += cloths.marker_areas()[m];
  }
  sums = ordered_sum(cloths.comm(), sums);
  std::vector<double> pressures;
  for (std::size_t piece = 0; piece < pieces; ++piece)
    pressures.push_back(std::abs(sums[2 * piece]) / sums[2 * piece + 1]);
  return pressures;
}

// L: a side of a square cloth.
template <int Dim>
double ClothWallModel<Dim>::length_of(std::size_t marker) const {
  const auto& size = model_.cloths.group_of(marker).size;
  return Dim == 3 ? std::sqrt(size[0] * size[1]) : size[0];
}

template <int Dim>
void ClothWallModel<Dim>::begin_step(const State<Dim>& state, double dt) {
  const Cloths<Dim>& cloths = model_.cloths;
  const PureLiquid liquid = model_.liquid.pure();
  const Points<Dim> normals = washfsi::normals(cloths, state.positions);
  const std::vector<Outwards<Dim>> outwards = washfsi::outwards(cloths, state.positions);
  const std::vector<double> pressures = mean_pressures(normals, state.water_forces);
  eases_.assign(normals.size(), Block<Dim>::Zero());
  rests_.assign(normals.size(), Point<Dim>::Zero());
  for (std::size_t m = 0; m < normals.size(); ++m) {
    const Point<Dim>& n = normals[m];
    if (n.isZero(0)) continue;
    const Block<Dim> unit = Block<Dim>::Identity(), along = unit - n * n.transpose();
    const double y = kernel_.sheet_reach<Dim>(n, model_.grid.spacing());
    const double speed = (0.5 * (along * (state.slips[m] + state.slips_before[m]))).norm();
    const ClothLayer layer = cloth_layer(liquid, y, speed, length_of(m));
    const double edge = edge_friction(liquid.density, speed, pressures[cloths.piece_of_marker()[m]]);
    const Block<Dim> friction = friction_of<Dim>(layer, edge, outwards[m], along);
    const Block<Dim> kept = (layer.memory * friction + cloths.group_of(m).sheet.held_water * unit) / dt;
    const Block<Dim> ease = along * (friction + kept).inverse() * along;
    eases_[m] = ease / cloths.marker_areas()[m];
    rests_[m] = ease * kept * along * state.slips[m];
  }
}

template <int Dim>
Points<Dim> ClothWallModel<Dim>::slips(const Points<Dim>& forces) const {
  Points<Dim> result = rests_;
  for (std::size_t m = 0; m < result.size(); ++m) result[m] += eases_[m] * forces[m];
  return result;
}

template class ClothWallModel<2>;
template class ClothWallModel<3>;

}  // namespace washfsi
