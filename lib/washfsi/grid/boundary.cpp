// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {
constexpr std::array<End, 2> both_ends{End::lower, End::upper};

// The DM of a local vector, with few ghosts or many.
DM dm_of(Vec local) {
  DM dm = nullptr;
  WASH_PETSC(VecGetDM(local, &dm));
  return dm;
}

template <int Dim>
Box<Dim> ghosted_box(Vec local) {
  DMDALocalInfo info;
  WASH_PETSC(DMDAGetLocalInfo(dm_of(local), &info));
  const Index<3> start{info.gxs, info.gys, info.gzs}, count{info.gxm, info.gym, info.gzm};
  Box<Dim> box;
  for (int d = 0; d < Dim; ++d) {
    box.lower[d] = start[d];
    box.upper[d] = start[d] + count[d];
  }
  return box;
}
}  // namespace

template <int Dim>
Boundary<Dim>::Boundary(const Grid<Dim>& grid, Sides sides) : grid_(grid), sides_(std::move(sides)) {
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends)
      if (side(axis, end).kind == BoundaryKind::outflow) outflows_.emplace_back(grid, axis, end);
  check_net_flux();
}

template <int Dim>
void Boundary<Dim>::check_net_flux() const {
  const auto moves = [](const auto& ends) { return ends[0].motion || ends[1].motion; };
  if (has_outflow() || std::any_of(sides_.begin(), sides_.end(), moves)) return;
  const auto [net, gross] = prescribed_flux(0);
  if (std::abs(net) > 1e-12 * gross)
    throw InputError("-bc_..._velocity: the velocities given on the boundary have a net flux of " + to_text(net) +
                     " m^" + std::to_string(Dim) + "/s out of the box; it must be zero, or one side an outflow");
}

// The flux out of the box through sides of given velocity: the sum, and the sum of absolute values [m^Dim/s].
template <int Dim>
typename Boundary<Dim>::Flux Boundary<Dim>::prescribed_flux(double time) const {
  std::vector<double> sums(2, 0.0);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      if (!touches(axis, end) || side(axis, end).kind == BoundaryKind::outflow) continue;
      const double area = grid_.cell_volume() / grid_.spacing()[axis];
      visit_boundary_faces(axis, end, grid_.owned(), [&](const Index<Dim>& face) {
        const double flux = area * value(axis, end, face, axis, time);
        sums[0] += end == End::lower ? -flux : flux;
        sums[1] += std::abs(flux);
      });
    }
  sums = ordered_sum(grid_.comm(), sums);
  return {sums[0], sums[1]};
}

template <int Dim>
const OutflowLayer<Dim>& Boundary<Dim>::outflow(int axis, End end) const {
  return *std::find_if(outflows_.begin(), outflows_.end(),
                       [&](const auto& layer) { return layer.axis() == axis && layer.end() == end; });
}

template <int Dim>
void Boundary<Dim>::start_outflow(Vec local_velocity, double time) {
  if (!has_outflow()) return;
  const ConstFaceView<Dim> u(dm_of(local_velocity), local_velocity);
  for (auto& layer : outflows_) layer.start(u);
  balance_outflow(time);
  next_outflow_time_ = time;
  accept_outflow();
}

template <int Dim>
void Boundary<Dim>::advance_outflow(Vec local_velocity, double time, double dt) {
  if (!has_outflow()) return;
  const ConstFaceView<Dim> u(dm_of(local_velocity), local_velocity);
  std::vector<double> inner;
  for (const auto& layer : outflows_) inner.push_back(layer.inner_flux(u));
  inner = ordered_sum(grid_.comm(), inner);
  for (std::size_t i = 0; i < outflows_.size(); ++i) outflows_[i].advance(u, inner[i] / outflows_[i].area(), dt);
  balance_outflow(time + dt);
  next_outflow_time_ = time + dt;
}

// Shifts the advanced values of all open sides alike so that the box gains and loses the same volume.
template <int Dim>
void Boundary<Dim>::balance_outflow(double time) {
  double out = 0, area = 0;
  for (const auto& layer : outflows_) {
    out += layer.flux();
    area += layer.area();
  }
  out = ordered_sum(grid_.comm(), out) + prescribed_flux(time).net;
  for (auto& layer : outflows_) layer.add_outward(-out / area);
}

template <int Dim>
void Boundary<Dim>::accept_outflow() {
  for (auto& layer : outflows_) layer.accept();
  outflow_time_ = next_outflow_time_;
}

template <int Dim>
void Boundary<Dim>::cover_sides(double time, const typename SideCover<Dim>::Cover& cover) {
  if (covers_.empty())
    for (int axis = 0; axis < Dim; ++axis)
      for (const End end : both_ends)
        if (touches(axis, end) && side(axis, end).kind == BoundaryKind::wall && !side(axis, end).motion)
          covers_.emplace_back(grid_, axis, end, side(axis, end).velocity);
  for (auto& side : covers_) side.set(time, cover);
}

