// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/marker_means.hpp"

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Sums of so many values per marker, each times the marker's share, over what number_of(marker) counts.
template <int Dim, class NumberOf>
std::vector<double> sums_by(const Cloths<Dim>& cloths, std::size_t count, const std::vector<double>& values,
                            std::size_t each, const NumberOf& number_of) {
  std::vector<double> sums(count * each, 0.0);
  for (std::size_t n = 0; n < values.size(); ++n)
    sums[number_of(n / each) * each + n % each] += cloths.marker_shares()[n / each] * values[n];
  return ordered_sum(cloths.comm(), sums);
}

}  // namespace

template <int Dim>
MarkerMeans<Dim>::MarkerMeans(const Cloths<Dim>& cloths) : cloths_(cloths) {
  const std::vector<double> ones(cloths.owned(), 1.0);
  in_groups_ = group_sums(ones, 1);
  in_cloths_ = cloth_sums(ones);
}

template <int Dim>
std::vector<double> MarkerMeans<Dim>::group_sums(const std::vector<double>& values, std::size_t each) const {
  return sums_by(cloths_, cloths_.groups().size(), values, each,
                 [this](std::size_t marker) { return cloths_.group_number(marker); });
}

template <int Dim>
std::vector<double> MarkerMeans<Dim>::cloth_sums(const std::vector<double>& values) const {
  return sums_by(cloths_, cloths_.pieces().size(), values, 1,
                 [this](std::size_t marker) { return cloths_.piece_of_marker()[marker]; });
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
