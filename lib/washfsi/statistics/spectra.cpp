// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/spectra.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fftw3.h>

#include "washfsi/grid/cell_velocity.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

template <int Dim>
std::vector<SpectrumPlace> spectrum_places(const Grid<Dim>& grid, const Bins<Dim>& bins,
                                           const std::vector<double>& places) {
  std::vector<SpectrumPlace> found;
  if (places.empty()) return found;
  if (bins.axes().size() != 1)
    throw InputError("-statistics_spectra: needs means along all axes but one, on which the places are");
  const int across = bins.axes()[0];
  for (const double place : places) {
    if (place < grid.lower()[across] || place > grid.upper()[across])
      throw InputError("-statistics_spectra " + to_text(place) + ": must be in the box");
    const double h = grid.spacing()[across];
    const auto layer =
        std::min(grid.cells()[across] - 1, static_cast<PetscInt>(std::floor((place - grid.lower()[across]) / h)));
    for (int along = 0; along < Dim; ++along)
      if (along != across)
        found.push_back({layer, across, along, grid.lower()[across] + (static_cast<double>(layer) + 0.5) * h,
                         2 * std::numbers::pi / (grid.upper() - grid.lower())[along],
                         static_cast<std::size_t>(grid.cells()[along]) / 2 + 1});
  }
  return found;
}

namespace {

/// Velocity of a layer's cells, line by line along an axis, component by component.
template <int Dim>
std::vector<double> lines_of(const Grid<Dim>& grid, const SpectrumPlace& place, Vec local_velocity) {
  const ConstFaceView<Dim> u(grid.face_dm(), local_velocity);
  const auto length = static_cast<std::size_t>(grid.cells()[place.along]);
  const int beside = 3 - place.across - place.along;  // in space
  const std::size_t lines = Dim == 3 ? static_cast<std::size_t>(grid.cells()[beside % Dim]) : 1;
  std::vector<double> values(Dim * lines * length, 0.0);
  Box<Dim> layer = grid.owned();
  layer.lower[place.across] = std::max(layer.lower[place.across], place.layer);
  layer.upper[place.across] = std::min(layer.upper[place.across], place.layer + 1);
  for_each<Dim>(layer, [&](const Index<Dim>& cell) {
    const std::size_t line = Dim == 3 ? static_cast<std::size_t>(cell[beside % Dim]) : 0;
    for (int c = 0; c < Dim; ++c)
      values[(static_cast<std::size_t>(c) * lines + line) * length + static_cast<std::size_t>(cell[place.along])] =
          cell_velocity<Dim>(u, cell, c);
  });
  return ordered_sum(grid.comm(), values);
}

struct DestroyPlan {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};

// Every line's transform, in place, in FFTW's order: real parts up, imaginary ones down.
void transform(std::vector<double>& lines, std::size_t length) {
  const int n = static_cast<int>(length), count = static_cast<int>(lines.size() / length);
  const fftw_r2r_kind kind = FFTW_R2HC;
  const std::unique_ptr<fftw_plan_s, DestroyPlan> plan(
      fftw_plan_many_r2r(1, &n, count, lines.data(), nullptr, 1, n, lines.data(), nullptr, 1, n, &kind, FFTW_ESTIMATE));
  fftw_execute(plan.get());
}

}  // namespace

template <int Dim>
std::vector<double> spectra_of(const Grid<Dim>& grid, const SpectrumPlace& place, Vec local_velocity) {
  const auto length = static_cast<std::size_t>(grid.cells()[place.along]);
  std::vector<double> lines = lines_of<Dim>(grid, place, local_velocity);
  const std::size_t count = lines.size() / length / Dim;
  transform(lines, length);
  std::vector<double> spectra(Dim * place.modes, 0.0);
  const auto n = static_cast<double>(length);
  const double scale = 1 / (n * n * place.wave_number_step * static_cast<double>(count));
  for (std::size_t line = 0; line < Dim * count; ++line)
    for (std::size_t k = 0; k < place.modes; ++k) {
      const bool is_single = k == 0 || 2 * k == length;
      const double real = lines[line * length + k], imaginary = is_single ? 0 : lines[line * length + length - k];
      spectra[line / count * place.modes + k] += (is_single ? 1 : 2) * scale * (real * real + imaginary * imaginary);
    }
  return spectra;
}

template std::vector<SpectrumPlace> spectrum_places<2>(const Grid<2>&, const Bins<2>&, const std::vector<double>&);
template std::vector<SpectrumPlace> spectrum_places<3>(const Grid<3>&, const Bins<3>&, const std::vector<double>&);
template std::vector<double> spectra_of<2>(const Grid<2>&, const SpectrumPlace&, Vec);
template std::vector<double> spectra_of<3>(const Grid<3>&, const SpectrumPlace&, Vec);

}  // namespace washfsi