// The cover of a side by bodies; null where none stands.
template <int Dim>
const SideCover<Dim>* Boundary<Dim>::cover(int axis, End end) const {
  for (const auto& cover : covers_)
    if (cover.axis() == axis && cover.end() == end && cover.covers()) return &cover;
  return nullptr;
}

template <int Dim>
const Side<Dim>& Boundary<Dim>::side(int axis, End end) const {
  return sides_[axis][end == End::upper ? 1 : 0];
}

template <int Dim>
double Boundary<Dim>::mirror_sign(int axis, End end, int component) const {
  if (grid_.periodic(axis)) return 0;
  const BoundaryKind kind = side(axis, end).kind;
  if (kind == BoundaryKind::outflow) return 0;
  return kind == BoundaryKind::slip && component != axis ? 1 : -1;
}

template <int Dim>
double Boundary<Dim>::largest_speed(double time) const {
  double speed = 0;
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      const BoundaryKind kind = side(axis, end).kind;
      if (!touches(axis, end) || kind == BoundaryKind::outflow) continue;
      for (int c = 0; c < Dim; ++c) {
        if (c != axis && kind == BoundaryKind::slip) continue;
        with_values(axis, end, c, time, [&](const auto& values) {
          visit_boundary_faces(axis, end, grid_.owned(),
                               [&](const Index<Dim>& face) { speed = std::max(speed, std::abs(values(face))); });
        });
      }
    }
  return largest(grid_.comm(), speed);
}

// The velocity of the side at the place next to a face: in it, or half a cell from it.
template <int Dim>
double Boundary<Dim>::value(int axis, End end, const Index<Dim>& face, int component, double time) const {
  const Side<Dim>& here = side(axis, end);
  if (here.kind == BoundaryKind::outflow) return outflow(axis, end)(face, component, time > outflow_time_);
  if (here.motion) return here.motion(foot(face, component, axis, end), time)[component];
  if (const auto* covered = cover(axis, end); covered && covered->moves() && component != axis)
    return covered->velocities(component, time)(face);
  if (here.profile == InflowProfile::uniform) return here.velocity[component];
  return here.velocity[component] *
         parabola<Dim>(sides_, axis, grid_.lower(), grid_.upper(), foot(face, component, axis, end));
}

// Calls use(values), values(face) being `value`; evaluates it once where it is the same on the whole side.
template <int Dim>
template <class Use>
void Boundary<Dim>::with_values(int axis, End end, int component, double time, Use&& use) const {
  const Side<Dim>& here = side(axis, end);
  const bool varies = here.kind == BoundaryKind::outflow || here.motion || here.profile != InflowProfile::uniform;
  if (varies)
    use([&](const Index<Dim>& face) { return value(axis, end, face, component, time); });
  else if (const auto* covered = cover(axis, end); covered && covered->moves() && component != axis)
    use(covered->velocities(component, time));
  else
    use([same = here.velocity[component]](const Index<Dim>&) { return same; });
}

// The point of the wall opposite to a face.
template <int Dim>
Point<Dim> Boundary<Dim>::foot(const Index<Dim>& face, int component, int axis, End end) const {
  Point<Dim> place = grid_.face_center(face, component);
  place[axis] = end == End::lower ? grid_.lower()[axis] : grid_.upper()[axis];
  return place;
}

// Calls visit(face) for the faces that lie in the boundary, over the extent of `part` along the other axes.
template <int Dim>
template <class Visit>
void Boundary<Dim>::visit_boundary_faces(int axis, End end, const Box<Dim>& part, Visit&& visit) const {
  Box<Dim> plane = part;
  plane.lower[axis] = end == End::lower ? 0 : grid_.cells()[axis];
  plane.upper[axis] = plane.lower[axis] + 1;
  for_each<Dim>(plane, visit);
}

// Calls visit(ghost, mirror) for the ghosts of `part` beyond one side and the face that each mirrors. The axis is known
// when this is compiled, so that indices stay in registers.
template <int Dim>
template <int Axis, class Visit>
void Boundary<Dim>::visit_ghosts(End end, int component, const Box<Dim>& part, Visit&& visit) const {
  const bool normal = component == Axis;  // faces lie in the boundary, not half a cell from it
  const PetscInt n = grid_.cells()[Axis];
  Box<Dim> beyond = part;
  if (end == End::lower)
    beyond.upper[Axis] = 0;
  else
    beyond.lower[Axis] = normal ? n + 1 : n;
  const PetscInt pivot = (end == End::lower ? 0 : 2 * n) - (normal ? 0 : 1);
  for_each<Dim>(beyond, [&](const Index<Dim>& ghost) {
    Index<Dim> mirror = ghost;
    mirror[Axis] = pivot - ghost[Axis];
    visit(ghost, mirror);
  });
}

