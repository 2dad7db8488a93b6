// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Divides the items of all ranks, in rank order, into equal parts, of which each rank works one out.
class EqualParts {
 public:
  /// `count`: of this rank's items. Collective.
  EqualParts(MPI_Comm comm, std::size_t count);

  /// So many numbers of each item, from this rank's items to those of its part. Collective.
  std::vector<double> to_parts(const double* values, int width) const;
  /// One number of each item, from this rank's part to its items. Collective.
  std::vector<double> to_owners(const std::vector<double>& values) const;

 private:
  std::vector<double> exchanged(const double* values, int width, const std::vector<int>& sent,
                                const std::vector<int>& received) const;

  MPI_Comm comm_;
  std::vector<int> sent_, received_;  ///< of this rank's items to each part; of each rank's to this rank's part
};

/// value(place) of each of this rank's places, worked out by all ranks in equal parts; `value` is the same function on
/// all ranks. Collective.
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
