// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/slab.hpp"

namespace washfsi {

/// One thing that goes on from step to step: a field, values of markers, some numbers.
struct StateEntry {
  using Values = std::vector<double>;

  /// Who has what of it.
  enum class Spread {
    parts,           ///< each rank its part
    parts_of_whole,  ///< each rank gives its part, and takes the whole
    shared,          ///< all ranks the same
  };
  /// What a run does that goes on from a file without it, or in which it has another shape.
  enum class IfOther { refuse, begin_anew };
  /// Where it is put back.
  enum class Use {
    everywhere,
    restart,  ///< in a run that goes on from a file; a step that is taken again has seen it at its start, and keeps it
    retake,   ///< in a step that is taken again; a run finds it anew
  };

  std::string name;                 ///< a path in a file: /fluid/velocity
  Slab slab;                        ///< without a shape if `shared` and of any length
  std::function<Values()> get;      ///< of this rank
  std::function<void(Values)> set;  ///< collective
  Spread spread = Spread::parts;
  IfOther if_other = IfOther::refuse;
  Use use = Use::everywhere;
  // where a rank keeps more in memory than in a file
  std::function<Values()> get_local = nullptr;
  std::function<void(Values)> set_local = nullptr;
};

/// This rank's part of a vector, whichever its owner has by then.
StateEntry vector_entry(const std::string& name, const Slab& slab, const petsc::Vector& vector);
/// Numbers that all ranks have alike; they stay where they are.
StateEntry numbers_entry(const std::string& name, std::span<double> numbers);
/// One value per marker, patch or the like of this rank.
template <int Dim>
StateEntry points_entry(const std::string& name, const Slab& slab, Points<Dim>& points) {
  return {.name = name,
          .slab = slab,
          .get = [&points] { return flattened<Dim>(points); },
          .set = [&points](StateEntry::Values values) { points = as_points<Dim>(values); }};
}

/// All that goes on from step to step, as its owners register it: what checkpoints hold, and what is put back when a
/// step is taken again.
class StateList {
 public:
  /// Returns the entry, for what is unlike most.
  StateEntry& add(StateEntry entry) { return entries_.emplace_back(std::move(entry)); }
  /// A number that all ranks have alike; it stays where it is.
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

/// The state in memory, to be put back after any number of steps.
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
