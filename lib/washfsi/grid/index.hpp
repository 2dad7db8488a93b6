// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include <petscsys.h>

namespace washfsi {

/// Global index of a cell, x first. Face (index, d) is the LOWER d-face of that cell.
template <int Dim>
using Index = std::array<PetscInt, Dim>;

/// A half-open box of indices.
template <int Dim>
struct Box {
  Index<Dim> lower, upper;

  bool contains(const Index<Dim>& index) const {
    for (int d = 0; d < Dim; ++d)
      if (index[d] < lower[d] || index[d] >= upper[d]) return false;
    return true;
  }
  /// The number of indices.
  std::size_t count() const {
    std::size_t count = 1;
    for (int d = 0; d < Dim; ++d) count *= static_cast<std::size_t>(std::max<PetscInt>(upper[d] - lower[d], 0));
    return count;
  }
  /// The box with one more layer all round.
  Box widened() const {
    Box result = *this;
    for (int d = 0; d < Dim; ++d) {
      --result.lower[d];
      ++result.upper[d];
    }
    return result;
  }
  /// The intersection of both boxes.
  Box common(const Box& other) const {
    Box result;
    for (int d = 0; d < Dim; ++d) {
      result.lower[d] = std::max(lower[d], other.lower[d]);
      result.upper[d] = std::min(upper[d], other.upper[d]);
    }
    return result;
  }
};

template <int Dim>
constexpr Index<Dim> shifted(Index<Dim> index, int axis, PetscInt by) noexcept {
  index[axis] += by;
  return index;
}

/// Calls kernel(index) for each index of the box, x fastest. No communication. To be inlined, so that what a kernel
/// captures stays in registers.
template <int Dim, class Kernel, int Axis = Dim - 1>
inline void for_each(const Box<Dim>& box, Kernel&& kernel, Index<Dim> index = {}) {
  for (index[Axis] = box.lower[Axis]; index[Axis] < box.upper[Axis]; ++index[Axis]) {
    if constexpr (Axis == 0)
      kernel(index);
    else
      for_each<Dim, Kernel&, Axis - 1>(box, kernel, index);
  }
}

/// Calls visit(row) for each row along x of a box, in the order of for_each: a box that is one index wide along the
/// other axes. For several sweeps over interleaved fields, so that a row is read once.
template <int Dim, class Visit>
inline void for_each_row(const Box<Dim>& box, Visit&& visit) {
  Box<Dim> starts = box;
  starts.upper[0] = starts.lower[0] + 1;
  for_each<Dim>(starts, [&](const Index<Dim>& start) {
    Box<Dim> row{start, start};
    for (PetscInt& end : row.upper) ++end;
    row.upper[0] = box.upper[0];
    visit(row);
  });
}

/// Calls visit(c) for c = 0 .. Dim-1 as compile-time constants: a stencil whose component is known when it is compiled
/// needs no index arithmetic at run time.
template <int Dim, class Visit>
void for_each_component(Visit&& visit) {
  [&]<int... c>(std::integer_sequence<int, c...>) {
    (visit(std::integral_constant<int, c>{}), ...);
  }
  (std::make_integer_sequence<int, Dim>{});
}

}  // namespace washfsi
