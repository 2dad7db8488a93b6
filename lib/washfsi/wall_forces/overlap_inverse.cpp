// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/overlap_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/support/krylov.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

namespace {

constexpr double added = 0.3;  // to each diagonal entry, over its row sum

/// The mean overlap of the deltas of two patches' markers.
template <int Dim>
class PatchOverlap {
 public:
  PatchOverlap(const MarkerPatches<Dim>& patches, const MarkerLayout<Dim>& layout)
      : patches_(patches),
        layout_(layout),
        reach_(2 * layout.moments.width() * layout.cell),
        search_(bounds_of(patches.markers), reach_, hull(bounds_of(patches.markers))) {
    // each patch extends the list to its end, so its markers get its number
    for (std::size_t p = 0; p < patches.size(); ++p) patch_of_.resize(patches.starts[p + 1], p);
  }

  /// The overlaps of a patch with all patches that it touches.
  std::map<std::size_t, double> row(std::size_t patch) const {
    std::map<std::size_t, double> row;
    for (std::size_t m = patches_.starts[patch]; m < patches_.starts[patch + 1]; ++m)
      for (const std::size_t other : search_.near(Bounds<Dim>::round(patches_.markers[m], reach_))) {
        const double value = share(patch) * share(patch_of_[other]) * of_markers(m, other);
        if (value != 0) row[patch_of_[other]] += value;
      }
    return row;
  }

 private:
  double share(std::size_t patch) const {
    return 1.0 / static_cast<double>(patches_.starts[patch + 1] - patches_.starts[patch]);
  }
  double of_markers(std::size_t a, std::size_t b) const {
    const Point<Dim> shift = (patches_.markers[a] - patches_.markers[b]).cwiseQuotient(layout_.cell);
    double value = 1;
    for (int d = 0; d < Dim; ++d) value *= layout_.moments.overlap(shift[d]);
    return value;
  }

  const MarkerPatches<Dim>& patches_;
  const MarkerLayout<Dim>& layout_;
  Point<Dim> reach_;
  NearSearch<Dim> search_;
  std::vector<std::size_t> patch_of_;  ///< patch of each marker
};

/// A row of O: the patches, counted over all bodies, and their overlaps.
struct Row {
  std::vector<PetscInt> columns;
  std::vector<double> values;
};

template <int Dim>
std::vector<Row> rows_of(const std::vector<MarkerPatches<Dim>>& bodies, const MarkerLayout<Dim>& layout,
                         PatchRange own) {
  std::vector<Row> rows;
  std::size_t first = 0;
  for (const MarkerPatches<Dim>& patches : bodies) {
    const std::size_t begin = std::max(first, own.begin), end = std::min(first + patches.size(), own.end);
    if (begin < end) {
      const PatchOverlap<Dim> overlap(patches, layout);
      for (std::size_t p = begin; p < end; ++p) {
        Row& row = rows.emplace_back();
        for (const auto& [other, value] : overlap.row(p - first)) {
          row.columns.push_back(static_cast<PetscInt>(first + other));
          row.values.push_back(value);
        }
      }
    }
    first += patches.size();
  }
  return rows;
}

petsc::Matrix matrix_of(MPI_Comm comm, const std::vector<Row>& rows, PetscInt begin) {
  const auto size = static_cast<PetscInt>(rows.size());
  std::vector<PetscInt> own, others;
  for (const Row& row : rows) {
    const auto is_own = [&](PetscInt column) { return column >= begin && column < begin + size; };
    own.push_back(static_cast<PetscInt>(std::ranges::count_if(row.columns, is_own)));
    others.push_back(static_cast<PetscInt>(row.columns.size()) - own.back());
  }
  petsc::Matrix matrix;
  WASH_PETSC(
      MatCreateAIJ(comm, size, size, PETSC_DETERMINE, PETSC_DETERMINE, 0, own.data(), 0, others.data(), matrix.put()));
  for (PetscInt r = 0; r < size; ++r) {
    const Row& row = rows[static_cast<std::size_t>(r)];
    const PetscInt number = begin + r;
    WASH_PETSC(MatSetValues(matrix, 1, &number, static_cast<PetscInt>(row.columns.size()), row.columns.data(),
                            row.values.data(), INSERT_VALUES));
  }
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  return matrix;
}

// D_O^-1/2 O D_O^-1/2 + added I
petsc::Matrix raised(MPI_Comm comm, const std::vector<Row>& rows, PetscInt begin, const std::vector<double>& roots) {
  petsc::Matrix matrix = matrix_of(comm, rows, begin);
  petsc::Vector inverse;
  WASH_PETSC(MatCreateVecs(matrix, nullptr, inverse.put()));
  double* place = nullptr;
  WASH_PETSC(VecGetArrayWrite(inverse, &place));
  for (const double root : roots) *place++ = 1 / root;
  WASH_PETSC(VecRestoreArrayWrite(inverse, &place));
  WASH_PETSC(MatDiagonalScale(matrix, inverse, inverse));
  WASH_PETSC(MatShift(matrix, added));
  return matrix;
}

template <int Dim>
Points<Dim> scaled(Points<Dim> values, const std::vector<double>& factors, int power) {
  for (std::size_t p = 0; p < values.size(); ++p) values[p] *= power > 0 ? factors[p] : 1 / factors[p];
  return values;
}

}  // namespace

