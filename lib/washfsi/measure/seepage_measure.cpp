// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/seepage_measure.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
void SeepageMeasure<Dim>::declare(QuantityList& quantities) {
  const auto& groups = system_.model.cloths.groups();
  if (!system_.model.cloth_treatment.films_drain &&
      std::none_of(groups.begin(), groups.end(), [](const auto& group) { return group.permeance > 0; }))
    return;
  quantities.add({"seepage_power", Units<Dim>::power,
                  "that water loses on its way through permeable cloth, and out of films between cloths",
                  [this] { return system_.step.seepage_power; }},
                 {{"seepage_work", Units<Dim>::energy, OverCycle::integral,
                   "of water on its way through permeable cloth, and out of films between cloths"}});
}

template class SeepageMeasure<2>;
template class SeepageMeasure<3>;

}  // namespace washfsi
