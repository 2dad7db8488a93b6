// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/mask/wall_loads.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// Loads on the sides of the box that are walls or slip.
template <int Dim>
class WallMeasure : public Measure<Dim> {
 public:
  /// Collective.
  explicit WallMeasure(const System<Dim>& system);

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;

 private:
  const System<Dim>& system_;
  std::vector<SideName> walls_;
  Loads<Dim> loads_;
};

extern template class WallMeasure<2>;
extern template class WallMeasure<3>;

}  // namespace washfsi
