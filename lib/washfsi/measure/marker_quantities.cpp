// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/marker_quantities.hpp"

namespace washfsi {

namespace {

using Sample = const MarkerSample&;

template <StressComponent Component>
double surface(Sample m) {
  return m.state.membrane_stress[Component] + m.state.bending_stress[Component];
}
template <StressComponent Component>
double membrane(Sample m) {
  return m.state.membrane_stress[Component];
}
template <StressComponent Component>
double bending(Sample m) {
  return m.state.bending_stress[Component];
}

const MarkerQuantity stretch{"stretch", "-", "\\|\\|X_s\\| - 1\\| of the edges beside",
                             [](Sample m) { return m.state.stretch; }};
const MarkerQuantity curvature{"curvature", "1/m", "of the cloth", [](Sample m) { return m.state.curvature; }};
const MarkerQuantity relative_speed{"relative_speed", "m/s", "of the water along the cloth, 1.5 cells away",
                                    [](Sample m) { return m.action.relative_speed; }, true};
const MarkerQuantity water_shear{"water_shear", "Pa", "viscosity times the relative speed over the distance",
                                 [](Sample m) { return m.action.shear; }, true};

}  // namespace

template <>
const std::vector<MarkerQuantity>& marker_quantities<2>() {
  static const std::vector<MarkerQuantity> all{
      {"stress", "Pa", "at the surface (5.2-2): membrane and bending stress", surface<ss>, true},
      {"membrane_stress", "Pa", "tension over thickness", membrane<ss>},
      {"bending_stress", "Pa", "at the surface, of bending", bending<ss>},
      stretch,
      curvature,
      relative_speed,
      water_shear,
  };
  return all;
}

template <>
const std::vector<MarkerQuantity>& marker_quantities<3>() {
  static const std::vector<MarkerQuantity> all{
      {"stress", "Pa", "at the surface (5.2-2 to 5.2-4), the mean along warp and weft",
       [](Sample m) { return 0.5 * (surface<ss>(m) + surface<rr>(m)); }, true},
      {"stress_ss", "Pa", "at the surface, along warp", surface<ss>},
      {"stress_rr", "Pa", "at the surface, along weft", surface<rr>},
      {"stress_sr", "Pa", "at the surface, of shear", surface<sr>},
      {"membrane_stress_ss", "Pa", "its part of tension along warp", membrane<ss>},
      {"membrane_stress_rr", "Pa", "its part of tension along weft", membrane<rr>},
      {"membrane_stress_sr", "Pa", "its part of shear in the plane of the cloth", membrane<sr>},
      {"bending_stress_ss", "Pa", "its part of bending along warp", bending<ss>},
      {"bending_stress_rr", "Pa", "its part of bending along weft", bending<rr>},
      {"bending_stress_sr", "Pa", "its part of twist", bending<sr>},
      stretch,
      curvature,
      {"shear_angle", "rad", "between warp and weft, away from a right angle",
       [](Sample m) { return m.state.shear_angle; }},
      relative_speed,
      water_shear,
  };
  return all;
}

}  // namespace washfsi
