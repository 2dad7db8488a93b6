// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// The fields at the start of a step that advection reads.
struct AdvectedFields {
  DM velocity_dm = nullptr;      ///< has the ghosts of the velocity: two where a scheme departs from central
  Vec local_velocity = nullptr;  ///< with its ghosts filled [m/s]
  Vec density = nullptr;         ///< on faces [kg/m3]
  Vec fluid_fraction = nullptr;  ///< on faces; null: 1. Water in solids dissipates nothing by its advection.
  Vec upwind_weight = nullptr;   ///< on faces, for advection that is limited at edges
};

/// A scheme of the advection term u.grad u, in flux form (`advection.hpp`).
template <int Dim>
class AdvectionScheme {
 public:
  AdvectionScheme() = default;
  AdvectionScheme(const AdvectionScheme&) = delete;
  AdvectionScheme& operator=(const AdvectionScheme&) = delete;
  virtual ~AdvectionScheme() = default;

  /// Whether what it carries is bounded by its neighbours everywhere.
  virtual bool is_bounded() const = 0;
  /// Whether it is another than central advection anywhere; it then reads two faces in each direction.
  virtual bool departs_from_central() const = 0;
  /// Writes the term to inner faces [m/s2]. Returns the power that it dissipates and central advection does not [W; W/m
  /// in two dimensions]. Collective.
  virtual double find(const AdvectedFields& fields, Vec term) const = 0;
};

/// The names of all schemes, of which -advection takes one.
std::vector<std::string> advection_schemes();

/// Makes the scheme of this name. `limits_at_edges`: central advection gives way to upwind by `upwind_weight`.
/// Errors: InputError if there is none.
template <int Dim>
std::unique_ptr<AdvectionScheme<Dim>> make_advection_scheme(const std::string& name, const Grid<Dim>& grid,
                                                            bool limits_at_edges);

extern template std::unique_ptr<AdvectionScheme<2>> make_advection_scheme<2>(const std::string&, const Grid<2>&, bool);
extern template std::unique_ptr<AdvectionScheme<3>> make_advection_scheme<3>(const std::string&, const Grid<3>&, bool);

}  // namespace washfsi
