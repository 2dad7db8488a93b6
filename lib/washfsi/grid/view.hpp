// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>
#include <utility>

#include "washfsi/grid/index.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// Access to a DMDA vector, global or local, as view(index, component). `const double` only reads.
template <int Dim, int Components, class Scalar>
class View {
 public:
  View(DM dm, Vec vector) : vector_(vector) {
    DMDALocalInfo info;
    WASH_PETSC(DMDAGetLocalInfo(dm, &info));
    PetscInt size = 0;
    WASH_PETSC(VecGetLocalSize(vector, &size));
    const bool global = size == info.dof * info.xm * info.ym * info.zm;
    const Index<3> start = global ? Index<3>{info.xs, info.ys, info.zs} : Index<3>{info.gxs, info.gys, info.gzs};
    const Index<3> count = global ? Index<3>{info.xm, info.ym, info.zm} : Index<3>{info.gxm, info.gym, info.gzm};
    PetscInt stride = Components;
    for (int d = 0; d < Dim; ++d) {
      stride_[d] = std::exchange(stride, stride * count[d]);
      origin_ += start[d] * stride_[d];
    }
    if constexpr (std::is_const_v<Scalar>)
      WASH_PETSC(VecGetArrayRead(vector_, &base_));
    else
      WASH_PETSC(VecGetArray(vector_, &base_));
  }
  ~View() {
    if constexpr (std::is_const_v<Scalar>)
      (void)VecRestoreArrayRead(vector_, &base_);
    else
      (void)VecRestoreArray(vector_, &base_);
  }
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  Scalar& operator()(const Index<Dim>& index, int component = 0) const noexcept {
    PetscInt offset = index[0] * Components + component - origin_;  // constant x stride: vectorisable
    for (std::size_t d = 1; d < Dim; ++d) offset += index[d] * stride_[d];
    return base_[offset];
  }

  /// Distance in memory from one point to the next along an axis, in numbers.
  PetscInt stride(std::size_t axis) const noexcept { return stride_[axis]; }

 private:
  Vec vector_;
  Scalar* base_ = nullptr;
  Index<Dim> stride_{};
  PetscInt origin_ = 0;
};

template <int Dim>
using CellView = View<Dim, 1, double>;
template <int Dim>
using ConstCellView = View<Dim, 1, const double>;
template <int Dim>
using FaceView = View<Dim, Dim, double>;
template <int Dim>
using ConstFaceView = View<Dim, Dim, const double>;

}  // namespace washfsi
