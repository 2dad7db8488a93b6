// SPDX-License-Identifier: BSD-3-Clause
//
// Eddies smaller than a cell, as a viscosity: from the velocity's gradient in the middle of each cell, by one of
// several laws. Each law is a file pair of its own, and a row of `laws` in eddy_viscosity.cpp.
#pragma once

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/grid/velocity_gradient.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// A law gives the eddy viscosity [m2/s] of a cell with this gradient [1/s] (`velocity_gradient`), and is made from its
/// constant and the cell's sides [m].
template <class Law>
class EddyViscosity : public ViscosityModel<3> {
 public:
  explicit EddyViscosity(double constant) : constant_(constant) {}

  void add(const Grid<3>& grid, const ConstFaceView<3>& velocity, const PureLiquid& liquid, const CellShare<3>& share,
           const CellView<3>& viscosity) const override {
    const Law law(constant_, grid.spacing());
    const Spacing<3> h(grid.spacing());
    for_each<3>(grid.owned(), [&](const Index<3>& cell) {
      const double part = share(cell);
      if (part > 0) viscosity(cell) += part * liquid.density * law(velocity_gradient<3>(velocity, cell, h));
    });
  }

 private:
  double constant_;
};

/// Returns the model that the user chose, or null. Errors: InputError.
template <int Dim>
std::shared_ptr<const ViscosityModel<Dim>> eddy_viscosity_from_options(Options& options);

}  // namespace washfsi
