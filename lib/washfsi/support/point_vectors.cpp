// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/point_vectors.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace washfsi {

template <int Dim>
void to_vector(const Points<Dim>& points, Vec vector) {
  double* values = nullptr;
  WASH_PETSC(VecGetArrayWrite(vector, &values));
  for (const Point<Dim>& point : points) values = std::copy_n(point.data(), Dim, values);
  values = nullptr;
  WASH_PETSC(VecRestoreArrayWrite(vector, &values));
}

template <int Dim>
Points<Dim> to_points(Vec vector) {
  const double* values = nullptr;
  PetscInt size = 0;
  WASH_PETSC(VecGetLocalSize(vector, &size));
  WASH_PETSC(VecGetArrayRead(vector, &values));
  Points<Dim> points(static_cast<std::size_t>(size / Dim));
  for (std::size_t m = 0; m < points.size(); ++m) points[m] = Point<Dim>(values + m * Dim);
  WASH_PETSC(VecRestoreArrayRead(vector, &values));
  return points;
}

template <int Dim>
Points<Dim> MatrixProduct<Dim>::operator()(Mat matrix, const Points<Dim>& values) const {
  if (!values_) WASH_PETSC(MatCreateVecs(matrix, values_.put(), result_.put()));
  to_vector<Dim>(values, values_);
  WASH_PETSC(MatMult(matrix, values_, result_));
  return to_points<Dim>(result_);
}

namespace {

// One value per marker for all of its coordinates.
template <int Dim>
petsc::Vector vector_of(const std::vector<double>& values, Mat matrix) {
  petsc::Vector vector;
  WASH_PETSC(MatCreateVecs(matrix, nullptr, vector.put()));
  Points<Dim> points;
  for (const double value : values) points.push_back(Point<Dim>::Constant(value));
  to_vector<Dim>(points, vector);
  return vector;
}

}  // namespace

template <int Dim>
void scale_and_shift(const std::vector<double>& row_factors, const std::vector<double>& diagonal, Mat matrix) {
  WASH_PETSC(MatDiagonalScale(matrix, vector_of<Dim>(row_factors, matrix), nullptr));
  WASH_PETSC(MatDiagonalSet(matrix, vector_of<Dim>(diagonal, matrix), ADD_VALUES));
}

template <int Dim>
void scale_columns_and_shift(const std::vector<double>& column_factors, double diagonal, Mat matrix) {
  WASH_PETSC(MatDiagonalScale(matrix, nullptr, vector_of<Dim>(column_factors, matrix)));
  WASH_PETSC(MatShift(matrix, diagonal));
}

namespace {

// The values of one marker's rows, which have the same columns.
template <int Dim>
struct MarkerRows {
  std::vector<PetscInt> columns;
  Eigen::Matrix<double, Dim, Eigen::Dynamic, Eigen::RowMajor> values;
};

template <int Dim>
MarkerRows<Dim> rows_at(Mat matrix, PetscInt first) {
  MarkerRows<Dim> rows;
  for (int d = 0; d < Dim; ++d) {
    PetscInt count = 0;
    const PetscInt* columns = nullptr;
    const double* values = nullptr;
    WASH_PETSC(MatGetRow(matrix, first + d, &count, &columns, &values));
    if (d == 0) rows.columns.assign(columns, columns + count);
    rows.values.conservativeResize(Dim, count);
    std::copy_n(values, count, rows.values.row(d).data());
    WASH_PETSC(MatRestoreRow(matrix, first + d, &count, &columns, &values));
  }
  return rows;
}

}  // namespace

template <int Dim>
void scale_by_blocks_and_shift(const std::vector<Block<Dim>>& blocks, double diagonal, Mat matrix) {
  PetscInt first = 0;
  WASH_PETSC(MatGetOwnershipRange(matrix, &first, nullptr));
  const auto row_of = [&](std::size_t marker) { return first + Dim * static_cast<PetscInt>(marker); };
  std::vector<MarkerRows<Dim>> rows;  // all of them, before one is changed
  for (std::size_t m = 0; m < blocks.size(); ++m) rows.push_back(rows_at<Dim>(matrix, row_of(m)));
  for (std::size_t m = 0; m < blocks.size(); ++m) {
    rows[m].values = (blocks[m] * rows[m].values).eval();
    std::array<PetscInt, Dim> numbers{};
    std::iota(numbers.begin(), numbers.end(), row_of(m));
    WASH_PETSC(MatSetValues(matrix, Dim, numbers.data(), static_cast<PetscInt>(rows[m].columns.size()),
                            rows[m].columns.data(), rows[m].values.data(), INSERT_VALUES));
  }
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatShift(matrix, diagonal));
}

template void scale_by_blocks_and_shift<2>(const std::vector<Block<2>>&, double, Mat);
template void scale_by_blocks_and_shift<3>(const std::vector<Block<3>>&, double, Mat);
template void to_vector<2>(const Points<2>&, Vec);
template void to_vector<3>(const Points<3>&, Vec);
template Points<2> to_points<2>(Vec);
template Points<3> to_points<3>(Vec);
template class MatrixProduct<2>;
template class MatrixProduct<3>;
template void scale_and_shift<2>(const std::vector<double>&, const std::vector<double>&, Mat);
template void scale_and_shift<3>(const std::vector<double>&, const std::vector<double>&, Mat);
template void scale_columns_and_shift<2>(const std::vector<double>&, double, Mat);
template void scale_columns_and_shift<3>(const std::vector<double>&, double, Mat);

}  // namespace washfsi
