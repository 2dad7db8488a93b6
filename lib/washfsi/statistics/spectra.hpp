// SPDX-License-Identifier: BSD-3-Clause
//
// Spectra of the velocity in a layer of cells across the only axis that is not homogeneous, along each axis that is:
//   E_c(k) = 2 |u_c^(k)|^2 / dk,   dk = 2 pi / L,   u^ the mean of u exp(-i k x) along a line
// (half of it at k = 0 and at the last k of an even number of cells), in the mean over the layer's lines. The sum of
// E dk is the mean of u_c^2 in the layer; that without k = 0 is the part that varies along the axis.
#pragma once

#include "washfsi/statistics/sums.hpp"

namespace washfsi {

/// The spectra of one layer along one axis.
struct SpectrumPlace {
  PetscInt layer;  ///< index of the layer of cells
  int across, along;
  double height;            ///< place of the layer's middle [m]
  double wave_number_step;  ///< dk [1/m]
  std::size_t modes;        ///< number of modes, k = 0 included
};

/// The places of spectra: the layers nearest to places on the inhomogeneous axis. Errors: InputError if there are
/// places but not exactly one such axis, or places beyond the box.
template <int Dim>
std::vector<SpectrumPlace> spectrum_places(const Grid<Dim>& grid, const Bins<Dim>& bins,
                                           const std::vector<double>& places);

/// E of each component in turn, `modes` values each [m3/s2]. The same on all ranks. Collective.
template <int Dim>
std::vector<double> spectra_of(const Grid<Dim>& grid, const SpectrumPlace& place, Vec local_velocity);

}  // namespace washfsi
