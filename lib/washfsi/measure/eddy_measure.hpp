// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The viscosity of the liquid's models, and the y+ of the cells beside walls, where either is modelled.
template <int Dim>
class EddyMeasure : public Measure<Dim> {
 public:
  /// The system must outlive it.
  explicit EddyMeasure(const System<Dim>& system) : system_(system) {}

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;

 private:
  const System<Dim>& system_;
  bool models_walls() const;

  double mean_ = 0, largest_ = 0;  ///< mean and largest viscosity of models [Pa s]
  double y_plus_ = 0;
  std::vector<double> body_y_plus_;  ///< largest y+ of each body, if they have a law
};

extern template class EddyMeasure<2>;
extern template class EddyMeasure<3>;

}  // namespace washfsi
