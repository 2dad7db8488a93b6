// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/slab.hpp"

namespace washfsi {

/// A part of the state that is carried from step to step: a field, values of markers, some numbers.
struct StateEntry {
  using Values = std::vector<double>;

  /// Its distribution over the ranks.
  enum class Spread {
    parts,           ///< each rank its part
    parts_of_whole,  ///< each rank gives its part, and takes the whole
    shared,          ///< all ranks the same
  };
  /// The action of a restart from a file without it, or in which it has another shape.
  enum class IfOther { refuse, begin_anew };
  /// When it is restored.
  enum class Use {
    everywhere,
    restart,  ///< in a restart from a file only; a repeated step does not change it again
    retake,   ///< in a repeated step only; a restarted run computes it anew
  };

  std::string name;                 ///< its path in a file: /fluid/velocity
  Slab slab;                        ///< its slab in the file; without a shape if `shared` and of any length
  std::function<Values()> get;      ///< returns this rank's values
  std::function<void(Values)> set;  ///< sets the values; collective
  Spread spread = Spread::parts;
  IfOther if_other = IfOther::refuse;
  Use use = Use::everywhere;
  // where a rank keeps more in memory than in a file
  std::function<Values()> get_local = nullptr;
  std::function<void(Values)> set_local = nullptr;
};

/// An entry for this rank's part of a vector, of whichever vector its owner then has.
StateEntry vector_entry(const std::string& name, const Slab& slab, const petsc::Vector& vector);
/// An entry for numbers equal on all ranks, which must stay at their address.
StateEntry numbers_entry(const std::string& name, std::span<double> numbers);
/// An entry for one value per marker, patch or the like of this rank.
template <int Dim>
StateEntry points_entry(const std::string& name, const Slab& slab, Points<Dim>& points) {
  return {.name = name,
          .slab = slab,
          .get = [&points] { return flattened<Dim>(points); },
          .set = [&points](StateEntry::Values values) { points = as_points<Dim>(values); }};
}

/// All state that is carried from step to step, as its owners register it: the content of checkpoints, restored also
/// when a step is repeated.
class StateList {
 public:
  /// Adds an entry and returns it, so that its defaults can be changed.
  StateEntry& add(StateEntry entry) { return entries_.emplace_back(std::move(entry)); }
  /// Adds a number equal on all ranks, which must stay at its address.
  template <class Number>
  StateEntry& add_number(const std::string& name, Number& number) {
    return add({.name = name,
                .slab = {{1}, {0}, {1}},
                .get = [&number] { return StateEntry::Values{static_cast<double>(number)}; },
                .set = [&number](const StateEntry::Values& values) { number = static_cast<Number>(values.at(0)); },
                .spread = StateEntry::Spread::shared});
  }
  const std::vector<StateEntry>& entries() const { return entries_; }

 private:
  std::vector<StateEntry> entries_;
};

/// A copy of the state in memory, to be restored after any number of steps.
class StateCopy {
 public:
  /// Collective, as `restore` is.
  explicit StateCopy(StateList list);
  void restore() const;

 private:
  StateList list_;
  std::vector<StateEntry::Values> values_;
};

}  // namespace washfsi
