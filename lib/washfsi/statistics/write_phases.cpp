// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/write_phases.hpp"

#include <functional>

#include "washfsi/statistics/shared_file.hpp"

namespace washfsi {

namespace {

/// A number of each bin of each phase.
struct BinQuantity {
  const char *name, *unit;
  std::function<double(const RingMeans&)> value;
};

std::vector<BinQuantity> quantities() {
  return {{"/mean/u_r", "m/s", [](const RingMeans& ring) { return ring.velocity[0]; }},
          {"/mean/u_theta", "m/s", [](const RingMeans& ring) { return ring.velocity[1]; }},
          {"/mean/u_z", "m/s", [](const RingMeans& ring) { return ring.velocity[2]; }},
          {"/turbulence_energy", "m2/s2", [](const RingMeans& ring) { return ring.turbulence_energy; }},
          {"/dissipation", "m2/s3", [](const RingMeans& ring) { return ring.dissipation; }},
          {"/model_dissipation", "m2/s3", [](const RingMeans& ring) { return ring.model_dissipation; }}};
}

void write_axes(const PhaseStatistics& phases, const SharedFile& file) {
  std::vector<double> middles, samples, times;
  for (std::size_t n = 0; n < phases.count(); ++n) {
    middles.push_back((static_cast<double>(n) + 0.5) / static_cast<double>(phases.count()));
    samples.push_back(phases.samples(n));
    times.push_back(phases.averaged_time(n));
  }
  file.write("/phase", "-", {middles.size()}, middles);
  file.write("/samples", "-", {samples.size()}, samples);
  file.write("/averaged_time", "s", {times.size()}, times);
  file.write("/r", "m", {phases.bins().radii().size()}, phases.bins().radii());
  file.write("/z", "m", {phases.bins().heights().size()}, phases.bins().heights());
}

void write_attributes(const PhaseStatistics& phases, Hdf5File& file) {
  const PhaseOptions& options = phases.options();
  file.set_attribute("/", "period", options.period);
  file.set_attribute("/", "start", options.sampling.start);
  file.set_text("/", "axis", std::string(1, "xyz"[options.axis]));
  for (int d = 0; d < 3; ++d) file.set_attribute("/", std::string("center_") + "xyz"[d], (*options.center)[d]);
}

// A number of each bin, phase by phase.
template <class Value>
std::vector<double> in_all_bins(const PhaseStatistics& phases, const Value& value) {
  std::vector<double> values;
  for (std::size_t phase = 0; phase < phases.count(); ++phase)
    for (std::size_t bin = 0; bin < phases.bins().count(); ++bin) values.push_back(value(phase, bin));
  return values;
}

}  // namespace

void write_phases(const PhaseStatistics& phases, const std::string& folder) {
  const std::vector<hsize_t> shape{phases.count(), phases.bins().heights().size(), phases.bins().radii().size()};
  write_shared_file(phases.grid().comm(), folder + "/phases.h5", [&](const SharedFile& file) {
    write_attributes(phases, file.file());
    write_axes(phases, file);
    file.write("/liquid_share", "-", shape,
               in_all_bins(phases, [&](auto phase, auto bin) { return phases.liquid_share(phase, bin); }));
    for (const BinQuantity& quantity : quantities())
      file.write(quantity.name, quantity.unit, shape,
                 in_all_bins(phases, [&](auto phase, auto bin) { return quantity.value(phases.means(phase, bin)); }));
  });
}

}  // namespace washfsi
