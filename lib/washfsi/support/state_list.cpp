// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/state_list.hpp"

#include <algorithm>

namespace washfsi {

StateEntry vector_entry(const std::string& name, const Slab& slab, const petsc::Vector& vector) {
  return {.name = name,
          .slab = slab,
          .get =
              [&vector] {
                const double* values = nullptr;
                PetscInt size = 0;
                WASH_PETSC(VecGetLocalSize(vector, &size));
                WASH_PETSC(VecGetArrayRead(vector, &values));
                StateEntry::Values copy(values, values + size);
                WASH_PETSC(VecRestoreArrayRead(vector, &values));
                return copy;
              },
          .set =
              [&vector](const StateEntry::Values& copy) {
                double* values = nullptr;
                WASH_PETSC(VecGetArray(vector, &values));
                std::ranges::copy(copy, values);
                WASH_PETSC(VecRestoreArray(vector, &values));
              }};
}

StateEntry numbers_entry(const std::string& name, std::span<double> numbers) {
  return {.name = name,
          .slab = {{numbers.size()}, {0}, {numbers.size()}},
          .get = [numbers] { return StateEntry::Values(numbers.begin(), numbers.end()); },
          .set = [numbers](const StateEntry::Values& values) { std::ranges::copy(values, numbers.begin()); },
          .spread = StateEntry::Spread::shared};
}

StateCopy::StateCopy(StateList list) : list_(std::move(list)) {
  for (const StateEntry& entry : list_.entries())
    values_.push_back(entry.use == StateEntry::Use::restart ? StateEntry::Values{}
                      : entry.get_local                     ? entry.get_local()
                                                            : entry.get());
}

void StateCopy::restore() const {
  for (std::size_t n = 0; n < values_.size(); ++n) {
    const StateEntry& entry = list_.entries()[n];
    if (entry.use == StateEntry::Use::restart) continue;
    (entry.set_local ? entry.set_local : entry.set)(values_[n]);
  }
}

}  // namespace washfsi
