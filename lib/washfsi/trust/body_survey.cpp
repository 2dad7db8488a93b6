// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/body_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr int bins_of_a_cell = 10;
constexpr int bins = static_cast<int>(BodySurvey<2>::most_cells) * bins_of_a_cell;

/// The surface of a body where it passes cells: how far it lies from its centre, and how thick the body is below it,
/// the way along the normal to the other side, as counts of tenths of a cell.
template <int Dim>
class Surface {
 public:
  Surface(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t body, const Point<Dim>& center)
      : spacing_(grid.spacing()), posed_(posed), body_(body), center_(center), counts_(bins + 1, 0.0) {}

  void look(const Point<Dim>& place) {
    const double distance = posed_.distance(body_, place);
    const Point<Dim> normal = normal_at(place);
    if (!normal.allFinite()) return;
    const double per_length = normal.cwiseQuotient(spacing_).norm();  // cells along the normal
    if (std::abs(distance) * per_length > 0.5) return;
    const Point<Dim> foot = place - distance * normal;
    reach_ = std::max(reach_, (foot - center_).template head<2>().norm());
    const auto below = [&](int bin) { return Point<Dim>(foot - (bin / (bins_of_a_cell * per_length)) * normal); };
    constexpr double least_cosine = 0.9;  // else an edge, below which there is no other side
    if (!(std::abs(normal_at(below(1)).dot(normal)) > least_cosine)) return;
    int bin = 1;
    if (posed_.distance(body_, below(bin)) >= 0) return;  // an edge that the distance rounds off
    while (bin < bins && posed_.distance(body_, below(bin)) < 0) ++bin;
    ++counts_[static_cast<std::size_t>(bin)];
  }

  // Of this rank's cells, from the vertical through the centre [m].
  double reach() const { return reach_; }

  // That which a tenth of the surface is thinner than [cells].
  double thinnest(MPI_Comm comm) const {
    const std::vector<double> counts = ordered_sum(comm, counts_);
    double all = 0, below = 0;
    for (const double count : counts) all += count;
    std::size_t bin = 0;
    while (bin < bins && (below += counts[bin]) < 0.1 * all) ++bin;
    return static_cast<double>(bin) / bins_of_a_cell;
  }

 private:
  Point<Dim> normal_at(const Point<Dim>& place) const {
    return posed_.normal(body_, place, 0.01 * spacing_.minCoeff());
  }

  Point<Dim> spacing_;
  const PosedBodies<Dim>& posed_;
  std::size_t body_;
  Point<Dim> center_;
  std::vector<double> counts_;
  double reach_ = 0;
};

// Of this rank's cells; the thickness of all ranks'.
template <int Dim>
BodySurvey<Dim> survey(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t b, const Point<Dim>& center) {
  constexpr double far = std::numeric_limits<double>::max();
  BodySurvey<Dim> found;
  found.lower.setConstant(far);
  found.upper.setConstant(-far);
  found.nearest = far;
  found.shared.assign(posed.size(), 0.0);
  Surface<Dim> surface(grid, posed, b, center);
  const double beside = grid.spacing().norm();
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = grid.cell_center(cell);
    const double distance = posed.distance(b, place);
    found.nearest = std::min(found.nearest, distance);
    if (std::abs(distance) < beside) surface.look(place);
    if (distance > 0) return;
    ++found.cells;
    found.lower = found.lower.cwiseMin(place - 0.5 * grid.spacing());
    found.upper = found.upper.cwiseMax(place + 0.5 * grid.spacing());
    for (std::size_t c = 0; c < posed.size(); ++c) found.shared[c] += posed.distance(c, place) <= 0 ? 1 : 0;
  });
  found.reach = surface.reach();
  found.thickness = surface.thinnest(grid.comm());
  return found;
}

template <int Dim>
void reduce(MPI_Comm comm, BodySurvey<Dim>& found) {
  found.cells = ordered_sum(comm, found.cells);
  found.shared = ordered_sum(comm, found.shared);
  found.reach = largest(comm, found.reach);
  found.nearest = -largest(comm, -found.nearest);
  for (int d = 0; d < Dim; ++d) {
    found.lower[d] = -largest(comm, -found.lower[d]);
    found.upper[d] = largest(comm, found.upper[d]);
  }
}

}  // namespace

template <int Dim>
std::vector<BodySurvey<Dim>> survey_bodies(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, double time) {
  const PosedBodies<Dim> posed(bodies, time);
  std::vector<BodySurvey<Dim>> surveys;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    BodySurvey<Dim>& found = surveys.emplace_back(survey(grid, posed, b, bodies[b].motion.center_at(time)));
    reduce(grid.comm(), found);
    found.volume = found.cells * grid.cell_volume();
    found.top_speed = found.cells == 0 || bodies[b].motion.at_rest() ? 0 : bodies[b].motion.largest_speed(found.reach);
  }
  return surveys;
}

template std::vector<BodySurvey<2>> survey_bodies<2>(const Grid<2>&, const std::vector<Body<2>>&, double);
template std::vector<BodySurvey<3>> survey_bodies<3>(const Grid<3>&, const std::vector<Body<3>>&, double);

}  // namespace washfsi
