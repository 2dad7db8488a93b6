// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/advection_scheme.hpp"

#include <functional>

#include "washfsi/fluid/advection.hpp"
#include "washfsi/grid/beside_positive.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

template <int Dim>
void find_central(const Grid<Dim>& grid, const AdvectedFields& fields, Vec term) {
  const ConstFaceView<Dim> u(fields.velocity_dm, fields.local_velocity);
  const FaceView<Dim> result(grid.face_dm(), term);
  const Spacing<Dim> h(grid.spacing());
  grid.for_each_inner_face(
      [&](const Index<Dim>& face, auto c) { result(face, c) = advection<Dim>(u, face, c, h, CentralFlux<Dim>{}); });
}

// Replaces the term on this rank's faces of a box where the flux departs from the central one; returns the power that
// it dissipates beyond the term before. Collective.
template <int Dim, class Flux>
double replace(const Grid<Dim>& grid, const Box<Dim>& where, const AdvectedFields& fields, const Flux& flux, Vec term) {
  const ConstFaceView<Dim> u(fields.velocity_dm, fields.local_velocity), rho(grid.face_dm(), fields.density);
  const ConstFaceView<Dim> fraction(grid.face_dm(), fields.fluid_fraction ? fields.fluid_fraction : fields.density);
  const FaceView<Dim> result(grid.face_dm(), term);
  const Spacing<Dim> h(grid.spacing());
  double dissipated = 0;
  grid.for_each_inner_face(where, [&](const Index<Dim>& face, auto c) {
    if (!flux.departs(face, c)) return;
    const double advected = advection<Dim>(u, face, c, h, flux);
    const double H = fields.fluid_fraction ? fraction(face, c) : 1;
    dissipated += H * rho(face, c) * u(face, c) * (advected - result(face, c));
    result(face, c) = advected;
  });
  return ordered_sum(grid.comm(), dissipated * grid.cell_volume());
}

// Central advection, which may give way to upwind beside edges and thin parts.
template <int Dim>
class CentralAdvection : public AdvectionScheme<Dim> {
 public:
  CentralAdvection(const Grid<Dim>& grid, bool limits_at_edges) : grid_(grid), limits_at_edges_(limits_at_edges) {}

  bool is_bounded() const override { return false; }
  bool departs_from_central() const override { return limits_at_edges_; }
  double find(const AdvectedFields& fields, Vec term) const override {
    find_central(grid_, fields, term);
    return limits_at_edges_ ? limit_at_edges(fields, term) : 0;
  }

 private:
  double limit_at_edges(const AdvectedFields& fields, Vec term) const {
    const petsc::LocalVector local(grid_.face_dm());
    WASH_PETSC(VecZeroEntries(local));  // beyond the box too
    WASH_PETSC(DMGlobalToLocal(grid_.face_dm(), fields.upwind_weight, INSERT_VALUES, local));
    const ConstFaceView<Dim> near(grid_.face_dm(), local);
    const WallsideFlux<Dim, ConstFaceView<Dim>> flux(near);
    return replace(grid_, beside_positive(grid_.owned(), near), fields, flux, term);
  }

  const Grid<Dim>& grid_;
  bool limits_at_edges_;
};

// One flux on all faces.
template <int Dim, class Flux>
class FluxAdvection : public AdvectionScheme<Dim> {
 public:
  FluxAdvection(const Grid<Dim>& grid, bool) : grid_(grid) {}

  bool is_bounded() const override { return Flux::is_bounded; }
  bool departs_from_central() const override { return true; }
  double find(const AdvectedFields& fields, Vec term) const override {
    find_central(grid_, fields, term);
    return replace(grid_, grid_.owned(), fields, Flux{}, term);
  }

 private:
  const Grid<Dim>& grid_;
};

template <int Dim>
struct NamedAdvection {
  std::string name;
  std::function<std::unique_ptr<AdvectionScheme<Dim>>(const Grid<Dim>&, bool)> make;
};

template <int Dim, class Scheme>
NamedAdvection<Dim> named(const char* name) {
  return {name, [](const Grid<Dim>& grid, bool limits) { return std::make_unique<Scheme>(grid, limits); }};
}

// Every scheme that there is.
template <int Dim>
const std::vector<NamedAdvection<Dim>>& all_schemes() {
  static const std::vector<NamedAdvection<Dim>> schemes{
      named<Dim, CentralAdvection<Dim>>("central"),
      named<Dim, FluxAdvection<Dim, CentralFlux<Dim, WideMean>>>("wide_central"),
      named<Dim, FluxAdvection<Dim, UpwindFlux<Dim>>>("upwind"),
  };
  return schemes;
}

}  // namespace

std::vector<std::string> advection_schemes() {
  std::vector<std::string> names;
  for (const auto& scheme : all_schemes<2>()) names.push_back(scheme.name);
  return names;
}

template <int Dim>
std::unique_ptr<AdvectionScheme<Dim>> make_advection_scheme(const std::string& name, const Grid<Dim>& grid,
                                                            bool limits_at_edges) {
  for (const auto& scheme : all_schemes<Dim>())
    if (scheme.name == name) return scheme.make(grid, limits_at_edges);
  throw InputError("-advection " + name + ": there is no such scheme");
}

template std::unique_ptr<AdvectionScheme<2>> make_advection_scheme<2>(const std::string&, const Grid<2>&, bool);
template std::unique_ptr<AdvectionScheme<3>> make_advection_scheme<3>(const std::string&, const Grid<3>&, bool);

}  // namespace washfsi
