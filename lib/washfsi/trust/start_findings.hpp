// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/cycles.hpp"
#include "washfsi/trust/body_survey.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// Times of a run [s].
struct RunTimes {
  double end = 0, checkpoint_interval = 0, output_interval = 0, history_interval = 0;
  double verify_interval = 0;                                          ///< interval between counts of intersections
  double sampling_start = 0, sampling_interval = 0, phase_period = 0;  ///< times of statistics
};

/// The scales of the flow: the largest speed, and the length that belongs to it.
struct FlowScales {
  double speed = 0;   ///< [m/s]; 0 if nothing is known to move
  double length = 0;  ///< [m]: from the axis to the tip of the fastest body, else of what the water flows round
  std::string length_of;
  double reynolds = 0;
};

/// Collective.
template <int Dim>
FlowScales flow_scales(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys);

/// Findings on a case before its first step, from the system at t = 0: scales, resolution, bodies, cloths, times.
/// Collective.
template <int Dim>
Findings start_findings(const System<Dim>& system, const Cycles& cycles, const RunTimes& times);

}  // namespace washfsi
