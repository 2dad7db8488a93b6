// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/quantity.hpp"
#include "washfsi/output/series.hpp"

namespace washfsi {

/// The data for measures after a step, beside the system.
template <int Dim>
struct Observation {
  double dt = 0;              ///< length of the step [s]
  double interval = 0;        ///< time since all was measured last [s]; 0 at the start
  Vec velocity = nullptr;     ///< velocity of the water, local, of face_dm, its ghosts filled [m/s]
  ContactLoads<Dim> contact;  ///< contact loads of all ranks' markers
};

/// A measure of a few related numbers.
template <int Dim>
class Measure {
 public:
  Measure() = default;
  Measure(const Measure&) = delete;
  Measure& operator=(const Measure&) = delete;
  virtual ~Measure() = default;

  /// Declares the numbers, and how each is obtained after `observe`. Called once.
  virtual void declare(QuantityList& quantities) = 0;
  /// Called before a step after which it will observe, if it did not observe after the previous one. Collective.
  virtual void prepare() {}
  /// Called after a step. Collective.
  virtual void observe(const Observation<Dim>& seen) = 0;
  /// Called at the start of a run, a restarted one included. Collective.
  virtual void observe_start(const Observation<Dim>&) {}
  /// The present values of this rank's markers for cloth.h5. Collective.
  virtual std::vector<MarkerField> marker_fields() const { return {}; }
};

/// The units of extensive quantities, per unit depth in the plane.
template <int Dim>
struct Units {
  static constexpr const char* force = Dim == 2 ? "N/m" : "N";
  static constexpr const char* torque = Dim == 2 ? "N m/m" : "N m";
  static constexpr const char* energy = Dim == 2 ? "J/m" : "J";
  static constexpr const char* power = Dim == 2 ? "W/m" : "W";
  static constexpr const char* angular_momentum = Dim == 2 ? "J s/m" : "J s";
};

/// The figures of most numbers for a cycle: mean, peak and root mean square.
inline std::vector<CycleFigure> mean_peak_rms(const std::string& name, const std::string& unit,
                                              const std::string& meaning, bool is_headline = false) {
  return {{name + "_mean", unit, OverCycle::mean, "mean " + meaning},
          {name + "_peak", unit, OverCycle::peak, "largest " + meaning + ", in size"},
          {name + "_rms", unit, OverCycle::rms, "root mean square of the " + meaning, 0, is_headline}};
}

/// Declares the components of the load with a number among others, which must outlive the list: its force and its
/// torque, columns PREFIX_force_x ... and entries under a pointer.
template <int Dim>
void declare_load(QuantityList& quantities, const std::string& prefix, const std::string& pointer,
                  const std::string& meaning, const Loads<Dim>& loads, std::size_t number) {
  for (int d = 0; d < Dim; ++d)
    quantities.add({prefix + "_force_" + "xyz"[d], Units<Dim>::force, "force " + meaning,
                    [&loads, number, d] { return loads[number].force[d]; }, Accumulation::none,
                    pointer + "/force/" + std::to_string(d)});
  for (int d = 0; d < rotation_components<Dim>; ++d)
    quantities.add({prefix + "_torque" + (Dim == 3 ? std::string("_") + "xyz"[d] : ""), Units<Dim>::torque,
                    "torque " + meaning, [&loads, number, d] { return loads[number].torque[d]; }, Accumulation::none,
                    pointer + "/torque" + (Dim == 3 ? "/" + std::to_string(d) : "")});
}

}  // namespace washfsi