template <int Dim>
OverlapInverse<Dim>::OverlapInverse(const std::vector<MarkerPatches<Dim>>& bodies, const MarkerLayout<Dim>& layout,
                                    PatchRange own) {
  const std::vector<Row> rows = rows_of(bodies, layout, own);
  for (const Row& row : rows) roots_.push_back(std::sqrt(std::accumulate(row.values.begin(), row.values.end(), 0.0)));
  const petsc::Matrix of_patches = raised(layout.comm, rows, static_cast<PetscInt>(own.begin), roots_);
  WASH_PETSC(MatCreateMAIJ(of_patches, Dim, raised_.put()));
  WASH_PETSC(MatCreateVecs(raised_, solution_.put(), right_.put()));
  create_solver(layout.comm);
}

// Overlaps are a Gram matrix and nowhere negative, so that the eigenvalues of D_O^-1 O lie between 0 and 1.
template <int Dim>
void OverlapInverse<Dim>::create_solver(MPI_Comm comm) {
  constexpr PetscInt steps = 8;  // an error of 2 (0.35)^8
  WASH_PETSC(KSPCreate(comm, solver_.put()));
  WASH_PETSC(KSPSetOptionsPrefix(solver_, "walls_overlap_"));
  WASH_PETSC(KSPSetOperators(solver_, raised_, raised_));
  WASH_PETSC(KSPSetType(solver_, KSPCHEBYSHEV));
  WASH_PETSC(KSPChebyshevSetEigenvalues(solver_, 1 + added, added));
  WASH_PETSC(KSPSetNormType(solver_, KSP_NORM_NONE));
  WASH_PETSC(KSPSetConvergenceTest(solver_, KSPConvergedSkip, nullptr, nullptr));
  WASH_PETSC(KSPSetTolerances(solver_, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, steps));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetType(pc, PCNONE));
  (void)set_up_from_options(solver_);
}

template <int Dim>
Points<Dim> OverlapInverse<Dim>::operator()(const Points<Dim>& velocities) const {
  const petsc::LogPart part("wall_forces");
  to_vector<Dim>(scaled<Dim>(velocities, roots_, -1), right_);
  (void)solve_to(solver_, 0, right_, solution_, "overlaps of the walls");
  return scaled<Dim>(to_points<Dim>(solution_), roots_, -1);
}

template <int Dim>
Points<Dim> OverlapInverse<Dim>::means_about(const Points<Dim>& values) const {
  const petsc::LogPart part("wall_forces");
  to_vector<Dim>(scaled<Dim>(values, roots_, 1), right_);
  WASH_PETSC(MatMult(raised_, right_, solution_));
  WASH_PETSC(VecAXPY(solution_, -added, right_));
  return scaled<Dim>(to_points<Dim>(solution_), roots_, -1);
}

template class OverlapInverse<2>;
template class OverlapInverse<3>;

}  // namespace washfsi
