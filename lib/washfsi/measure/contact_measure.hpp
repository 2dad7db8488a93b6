// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/contact/contact_force.hpp"
#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/measure.hpp"

namespace washfsi {

/// The normal forces between cloths and on bodies and sides of the box, and the power of friction.
template <int Dim>
class ContactMeasure : public Measure<Dim> {
 public:
  /// The system must outlive it.
  explicit ContactMeasure(const System<Dim>& system);

  void declare(QuantityList& quantities) override;
  void observe(const Observation<Dim>& seen) override;
  std::vector<MarkerField> marker_fields() const override;

 private:
  struct Group {
    double of_cloths = 0, of_bodies = 0, friction_power = 0;  ///< normal forces [N], power [W; per depth in the plane]
  };
  void declare_group(QuantityList& quantities, std::size_t group);
  MarkerContact contact(bool with_bodies) const;
  bool present(bool with_bodies) const { return !forces_[with_bodies].empty(); }

  const System<Dim>& system_;
  std::array<std::vector<const ContactForce<Dim>*>, 2> forces_;  ///< between cloths; with bodies, sides
  std::vector<Group> groups_;
};

extern template class ContactMeasure<2>;
extern template class ContactMeasure<3>;

}  // namespace washfsi