// Fills from values(axis, end, component, use), which calls use as `with_values` does.
template <int Dim>
template <class Values>
void Boundary<Dim>::fill_from(Vec local, Values&& values) const {
  const FaceView<Dim> u(dm_of(local), local);
  const Box<Dim> part = ghosted_box<Dim>(local);
  for_each_component<Dim>([&](auto axis) {  // later axes complete the corners of earlier ones
    for (const End end : both_ends) {
      if (!touches(axis, end)) continue;
      values(axis, end, axis, [&](const auto& value) {
        visit_boundary_faces(axis, end, part, [&](const Index<Dim>& face) { u(face, axis) = value(face); });
      });
      for_each_component<Dim>([&](auto c) {
        const double sign = mirror_sign(axis, end, c);  // u(ghost) = (1 - sign) u_wall + sign u(mirror)
        values(axis, end, c, [&](const auto& value) {
          visit_ghosts<axis>(end, c, part, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
            u(ghost, c) = (1 - sign) * value(ghost) + sign * u(mirror, c);
          });
        });
      });
    }
  });
}

template <int Dim>
void Boundary<Dim>::fill(Vec local_velocity, double time) const {
  fill_from(local_velocity, [&](int axis, End end, int c, const auto& use) { with_values(axis, end, c, time, use); });
}

template <int Dim>
void Boundary<Dim>::fill_from_sides(Vec local, double time, const SideSet& sides,
                                    const std::optional<SideName>& open) const {
  WASH_PETSC(VecZeroEntries(local));
  fill_from(local, [&](int axis, End end, int c, const auto& use) {
    if (!sides[axis][end == End::upper ? 1 : 0]) return;
    const auto* covered = cover(axis, end);
    const bool is_open = open && axis == open->axis && end == open->end;
    if (covered && (is_open || !open))
      use([is_open, shares = covered->shares(c, time)](const Index<Dim>& face) {
        return is_open ? 1 - shares(face) : shares(face);
      });
    else
      use([same = is_open ? 1.0 : 0.0](const Index<Dim>&) { return same; });
  });
}

template <int Dim>
void Boundary<Dim>::fill_homogeneous(Vec local_velocity) const {
  fill_from(local_velocity, [](int, End, int, const auto& use) { use([](const Index<Dim>&) { return 0.0; }); });
}

template <int Dim>
void Boundary<Dim>::fill_cells(Vec local_cells) const {
  const CellView<Dim> values(dm_of(local_cells), local_cells);
  const Box<Dim> part = ghosted_box<Dim>(local_cells);
  for_each_component<Dim>([&](auto axis) {
    constexpr int beside = (axis + 1) % Dim;  // cells lie half a spacing from the side, as the faces of the others do
    const auto copy = [&](const Index<Dim>& ghost, const Index<Dim>& mirror) { values(ghost) = values(mirror); };
    for (const End end : both_ends)
      if (touches(axis, end)) visit_ghosts<axis>(end, beside, part, copy);
  });
}

template <int Dim>
Point<Dim> Boundary<Dim>::fold_with(Vec local, bool keep_sign) const {
  const FaceView<Dim> f(dm_of(local), local);
  const Box<Dim> part = ghosted_box<Dim>(local);
  Point<Dim> kept = Point<Dim>::Zero();
  for_each_component<Dim>([&](auto number) {
    constexpr int axis = Dim - 1 - number;  // the reverse of `fill`
    for (const End end : both_ends) {
      if (!touches(axis, end)) continue;
      for_each_component<Dim>([&](auto c) {
        const double sign = keep_sign ? 1 : mirror_sign(axis, end, c);
        visit_ghosts<axis>(end, c, part, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
          if (f(ghost, c) == 0) return;  // most are 0
          f(mirror, c) += sign * f(ghost, c);
          kept[c] += (1 - sign) * f(ghost, c);
          f(ghost, c) = 0;
        });
      });
      if (keep_sign) continue;
      visit_boundary_faces(axis, end, part,
                           [&](const Index<Dim>& face) { kept[axis] += std::exchange(f(face, axis), 0.0); });
    }
  });
  return kept;
}

template <int Dim>
Point<Dim> Boundary<Dim>::fold(Vec local_force) const {
  return fold_with(local_force, false);
}

template <int Dim>
void Boundary<Dim>::fold_mass(Vec local_density) const {
  (void)fold_with(local_density, true);
}

template <int Dim>
void Boundary<Dim>::set_boundary_faces(Vec velocity, double time) const {
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  for (int axis = 0; axis < Dim; ++axis) {
    if (!touches(axis, End::lower)) continue;
    visit_boundary_faces(axis, End::lower, grid_.owned(),
                         [&](const Index<Dim>& face) { u(face, axis) = value(axis, End::lower, face, axis, time); });
  }
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace washfsi
