// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/pair_search.hpp"
#include "washfsi/fluid/liquid.hpp"

namespace washfsi {

/// Films of water between two cloths that are nearer than a cell, which the grid does not resolve. Beside each marker a
/// film of the thickness d closes with the speed v under the pressure q,
///   q = 12 mu l^2 v/d^3 + c rho l^2 v^2/d^2
/// the mean over a disc, in the plane a strip, between parallel walls: lubrication (Stefan, Sitzungsber. Akad. Wiss.
/// Wien 69 (1874) 713) and, with a parabolic profile at steady speed, inertia, c = 9/5, in the plane 12/5. The disc has
/// the area in which the two cloths are that near, l^2 = area/(8 pi), in the plane length^2/12. q is half the
/// difference of what the cloths press the water with, per area, so that a film neither moves nor turns them together:
///   q = g.f,   g = n/(2 A) of the marker and of those of the facet by their shares,   B = sum W v/q g g^T
/// v/q is that of the q of the step's start, and fades out as d comes to a cell, beyond which the grid has the film.
template <int Dim>
class Films {
 public:
  /// The cloths and the liquid must outlive it. Collective.
  Films(const Grid<Dim>& grid, const Cloths<Dim>& cloths, const Liquid<Dim>& liquid);

  /// Finds the films before each step, from these places of this rank's markers, which give these forces to the water
  /// at its start. Collective.
  void begin_step(const Points<Dim>& positions, const Points<Dim>& forces);
  /// Adds B f of this rank's markers, which give these forces to the water [m/s]. Collective.
  void add_velocities(const Points<Dim>& forces, Points<Dim>& velocities) const;
  /// The power f.B f, summed over all ranks [W; per unit depth in the plane]. Collective.
  double power(const Points<Dim>& forces) const;
  /// Returns factor times B, with a row for each coordinate of each marker. Collective.
  petsc::Matrix matrix(double factor) const;

 private:
  /// The film beside one marker.
  struct Film {
    std::array<std::size_t, pair_markers<Dim>> markers;  ///< own marker, then the facet's (`FacetPair`)
    PairPoints<Dim> weights;                             ///< g [1/m2]
    double gap, mean_square;                             ///< d [m], l^2 [m2]
    double area;                                         ///< W: half the marker's area [m2]
    double ease = 0;                                     ///< v/q [m/(s Pa)]
  };
  using Pairs = std::vector<FacetPair<Dim>>;
  Pairs nearest_pairs(const Points<Dim>& positions);
  void find_mean_squares();
  Film film(const FacetPair<Dim>& pair, const Points<Dim>& all) const;
  double pressure(const Film& film, const Points<Dim>& all_forces) const;
  double ease(const Film& film, double pressure) const;

  const Cloths<Dim>& cloths_;
  const Liquid<Dim>& liquid_;
  double cell_;  ///< the least spacing of the grid [m]
  PairSearch<Dim> search_;
  std::vector<Film> films_;  ///< films beside this rank's markers
};

/// v/q of a film [m/(s Pa)] under a pressure [Pa].
double film_ease(const PureLiquid& liquid, double gap, double mean_square, double inertia, double pressure);

extern template class Films<2>;
extern template class Films<3>;

}  // namespace washfsi
