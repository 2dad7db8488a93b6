// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "washfsi/fluid/wall_viscosity.hpp"
#include "washfsi/grid/cell_share.hpp"
#include "washfsi/grid/viscous_stress.hpp"

namespace washfsi {

/// A contribution to the viscosity that depends on the flow, such as an eddy viscosity.
template <int Dim>
class ViscosityModel {
 public:
  ViscosityModel() = default;
  ViscosityModel(const ViscosityModel&) = delete;
  ViscosityModel& operator=(const ViscosityModel&) = delete;
  virtual ~ViscosityModel() = default;

  /// Adds to the dynamic viscosity [Pa s] of this rank's cells by their share of fluid. The velocity [m/s] has a layer
  /// of ghosts, filled. Collective.
  virtual void add(const Grid<Dim>& grid, const ConstFaceView<Dim>& velocity, const PureLiquid& liquid,
                   const CellShare<Dim>& share, const CellView<Dim>& viscosity) const = 0;
};

/// None of them may be null.
template <int Dim>
using ViscosityModels = std::vector<std::shared_ptr<const ViscosityModel<Dim>>>;

/// The fields of a liquid for the fluid's equations.
struct LiquidFields {
  Vec density = nullptr;  ///< on faces [kg/m3]
  Viscosity viscosity;
};

/// The liquid: its density and viscosity as fields.
template <int Dim>
class Liquid {
 public:
  /// The models add to the viscosity of the pure liquid.
  Liquid(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const PureLiquid& pure, ViscosityModels<Dim> models = {},
         WallTreatment walls = WallTreatment::none);

  const PureLiquid& pure() const { return pure_; }
  /// Density on faces, added masses included [kg/m3].
  Vec density() const { return density_; }
  /// The liquid's own density on faces [kg/m3]; null where it is the pure liquid's everywhere.
  Vec own_density() const { return own_density_; }
  /// Gives the liquid a density that differs from face to face [kg/m3]; it does not move. Collective.
  void set_own_density(Vec density);
  /// Sets the density to the liquid's own; added masses have to be added again.
  void reset_density();

  Viscosity viscosity() const { return varying_ ? varying_->viscosity() : Viscosity{pure_.viscosity}; }
  /// Updates the models' viscosity and the friction of sides from the flow. Models count by the share of fluid round a
  /// cell: water in a body moves rigidly and has no eddies. Then applies the friction of `bodies`, null without. May be
  /// repeated for the same time. Collective.
  void update_viscosity(const StepFlow& flow, WallViscosity* bodies = nullptr);

  /// Updates only the models' viscosity, for measures before the first step. Collective.
  void let_models_add(const StepFlow& flow);
  /// The model of the friction of the box's walls; null if there is none.
  WallModel<Dim>* walls() const { return walls_.get(); }
  bool has_models() const { return !models_.empty(); }
  /// Calls visit(viscosity) with the models' viscosity in each of this rank's cells [Pa s], x fastest; there must be
  /// models.
  template <class Visit>
  void visit_added_viscosity(Visit&& visit) const {
    const ConstCellView<Dim> mu(grid_.cell_dm(), global_viscosity_);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) { visit(mu(cell) - pure_.viscosity); });
  }

  LiquidFields fields() const { return {density_, viscosity()}; }

 private:
  void let_models_add(const StepFlow& flow, const CellShare<Dim>& share);
  void let_walls_follow(const StepFlow& flow, const CellShare<Dim>& share);

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  PureLiquid pure_;
  ViscosityModels<Dim> models_;
  std::unique_ptr<WallModel<Dim>> walls_;
  std::optional<double> walls_time_;  ///< time of the flow that the walls observed last [s]
  petsc::Vector density_, own_density_, global_viscosity_;
  std::optional<ViscosityField<Dim>> varying_;
};

extern template class Liquid<2>;
extern template class Liquid<3>;

}  // namespace washfsi
