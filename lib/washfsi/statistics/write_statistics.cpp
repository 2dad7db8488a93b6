// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/write_statistics.hpp"

#include "washfsi/output/history.hpp"
#include "washfsi/statistics/shared_file.hpp"

namespace washfsi {

namespace {

std::string unit_of(const std::string& name) {
  if (name == "p") return "Pa";
  if (name == "pp") return "Pa2";
  return name.size() == 1 ? "m/s" : "m2/s2";
}

template <int Dim>
double place_of(const Grid<Dim>& grid, int axis, PetscInt cell) {
  return grid.lower()[axis] + (static_cast<double>(cell) + 0.5) * grid.spacing()[axis];
}

template <int Dim>
std::vector<double> places_along(const Grid<Dim>& grid, int axis) {
  std::vector<double> places;
  for (PetscInt cell = 0; cell < grid.cells()[axis]; ++cell) places.push_back(place_of<Dim>(grid, axis, cell));
  return places;
}

template <int Dim>
void write_means(const FlowStatistics<Dim>& statistics, const SharedFile& file) {
  std::vector<hsize_t> shape;
  for (const int axis : statistics.bins().axes()) {
    const std::vector<double> places = places_along<Dim>(statistics.grid(), axis);
    file.write(std::string("/") + "xyz"[axis], "m", {places.size()}, places);
    shape.insert(shape.begin(), places.size());
  }
  if (shape.empty()) shape.push_back(1);
  for (const std::string& name : moment_names<Dim>())
    file.write((name.size() == 1 ? "/mean/" : "/stress/") + name, unit_of(name), shape, statistics.mean(name));
}

template <int Dim>
void write_spectra(const FlowStatistics<Dim>& statistics, const SharedFile& file) {
  for (std::size_t n = 0; n < statistics.places().size(); ++n) {
    const SpectrumPlace& place = statistics.places()[n];
    const std::string group = "/spectra/" + std::to_string(n);
    std::vector<double> wave_numbers;
    for (std::size_t k = 0; k < place.modes; ++k)
      wave_numbers.push_back(static_cast<double>(k) * place.wave_number_step);
    file.write(group + "/wave_number", "1/m", {place.modes}, wave_numbers);
    file.write(group + "/energy", "m3/s2", {Dim, place.modes}, statistics.spectra(n));
    file.file().set_attribute(group, "place", place.height);
    file.file().set_text(group, "along", std::string(1, "xyz"[place.along]));
  }
}

template <int Dim>
void write_table_of_means(const FlowStatistics<Dim>& statistics, const std::string& folder) {
  if (statistics.bins().axes().size() != 1) return;
  const int axis = statistics.bins().axes()[0];
  std::vector<Column> columns{{std::string(1, "xyz"[axis]), "m"}};
  std::vector<std::vector<double>> rows;
  for (const double place : places_along<Dim>(statistics.grid(), axis)) rows.push_back({place});
  for (const std::string& name : moment_names<Dim>()) {
    columns.push_back({name, unit_of(name)});
    const std::vector<double> values = statistics.mean(name);
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n].push_back(values[n]);
  }
  write_table(statistics.grid().comm(), folder + "/statistics.csv", columns, rows);
}

}  // namespace

template <int Dim>
void write_statistics(const FlowStatistics<Dim>& statistics, const std::string& folder) {
  write_shared_file(statistics.grid().comm(), folder + "/statistics.h5", [&](const SharedFile& file) {
    file.file().set_attribute("/", "averaged_time", statistics.averaged_time());
    file.file().set_attribute("/", "start", statistics.start());
    write_means(statistics, file);
    write_spectra(statistics, file);
  });
  write_table_of_means(statistics, folder);
}

template void write_statistics<2>(const FlowStatistics<2>&, const std::string&);
template void write_statistics<3>(const FlowStatistics<3>&, const std::string&);

}  // namespace washfsi
