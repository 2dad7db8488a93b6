// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/face_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "washfsi/immersed_boundary/overlap.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// The scaled weights as a copy, which cannot alias the faces' values.
template <int Most>
std::array<double, Most> scaled(const AxisStencilOf<Most>& stencil, double factor) {
  std::array<double, Most> weights;
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = factor * stencil.weight[i];
  return weights;
}

}  // namespace

template <int Dim>
struct FaceMobility<Dim>::Faces {
  double* values;
  Index<Dim> lower, strides;
  PetscInt first;

  Faces(double* of_all, const Box<Dim>& box, int component) : values(of_all), lower(box.lower) {
    PetscInt stride = 1;
    for (int d = 0; d < Dim; ++d) {
      strides[d] = stride;
      stride *= box.upper[d] - box.lower[d];
    }
    first = component * stride;
  }
  PetscInt number(const Index<Dim>& index) const {
    PetscInt number = first;
    for (int d = 0; d < Dim; ++d) number += (index[d] - lower[d]) * strides[d];
    return number;
  }
  double& operator()(const Index<Dim>& index, int /*component*/ = 0) const { return values[number(index)]; }
  PetscInt stride(int axis) const { return strides[axis]; }
};

// Estimates the pairs of markers within reach from those in the same or neighbouring bins, which are as wide.
template <int Dim>
double FaceMobility<Dim>::pairs_within_reach(const Points<Dim>& positions, std::size_t first, std::size_t count) const {
  const Point<Dim> reach = 2 * delta_.spread_width * grid_.spacing();
  const auto bin_of = [&](const Point<Dim>& position) {
    Index<Dim> bin;
    for (int d = 0; d < Dim; ++d) bin[d] = static_cast<PetscInt>(std::floor(grid_.folded(position)[d] / reach[d]));
    return bin;
  };
  std::map<Index<Dim>, double> of_all, of_own;
  for (std::size_t m = 0; m < positions.size(); ++m) {
    of_all[bin_of(positions[m])] += 1;
    if (m >= first && m < first + count) of_own[bin_of(positions[m])] += 1;
  }
  double pairs = 0;
  for (const auto& bin : of_own) {
    Box<Dim> around;
    for (int d = 0; d < Dim; ++d) {
      around.lower[d] = bin.first[d] - 1;
      around.upper[d] = bin.first[d] + 2;
    }
    for_each(around, [&](const Index<Dim>& other) {
      const auto found = of_all.find(other);
      if (found != of_all.end()) pairs += bin.second * found->second;
    });
  }
  return std::pow(2.0 / 3, Dim) * pairs;
}

template <int Dim>
bool FaceMobility<Dim>::is_faster(const Points<Dim>& positions, std::size_t first, std::size_t count) const {
  constexpr double pairs_per_point =
      0.5;  // at about equal cost: pairs are read from memory, faces mostly from the cache
  if (delta_.spread_width != delta_.interpolate_width) return false;
  double cells = 1;
  for (int d = 0; d < Dim; ++d) {
    if (grid_.periodic(d) && grid_.cells()[d] < 2 * AxisStencil::most) return false;
    cells *= static_cast<double>(grid_.cells()[d]);
  }
  const std::vector<double> sums = ordered_sum(
      grid_.comm(), std::vector<double>{pairs_within_reach(positions, first, count), static_cast<double>(count)});
  const double points = std::pow(2 * delta_.spread_width, Dim) * sums[1];
  return sums[0] > pairs_per_point * (points + cells);
}

// Sets the box that encloses all stencils and, with periodic sides, the images of what lies beyond these.
template <int Dim>
template <class Stencils>
void FaceMobility<Dim>::enclose(const Stencils& stencils) {
  box_ = {};
  for (int d = 0; d < Dim && !stencils.empty(); ++d) {
    PetscInt lower = std::numeric_limits<PetscInt>::max(), upper = std::numeric_limits<PetscInt>::lowest();
    for (const auto& stencil : stencils)
      for (const int component : {d, (d + 1) % Dim}) {
        const auto& along = stencil.along(d, component);
        lower = std::min(lower, along.first);
        upper = std::max(upper, along.first + along.count);
      }
    if (grid_.periodic(d)) {
      lower = std::min<PetscInt>(lower, 0);
      upper = std::max(upper, grid_.cells()[d]);
    }
    box_.lower[d] = lower;
    box_.upper[d] = upper;
  }
  faces_.resize(Dim * box_.count());
  std::vector<Box<Dim>> boxes(static_cast<std::size_t>(ranks_of(grid_.comm())));
  MPI_Allgather(&box_, sizeof(box_), MPI_BYTE, boxes.data(), sizeof(box_), MPI_BYTE, grid_.comm());
  find_shared(boxes);
}

template <int Dim>
void FaceMobility<Dim>::find_shared(const std::vector<Box<Dim>>& boxes) {
  std::vector<PetscSFNode> sources;
  shared_.clear();
  for (std::size_t rank = 0; rank < boxes.size(); ++rank) {
    if (static_cast<int>(rank) == rank_of(grid_.comm())) continue;
    for (int component = 0; component < Dim; ++component) {
      const Faces here(nullptr, box_, component), there(nullptr, boxes[rank], component);
      for_each(box_.common(boxes[rank]), [&](const Index<Dim>& face) {
        shared_.push_back(static_cast<std::size_t>(here.number(face)));
        sources.push_back({static_cast<PetscInt>(rank), there.number(face)});
      });
    }
  }
  others_ = petsc::star_forest(grid_.comm(), faces_.size(), sources);
  values_of_others_.resize(shared_.size());
}

