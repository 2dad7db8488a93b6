// SPDX-License-Identifier: BSD-3-Clause
//
// Speed of the fluid solver on the lid-driven cavity at Re = 1000, beside the memory bandwidth of the machine:
//   mpirun -n 2 washfsi_bench [-bench_cells 64,64,64] [-bench_steps 50] [-bench_contrast 1] [-pressure_pc_type ...]
// Without -bench_cells it runs 128^2, 512^2, 33^3, 64^3 and 128^3.
#include <cstdio>
#include <numbers>

#include <mpi.h>

#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/fluid/fractional_step.hpp"
#include "washfsi/simulation/results.hpp"
#include "washfsi/support/program.hpp"
#include "washfsi/wall_forces/water_step.hpp"

namespace washfsi {
namespace {

/// Bytes moved per second by a = b + s c on all ranks at once, best of ten (McCalpin's STREAM triad, 3 x 8 bytes an
/// entry).
double stream_triad(MPI_Comm comm) {
  constexpr std::size_t size = 20'000'000;
  std::vector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
  double shortest = 1e30;
  for (int run = 0; run < 10; ++run) {
    MPI_Barrier(comm);
    const double start = MPI_Wtime();
    for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 3.0 * c[i];
    MPI_Barrier(comm);
    shortest = std::min(shortest, MPI_Wtime() - start);
  }
  if (a[size / 2] != 7) throw std::runtime_error("the triad was optimised away");
  return ordered_sum(comm, 24.0 * static_cast<double>(size)) / shortest;
}

struct BenchOptions {
  std::vector<double> cells;
  PetscInt steps = 50;
  double contrast = 1;
};

/// Waves of density between 1 and `contrast`.
template <int Dim>
void set_density(const Grid<Dim>& grid, double contrast, Vec density) {
  const FaceView<Dim> rho(grid.face_dm(), density);
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& face) {
      const double wave = (2 * std::numbers::pi * grid.face_center(face, c)).array().cos().prod();
      rho(face, c) = 1 + 0.5 * (contrast - 1) * (1 + wave);
    });
}

/// Cavity with the lid y = 1 moving at 1 m/s, developed for some steps, then timed.
template <int Dim>
void run_cavity(MPI_Comm comm, const std::vector<double>& cells, const BenchOptions& bench, double bandwidth) {
  const PetscInt steps = bench.steps;
  GridShape<Dim> shape;
  for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = static_cast<PetscInt>(cells[d]);
  const Grid<Dim> grid(comm, shape);
  typename Boundary<Dim>::Sides sides;
  sides[1][1].velocity[0] = 1;
  Boundary<Dim> boundary(grid, sides);
  FluidOptions<Dim> options;
  options.density = 1;
  options.viscosity = 1e-3;
  FractionalStep<Dim> fluid(grid, boundary, options);
  const petsc::Vector density = grid.face_vector(), force = grid.face_vector();
  set_density<Dim>(grid, bench.contrast, density);
  const LiquidFields liquid{density, {options.viscosity}};
  const double dt = 0.5 * grid.spacing().minCoeff();
  Clock clock;
  const auto advance = [&] {
    WaterStep<Dim>(fluid, nullptr).advance(clock.next(dt), {liquid, force, {}});
    clock.advance(dt);
  };
  for (PetscInt n = 0; n < steps; ++n) advance();

  const SolverCounts before = fluid.counts();
  MPI_Barrier(comm);
  const double start = MPI_Wtime();
  for (PetscInt n = 0; n < steps; ++n) advance();
  MPI_Barrier(comm);
  const double seconds = (MPI_Wtime() - start) / static_cast<double>(steps);

  const auto flow = FlowDiagnostics<Dim>::of(
      grid, {GhostedVelocity<Dim>(boundary, grid.face_dm(), fluid.velocity(), clock.time), liquid}, dt);
  const double memory = peak_memory(comm), count = static_cast<double>(steps);
  std::vector<std::string> sizes;
  for (const PetscInt n : shape.cells) sizes.push_back(std::to_string(n));
  if (rank_of(comm) == 0)
    std::printf("%-12s %10.3f %12.2f %10.0f %9.1f %9.1f %12.1e %10.0f\n", join(sizes, "x").c_str(), 1e3 * seconds,
                1e-6 * grid.cell_count() / seconds, bandwidth * seconds / grid.cell_count(),
                (fluid.counts().momentum - before.momentum) / count,
                (fluid.counts().pressure - before.pressure) / count, flow.max_divergence * grid.spacing().minCoeff(),
                memory / grid.cell_count());
}

void run_all(Options& options) {
  BenchOptions bench;
  options.block("bench_", "Benchmark", [&](OptionBlock& block) {
    block.reals("cells", bench.cells, 2, 3, "-", "cells in x,y[,z]; without it a list of sizes is run");
    block.integer("steps", bench.steps, at_least_one, "steps timed, after as many to develop the flow");
    block.real("contrast", bench.contrast, "-", positive, "largest density over the smallest; waves between them");
  });
  if (options.help()) return;
  const MPI_Comm comm = options.comm();
  const double bandwidth = stream_triad(comm);
  if (rank_of(comm) == 0)
    std::printf("%d ranks, STREAM triad %.1f GB/s\n%-12s %10s %12s %10s %9s %9s %12s %10s\n", ranks_of(comm),
                1e-9 * bandwidth, "cells", "ms/step", "Mcell-step/s", "bytes/c.s.", "momentum", "pressure",
                "max div h/U", "bytes/cell");
  const std::vector<std::vector<double>> all{{128, 128}, {512, 512}, {33, 33, 33}, {64, 64, 64}, {128, 128, 128}};
  for (const auto& size : bench.cells.empty() ? all : std::vector<std::vector<double>>{bench.cells}) {
    if (size.size() == 2)
      run_cavity<2>(comm, size, bench, bandwidth);
    else
      run_cavity<3>(comm, size, bench, bandwidth);
  }
}

}  // namespace
}  // namespace washfsi

int main(int argc, char** argv) {
  return washfsi::run_program("washfsi_bench", [&] {
    WASH_PETSC(PetscInitialize(&argc, &argv, nullptr, "washfsi_bench: speed of the fluid solver\n"));
    washfsi::Options options(PETSC_COMM_WORLD);
    washfsi::run_all(options);
  });
}
