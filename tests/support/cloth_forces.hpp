// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/damping.hpp"
#include "washfsi/cloth/dead_loads.hpp"
#include "washfsi/cloth/elasticity.hpp"
#include "washfsi/cloth/forces.hpp"
#include "washfsi/cloth/holding_springs.hpp"

namespace washfsi::test {

/// The forces of cloths by themselves, held at the places of this rank's markers.
template <int Dim>
struct ClothForces : Forces<Dim> {
  ClothForces(const Cloths<Dim>& cloths, const Points<Dim>& anchors) : Forces<Dim>(cloths) {
    this->add(std::make_unique<Elasticity<Dim>>(cloths));
    this->add(std::make_unique<StrongElasticity<Dim>>(cloths));
    this->add(std::make_unique<HoldingSprings<Dim>>(cloths, anchors));
    this->add(std::make_unique<Damping<Dim>>(cloths));
    this->add(std::make_unique<DeadLoads<Dim>>(cloths, Point<Dim>::Zero()));
  }
};

}  // namespace washfsi::test
