// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/gap.hpp"

namespace washfsi {

/// The step limit of two facets, from 0 to 1: the share of a motion, all markers straight and at once, after which a
/// tenth of their distance is left, and a hundredth on the way. Additive continuous collision detection (Li, Kaufman
/// and Jiang, ACM Trans. Graph. 40 (2021) 170). Never too large, and 0 for facets that touch.
template <int Dim>
double step_limit(PairKind kind, PairPoints<Dim> places, PairPoints<Dim> motions);

extern template double step_limit<2>(PairKind, PairPoints<2>, PairPoints<2>);
extern template double step_limit<3>(PairKind, PairPoints<3>, PairPoints<3>);

}  // namespace washfsi
