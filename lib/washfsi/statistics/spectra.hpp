// SPDX-License-Identifier: BSD-3-Clause
//
// Spectra of the velocity in a layer of cells across the only axis that is not homogeneous, along each axis that is:
//   E_c(k) = 2 |u^_c(k)|^2 / dk,   dk = 2 pi / L,   sum over k of E_c dk = <u_c^2>
// (half as much at k = 0 and at the last k of an even number of cells), in the mean over the lines of the layer. E_c is
// the script E of the theory, u^_c the mean of u_c exp(-i k x) along a line of length L. The sum without k = 0 is the
// part of <u_c^2> that varies along the axis.
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

/// E_c of each component c in turn, `modes` values each [m3/s2]. The same on all ranks. Collective.
template <int Dim>
std::vector<double> spectra_of(const Grid<Dim>& grid, const SpectrumPlace& place, Vec local_velocity);

}  // namespace washfsi
