// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/body_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr int bins_of_a_cell = 10;
constexpr int bins = static_cast<int>(BodySurvey<2>::most_cells) * bins_of_a_cell;
constexpr double bend = 0.5;  // allowed bend of thin parts [cells]

/// The surface of a body where it passes cells: how far it lies from its centre; how thick the body is below it, the
/// way along the normal to the other side; and how wide its thin parts are, the way along them from edge to edge. Both
/// as counts of tenths of a cell.
template <int Dim>
class Surface {
 public:
  Surface(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t body)
      : spacing_(grid.spacing()), posed_(posed), body_(body), thicknesses_(bins + 1, 0.0), widths_(thicknesses_) {}

  void look(const Point<Dim>& place) {
    if (const Point<Dim> normal = normal_at(place); normal.squaredNorm() > 0) return look_from(place, normal);
    const Point<Dim> aside = place + 0.1 * spacing_;  // from the middle of a thin part
    if (const Point<Dim> normal = normal_at(aside); normal.squaredNorm() > 0) look_from(aside, normal);
  }

  // The reach over this rank's cells, from the vertical through the centre [m].
  double reach() const { return reach_; }

  // The thickness, or width, below which a tenth of the surface, or of the thin parts, lies [cells].
  double thinnest(MPI_Comm comm) const { return least_tenth(comm, thicknesses_, 0); }
  double narrowest(MPI_Comm comm) const { return least_tenth(comm, widths_, BodySurvey<Dim>::most_cells); }

 private:
  void look_from(const Point<Dim>& place, const Point<Dim>& normal) {
    const double distance = posed_.distance(body_, place);
    const double per_length = normal.cwiseQuotient(spacing_).norm();  // cells along the normal
    if (std::abs(distance) * per_length > 0.5) return;
    const Point<Dim> foot = place - distance * normal;
    reach_ = std::max(reach_, posed_[body_].arm(foot).template head<2>().norm());
    const auto below = [&](int bin) { return Point<Dim>(foot - (bin / (bins_of_a_cell * per_length)) * normal); };
    constexpr double least_cosine = 0.9;  // else an edge, below which there is no other side
    if (!(std::abs(normal_at(below(1)).dot(normal)) > least_cosine)) return;
    int bin = 1;
    if (posed_.distance(body_, below(bin)) >= 0) return;  // an edge that the distance rounds off
    while (bin < bins && posed_.distance(body_, below(bin)) < 0) ++bin;
    ++thicknesses_[static_cast<std::size_t>(bin)];
    if (bin > bins_of_a_cell * BodySurvey<Dim>::thin_cells) return;
    const double width = width_at(foot - (0.5 * bin / (bins_of_a_cell * per_length)) * normal, normal);
    ++widths_[static_cast<std::size_t>(std::lround(width * bins_of_a_cell))];
  }

  static double least_tenth(MPI_Comm comm, const std::vector<double>& of_rank, double of_none) {
    const std::vector<double> counts = ordered_sum(comm, of_rank);
    double all = 0, below = 0;
    for (const double count : counts) all += count;
    if (all == 0) return of_none;
    std::size_t bin = 0;
    while (bin < bins && (below += counts[bin]) < 0.1 * all) ++bin;
    return static_cast<double>(bin) / bins_of_a_cell;
  }

  // The width from edge to edge through a place in the middle of a thin part, towards the nearest edge [cells]. The
  // part may bend by half a cell on the way.
  double width_at(const Point<Dim>& middle, const Point<Dim>& normal) const {
    constexpr double most = BodySurvey<Dim>::most_cells;
    double to_edge = most, width = 2 * most;
    for (const Point<Dim>& way : ways_along(normal)) {
      const double there = steps_inside(middle, way), back = steps_inside(middle, -way);
      if (std::min(there, back) >= to_edge) continue;
      to_edge = std::min(there, back);
      width = there + back;
    }
    return std::clamp(width - 2 * bend, 0.0, most);
  }

  // Unit vectors across the normal: one in the plane, eight in space.
  static std::vector<Point<Dim>> ways_along(const Point<Dim>& normal) {
    if constexpr (Dim == 2) {
      return {Point<2>(-normal[1], normal[0])};
    } else {
      constexpr int count = 8;
      const Point<3> one = normal.unitOrthogonal(), other = normal.cross(one);
      std::vector<Point<3>> ways;
      for (int n = 0; n < count; ++n) {
        const double angle = n * std::numbers::pi / count;
        ways.emplace_back(std::cos(angle) * one + std::sin(angle) * other);
      }
      return ways;
    }
  }

  // Distance from a place to the body's end, in steps of a tenth [cells].
  double steps_inside(const Point<Dim>& from, const Point<Dim>& way) const {
    const double step = 1 / (bins_of_a_cell * way.cwiseQuotient(spacing_).norm());  // [m]
    const double margin = bend * bins_of_a_cell * step;
    int steps = 0;
    while (steps < bins && posed_.distance(body_, from + steps * step * way) < margin) ++steps;
    return static_cast<double>(steps) / bins_of_a_cell;
  }

  Point<Dim> normal_at(const Point<Dim>& place) const {
    return posed_.normal(body_, place, 0.01 * spacing_.minCoeff());
  }

  Point<Dim> spacing_;
  const PosedBodies<Dim>& posed_;
  std::size_t body_;
  std::vector<double> thicknesses_, widths_;
  double reach_ = 0;
};

// The survey over this rank's cells; thickness over all ranks'.
template <int Dim>
BodySurvey<Dim> survey(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, std::size_t b) {
  constexpr double far = std::numeric_limits<double>::max();
  BodySurvey<Dim> found;
  found.lower.setConstant(far);
  found.upper.setConstant(-far);
  found.nearest = far;
  found.shared.assign(posed.size(), 0.0);
  Surface<Dim> surface(grid, posed, b);
  const double beside = grid.spacing().norm();
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    const Point<Dim> place = grid.cell_center(cell);
    const double distance = posed.distance(b, place);
    found.nearest = std::min(found.nearest, distance);
    if (std::abs(distance) < beside) surface.look(place);
    if (distance > 0) return;
    ++found.cells;
    const Point<Dim> own = posed[b].beside(place);
    found.lower = found.lower.cwiseMin(own - 0.5 * grid.spacing());
    found.upper = found.upper.cwiseMax(own + 0.5 * grid.spacing());
    for (std::size_t c = 0; c < posed.size(); ++c) found.shared[c] += posed.distance(c, place) <= 0 ? 1 : 0;
  });
  found.reach = surface.reach();
  found.thickness = surface.thinnest(grid.comm());
  found.sheet_width = surface.narrowest(grid.comm());
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
    BodySurvey<Dim>& found = surveys.emplace_back(survey(grid, posed, b));
    reduce(grid.comm(), found);
    found.volume = found.cells * grid.cell_volume();
    found.top_speed = found.cells == 0 || bodies[b].motion.at_rest() ? 0 : bodies[b].motion.largest_speed(found.reach);
  }
  return surveys;
}

template std::vector<BodySurvey<2>> survey_bodies<2>(const Grid<2>&, const std::vector<Body<2>>&, double);
template std::vector<BodySurvey<3>> survey_bodies<3>(const Grid<3>&, const std::vector<Body<3>>&, double);

}  // namespace washfsi
