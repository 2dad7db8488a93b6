// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/marker_means.hpp"

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
MarkerMeans<Dim>::MarkerMeans(const Cloths<Dim>& cloths) : cloths_(cloths) {
  const std::vector<double> ones(cloths.owned(), 1.0);
  in_groups_ = group_sums(ones, 1);
  in_cloths_ = cloth_sums(ones);
}

template <int Dim>
std::vector<double> MarkerMeans<Dim>::group_sums(const std::vector<double>& values, std::size_t each) const {
  const std::vector<double>& shares = cloths_.marker_shares();
  std::vector<double> sums(cloths_.groups().size() * each, 0.0);
  for (std::size_t n = 0; n < values.size(); ++n)
    sums[cloths_.group_number(n / each) * each + n % each] += shares[n / each] * values[n];
  return ordered_sum(cloths_.comm(), sums);
}

template <int Dim>
std::vector<double> MarkerMeans<Dim>::cloth_sums(const std::vector<double>& values) const {
  const std::vector<double>& shares = cloths_.marker_shares();
  std::vector<double> sums(cloths_.pieces().size(), 0.0);
  for (std::size_t m = 0; m < values.size(); ++m) sums[cloths_.piece_of_marker()[m]] += shares[m] * values[m];
  return ordered_sum(cloths_.comm(), sums);
}

template <int Dim>
std::vector<std::vector<double>> MarkerMeans<Dim>::of_groups(const std::vector<double>& values,
                                                             std::size_t each) const {
  const std::vector<double> sums = group_sums(values, each);
  std::vector<std::vector<double>> means;
  for (std::size_t g = 0; g < in_groups_.size(); ++g) {
    means.emplace_back(sums.begin() + static_cast<long>(g * each), sums.begin() + static_cast<long>((g + 1) * each));
    for (double& mean : means.back()) mean /= in_groups_[g];
  }
  return means;
}

template <int Dim>
std::vector<double> MarkerMeans<Dim>::of_cloths(const std::vector<double>& values) const {
  std::vector<double> means = cloth_sums(values);
  for (std::size_t p = 0; p < means.size(); ++p) means[p] /= in_cloths_[p];
  return means;
}

template class MarkerMeans<2>;
template class MarkerMeans<3>;

}  // namespace washfsi
