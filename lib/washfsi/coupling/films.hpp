// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/pair_search.hpp"
#include "washfsi/fluid/liquid.hpp"

namespace washfsi {

/// Films of water between two cloths that are nearer than a cell, which the grid does not resolve. Beside each marker a
/// film of the thickness d closes with the speed v under the pressure p_film, with a length l_film and a coefficient
/// c_film:
///   p_film = 12 mu l_film^2 v/d^3 + c_film rho l_film^2 v^2/d^2
/// This is the mean over a disc, in 2D a strip, between parallel walls: lubrication (Stefan, Sitzungsber. Akad. Wiss.
/// Wien 69 (1874) 713) and, with a parabolic profile at steady speed, inertia, c_film = 9/5, in 2D 12/5. The disc has
/// the area in which the two cloths are that near: l_film^2 = area/(8 pi), in 2D length^2/12. p_film is half the
/// difference of the pressures that the two cloths exert on the water, so that a film gives them no common motion. With
/// the vector n_A made of n/(2 A) of the marker and of those of the opposite facet by shares, and the forces F_f that
/// markers give to the water,
///   p_film = n_A.F_f,   B = sum over films of A/2 (1 - d/cell) v/p_film n_A n_A^T
/// v/p_film is that of the start of the step. B fades out as d comes to a cell, beyond which the grid has the film.
template <int Dim>
class Films {
 public:
  /// The cloths and the liquid must outlive it. Collective.
  Films(const Grid<Dim>& grid, const Cloths<Dim>& cloths, const Liquid<Dim>& liquid);

  /// Finds the films before each step, from these places of this rank's markers, which give these forces to the water
  /// at its start. Collective.
  void begin_step(const Points<Dim>& positions, const Points<Dim>& forces);
  /// Adds B F_f of this rank's markers, which give these forces F_f to the water [m/s]. Collective.
  void add_velocities(const Points<Dim>& forces, Points<Dim>& velocities) const;
  /// Returns factor times B, with a row for each coordinate of each marker. Collective.
  petsc::Matrix matrix(double factor) const;

 private:
  /// The film beside one marker.
  struct Film {
    std::array<std::size_t, pair_markers<Dim>> markers;  ///< own marker, then the facet's (`FacetPair`)
    PairPoints<Dim> weights;                             ///< n_A [1/m2]
    double gap, mean_square;                             ///< d [m], l_film^2 [m2]
    double area;                                         ///< A/2, half the marker's area [m2]
    double ease = 0;                                     ///< (1 - d/cell) v/p_film [m/(s Pa)]
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

/// v/p_film of a film [m/(s Pa)] under a pressure [Pa]; `inertia` is c_film.
double film_ease(const PureLiquid& liquid, double gap, double mean_square, double inertia, double pressure);

extern template class Films<2>;
extern template class Films<3>;

}  // namespace washfsi
