// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Divides the items of all ranks, in rank order, into equal parts, of which each rank processes one.
class EqualParts {
 public:
  /// `count` is the number of this rank's items. Collective.
  EqualParts(MPI_Comm comm, std::size_t count);

  /// Sends `width` numbers per item from this rank's items to the parts; returns those of its part. Collective.
  std::vector<double> to_parts(const double* values, int width) const;
  /// Sends one number per item from this rank's part to the owners; returns those of its items. Collective.
  std::vector<double> to_owners(const std::vector<double>& values) const;

 private:
  std::vector<double> exchanged(const double* values, int width, const std::vector<int>& sent,
                                const std::vector<int>& received) const;

  MPI_Comm comm_;
  std::vector<int> sent_, received_;  ///< counts of own items by part; of items in own part by rank
};

/// Returns value(place) for each of this rank's places, computed by all ranks in equal parts; `value` is the same
/// function on all ranks. Collective.
template <int Dim, class Value>
std::vector<double> shared_values(MPI_Comm comm, const Points<Dim>& places, const Value& value) {
  const EqualParts parts(comm, places.size());
  const std::vector<double> mine = parts.to_parts(places.empty() ? nullptr : places.front().data(), Dim);
  std::vector<double> values;
  values.reserve(mine.size() / Dim);
  for (auto place = mine.data(); place != mine.data() + mine.size(); place += Dim)
    values.push_back(value(Point<Dim>(place)));
  return parts.to_owners(values);
}

}  // namespace washfsi
