// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Means over the markers of a group of cloths or of a cloth, in which each marker counts by its share of a whole one's
/// area.
template <int Dim>
class MarkerMeans {
 public:
  /// The cloths must outlive it. Collective.
  explicit MarkerMeans(const Cloths<Dim>& cloths);

  /// The means over each group of so many values per marker, those of a marker beside each other. Collective.
  std::vector<std::vector<double>> of_groups(const std::vector<double>& values, std::size_t each) const;
  /// The means over each cloth of one value per marker. Collective.
  std::vector<double> of_cloths(const std::vector<double>& values) const;

 private:
  std::vector<double> group_sums(const std::vector<double>& values, std::size_t each) const;
  std::vector<double> cloth_sums(const std::vector<double>& values) const;

  const Cloths<Dim>& cloths_;
  std::vector<double> in_groups_, in_cloths_;  ///< number of markers of each group and cloth, each by its share
};

extern template class MarkerMeans<2>;
extern template class MarkerMeans<3>;

}  // namespace washfsi