// Calls visit(outside, image) for the faces beyond periodic sides and their images within.
template <int Dim>
template <class Visit>
void FaceMobility<Dim>::visit_images(const Visit& visit) const {
  for (int axis = 0; axis < Dim; ++axis) {
    if (!grid_.periodic(axis)) continue;
    const PetscInt cells = grid_.cells()[axis];
    for (int component = 0; component < Dim; ++component) {
      const Faces field(faces_.data(), box_, component);
      Box<Dim> below = box_, above = box_;
      below.upper[axis] = 0;
      above.lower[axis] = cells;
      for_each(below, [&](const Index<Dim>& i) { visit(field(i), field(shifted<Dim>(i, axis, cells))); });
      for_each(above, [&](const Index<Dim>& i) { visit(field(i), field(shifted<Dim>(i, axis, -cells))); });
    }
  }
}

// Adds what markers of other ranks have spread to these faces, and what was spread to periodic images.
template <int Dim>
void FaceMobility<Dim>::add_others() const {
  visit_images([](double& outside, double& image) { image += std::exchange(outside, 0.0); });
  WASH_PETSC(PetscSFBcastBegin(others_, MPI_DOUBLE, faces_.data(), values_of_others_.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(others_, MPI_DOUBLE, faces_.data(), values_of_others_.data(), MPI_REPLACE));
  for (std::size_t n = 0; n < shared_.size(); ++n) faces_[shared_[n]] += values_of_others_[n];
  visit_images([](double& outside, const double& image) { outside = image; });
}

template <int Dim>
template <class Stencils>
void FaceMobility<Dim>::spread(const Stencils& stencils, const Points<Dim>& values) const {
  std::fill(faces_.begin(), faces_.end(), 0.0);
  for (int c = 0; c < Dim; ++c) {
    const Faces field(faces_.data(), box_, c);
    for (std::size_t m = 0; m < stencils.size(); ++m)
      with_count(stencils[m].along(0, c).count, [&](auto count) {
        const auto x = scaled(stencils[m].along(0, c), values[m][c]);
        stencils[m].visit_rows(c, field, [&](double* row, double weight) {
          for (int i = 0; i < count; ++i) row[i] += weight * x[i];
        });
      });
  }
}

template <int Dim>
template <class Stencils>
Points<Dim> FaceMobility<Dim>::interpolate(const Stencils& stencils) const {
  Points<Dim> result(stencils.size());
  for (int c = 0; c < Dim; ++c) {
    const Faces field(faces_.data(), box_, c);
    for (std::size_t m = 0; m < stencils.size(); ++m)
      with_count(stencils[m].along(0, c).count, [&](auto count) {
        const auto& x = stencils[m].along(0, c).weight;
        std::decay_t<decltype(x)> sums{};  // sums over all rows, for each face along x
        stencils[m].visit_rows(c, field, [&](const double* row, double weight) {
          for (int i = 0; i < count; ++i) sums[i] += weight * row[i];
        });
        result[m][c] = 0;
        for (int i = 0; i < count; ++i) result[m][c] += x[i] * sums[i];
      });
  }
  return result;
}

template <int Dim>
Points<Dim> FaceMobility<Dim>::overlaps(const Points<Dim>& values) const {
  Points<Dim> result;
  stencils_.visit([&](const auto& stencils) {
    spread(stencils, values);
    add_others();
    result = interpolate(stencils);
  });
  return result;
}

template <int Dim>
void FaceMobility<Dim>::locate(const Points<Dim>& positions, const std::vector<double>& row_sums, double own_share) {
  stencils_ = FaceStencils<Dim>({delta_.kernel, delta_.spread_width}, grid_, positions);
  stencils_.visit([&](const auto& stencils) { enclose(stencils); });
  scales_.clear();
  const Points<Dim> sums = overlaps(Points<Dim>(positions.size(), Point<Dim>::Ones()));
  own_.clear();
  stencils_.visit([&](const auto& stencils) {
    for (std::size_t m = 0; m < sums.size(); ++m) {
      scales_.push_back(row_sums[m] / sums[m].maxCoeff());
      own_.push_back(own_share * scales_[m] * overlap(grid_, stencils[m], stencils[m]));
    }
  });
}

template <int Dim>
Points<Dim> FaceMobility<Dim>::times(const Points<Dim>& values) const {
  const petsc::LogPart part("face_mobility");
  Points<Dim> scaled = values;
  for (std::size_t m = 0; m < scaled.size(); ++m) scaled[m] *= std::sqrt(scales_[m]);
  Points<Dim> result = overlaps(scaled);
  for (std::size_t m = 0; m < result.size(); ++m) {
    result[m] *= std::sqrt(scales_[m]);
    result[m] += own_[m].cwiseProduct(values[m]);
  }
  return result;
}

template class FaceMobility<2>;
template class FaceMobility<3>;

}  // namespace washfsi
