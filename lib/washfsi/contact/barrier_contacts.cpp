// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier_contacts.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

// For the forces at the start, the search for the end of the previous step is still valid. For those at the end it is
// repeated, so that what is found does not depend on earlier steps: a restarted run has the same matrix.
template <int Dim>
Points<Dim> BarrierContacts<Dim>::begin_step(const StepStart<Dim>& start) {
  const bool is_for_start = start.dt == 0;
  if (is_for_start)
    search_at_start(start.positions);
  else
    search_ahead(start);
  Points<Dim> all = values(start.positions);
  if (!is_for_start || !near_.distances().has_started() || start.lagged.dt > 0) near_.follow_distances(all);
  friction_.begin_step(start, near_, all);
  seen_.clear();
  return all;
}

// Searches if the last search is not valid here, or so far away that the nearest images may be others now.
template <int Dim>
void BarrierContacts<Dim>::search_at_start(const Points<Dim>& positions) {
  if (!covers(positions) || farthest_from_places(positions) > near_.distances().usual()) {
    reaches_.assign(positions.size(), near_.least_reach());
    search(positions);
  }
}

// Searches with the reaches that the markers need until the step's end at their present speeds.
template <int Dim>
void BarrierContacts<Dim>::search_ahead(const StepStart<Dim>& start) {
  constexpr double to_spare = 1.3;
  reaches_.clear();
  for (const auto& velocity : start.velocities)
    reaches_.push_back(std::max(near_.least_reach(), to_spare * start.dt * velocity.norm()));
  search(start.positions);
}

template <int Dim>
void BarrierContacts<Dim>::search(const Points<Dim>& positions, Before before) {
  const petsc::LogPart part("contact_search");
  has_searched_ = true;
  places_ = positions;
  near_.find_near(positions, reaches_, before);
  touches_.clear();
  seen_.clear();
}

template <int Dim>
bool BarrierContacts<Dim>::covers(const Points<Dim>& positions) const {
  bool leaves = !has_searched_;
  for (std::size_t m = 0; m < positions.size() && !leaves; ++m)
    leaves = !((positions[m] - places_[m]).squaredNorm() <= reaches_[m] * reaches_[m]);
  return !any_rank(comm_, leaves);
}

template <int Dim>
double BarrierContacts<Dim>::farthest_from_places(const Points<Dim>& positions) const {
  double farthest = 0;
  for (std::size_t m = 0; m < positions.size(); ++m) farthest = std::max(farthest, (positions[m] - places_[m]).norm());
  return largest(comm_, farthest);
}

// Widens the reaches of markers whose motion exceeds them; before the first search, about the motion's start.
template <int Dim>
void BarrierContacts<Dim>::cover(const Points<Dim>& from, const Points<Dim>& motion) {
  const Points<Dim> positions = from + motion;
  if (covers(positions)) return;
  constexpr double to_spare = 1.5;
  if (!has_searched_) {
    places_ = from;
    reaches_.assign(from.size(), near_.least_reach());
  }
  for (std::size_t m = 0; m < positions.size(); ++m)
    reaches_[m] = std::max(reaches_[m], to_spare * (positions[m] - places_[m]).norm());
  const std::vector<std::size_t> before = known().numbers();
  search(Points<Dim>(places_), Before::keep);
  friction_.renumber([&](std::size_t marker) { return known().place_of(before[marker]); });
}

template <int Dim>
void BarrierContacts<Dim>::linearise(const Points<Dim>& positions) {
  at(positions);
  friction_.linearise(values(positions));
}

template <int Dim>
const std::vector<Touch<Dim>>& BarrierContacts<Dim>::at(const Points<Dim>& positions) const {
  if (!any_rank(comm_, seen_ != positions)) return touches_;
  const Points<Dim> all = values(positions);
  touches_ = near_.at(all);
  friction_.look_at(all);
  seen_ = positions;
  return touches_;
}

template class BarrierContacts<2>;
template class BarrierContacts<3>;

}  // namespace washfsi
