// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/statistics/flow_statistics.hpp"

namespace washfsi {

/// Writes FOLDER/statistics.h5 and, with one inhomogeneous axis, FOLDER/statistics.csv. Collective. Errors: FileError.
template <int Dim>
void write_statistics(const FlowStatistics<Dim>& statistics, const std::string& folder);

extern template void write_statistics<2>(const FlowStatistics<2>&, const std::string&);
extern template void write_statistics<3>(const FlowStatistics<3>&, const std::string&);

}  // namespace washfsi
