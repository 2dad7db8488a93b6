// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "support/refusal.hpp"
#include "washfsi/shapes/mesh_shells.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/sampled.hpp"
#include "washfsi/shapes/stl_shape.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

using Facets = std::vector<Triangle>;

/// A sphere: an octahedron whose facets are each cut into n x n, pushed out to the radius. Floats, as files hold.
Facets sphere(int n, double radius) {
  Facets facets;
  for (int octant = 0; octant < 8; ++octant) {
    const Point<3> sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    const auto point = [&](int i, int j) {
      const Point<3> flat(i, j, n - i - j);
      return Point<3>(sign.cwiseProduct(flat.normalized() * radius).cast<float>().cast<double>());
    };
    const auto add = [&](const Point<3>& a, const Point<3>& b, const Point<3>& c) {
      facets.push_back(sign.prod() > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n - i; ++j) {
        add(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j < n - 1) add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
  }
  return facets;
}

/// A box about the origin, two facets a side.
Facets box(const Point<3>& size) {
  Facets facets;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      const auto corner = [&](double u, double v) {
        Point<3> place = Point<3>::Zero();
        place[axis] = side * size[axis];
        place[(axis + 1) % 3] = u * size[(axis + 1) % 3];
        place[(axis + 2) % 3] = v * size[(axis + 2) % 3];
        return place;
      };
      const Point<3> a = corner(-0.5, -0.5), b = corner(0.5, -0.5), c = corner(0.5, 0.5), d = corner(-0.5, 0.5);
      facets.push_back(side > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
      facets.push_back(side > 0 ? Triangle{a, c, d} : Triangle{a, d, c});
    }
  return facets;
}

std::string ascii(const Facets& facets) {
  std::string text = "solid test\n";
  for (const auto& facet : facets) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const auto& corner : facet) {
      text += "      vertex";
      for (int d = 0; d < 3; ++d) text += " " + to_text(corner[d]);
      text += "\r\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid test\n";
}

std::string binary(const Facets& facets) {
  std::string bytes = "solid, although binary";
  bytes.resize(80);
  const auto append = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int d = 0; d < 3; ++d) append(0.0F);
    for (const auto& corner : facet)
      for (int d = 0; d < 3; ++d) append(static_cast<float>(corner[d]));
    append(std::uint16_t{0});
  }
  return bytes;
}

/// A file with this content, one for each number of ranks: such tests may run beside each other.
std::string file_of(const std::string& content) {
  std::string path = "stl_test_" + std::to_string(ranks_of(PETSC_COMM_WORLD)) + ".stl";
  if (rank_of(PETSC_COMM_WORLD) == 0) std::ofstream(path, std::ios::binary) << content;
  MPI_Barrier(PETSC_COMM_WORLD);
  return path;
}

ShapePtr<3> read(const std::string& content, double spacing, double scale = 1) {
  Options options(PETSC_COMM_WORLD);
  return shape_from_stl(options, {file_of(content), scale, spacing}, "a");
}

TEST(ReadStl, AsciiAndBinaryGiveTheSameFacets) {
  const Facets facets = sphere(4, 0.3);
  for (const auto& content : {ascii(facets), binary(facets)})
    EXPECT_EQ(read_stl(PETSC_COMM_WORLD, file_of(content), "-a_file"), facets);
}

TEST(TriangleMesh, SharesVertices) {
  const auto mesh = TriangleMesh::weld(box({1, 2, 3}));
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.facets.size(), 12U);
  EXPECT_EQ(mesh.flaw(), "");
}

/// Largest difference of two distances over random places.
double difference(const Shape<3>& shape, const Shape<3>& exact, double reach) {
  double worst = 0;
  for (const auto& place : random_points<3>(2000, 5, reach))
    worst = std::max(worst, std::abs(shape.distance(place) - exact.distance(place)));
  return worst;
}

TEST(MeshDistance, OfASphereErrsByTheSquareOfTheFacets) {
  double before = 0;
  for (const int n : {4, 8, 16, 32}) {
    const MeshDistance mesh(TriangleMesh::weld(sphere(n, 1)));
    const double longest = 3.4 / n;  // the facets in the middle of an octant are the largest
    const double error = difference(mesh, Sphere<3>(1), 1.5);
    EXPECT_LE(error, longest * longest / 6);
    if (before > 0) {
      EXPECT_GT(before / error, 3);
    }
    before = error;
    if (rank_of(PETSC_COMM_WORLD) == 0) std::printf("%2d facets along an edge: error %.2e of the radius\n", n, error);
  }
}

TEST(MeshDistance, OfABoxIsExactAlsoBesideEdgesAndCorners) {
  const Point<3> size(1, 0.5, 0.25);
  const MeshDistance mesh(TriangleMesh::weld(box(size)));
  const Cuboid<3> exact(size);
  EXPECT_LE(difference(mesh, exact, 1), 1e-14);
  for (const auto& near : random_points<3>(500, 8, 1e-3))
    for (const Point<3>& edge : {Point<3>(0.5, 0.25, 0.125), Point<3>(0.5, 0.25, 0.03), Point<3>(-0.1, -0.25, 0.125)})
      EXPECT_NEAR(mesh.distance(edge + near), exact.distance(edge + near), 1e-15);
}

// A sharp wedge: what is nearest to its edge sees facets from behind, where a single facet's normal would mislead.
TEST(MeshDistance, HasTheRightSignBesideASharpEdge) {
  const Points<3> v{{0, 0, 0}, {1, 0.05, 0}, {1, -0.05, 0}, {0, 0, 1}, {1, 0.05, 1}, {1, -0.05, 1}};
  const Facets wedge{{v[0], v[1], v[4]}, {v[0], v[4], v[3]}, {v[0], v[3], v[5]}, {v[0], v[5], v[2]},
                     {v[1], v[2], v[5]}, {v[1], v[5], v[4]}, {v[0], v[2], v[1]}, {v[3], v[4], v[5]}};
  Facets outwards = wedge;
  if (TriangleMesh::weld(wedge).flaw().starts_with("its facets face inwards"))
    for (auto& facet : outwards) std::swap(facet[1], facet[2]);
  ASSERT_EQ(TriangleMesh::weld(outwards).flaw(), "");
  const MeshDistance mesh(TriangleMesh::weld(outwards));
  for (const auto& place : random_points<3>(3000, 12, 1.5)) {
    const bool inside = place[2] > 0 && place[2] < 1 && place[0] < 1 && std::abs(place[1]) < 0.05 * place[0];
    EXPECT_EQ(mesh.distance(place) < 0, inside) << place.transpose();
  }
  EXPECT_GT(mesh.distance({-0.1, 0, 0.5}), 0);
  EXPECT_LT(mesh.distance({0.1, 0, 0.5}), 0);
}

TEST(Sampled, InterpolatesAtSecondOrder) {
  const Point<3> reach = Point<3>::Constant(1.2);
  double before = 0;
  for (const double spacing : {0.1, 0.05, 0.025}) {
    const auto sampled = Sampled<3>::of(PETSC_COMM_WORLD, Sphere<3>(1), Lattice<3>::around(-reach, reach, 0, spacing));
    double worst = 0;
    for (const auto& place : random_points<3>(5000, 2, 1.15))
      if (place.norm() > 0.7) worst = std::max(worst, std::abs(sampled->distance(place) - (place.norm() - 1)));
    EXPECT_LE(worst, spacing * spacing / 8 * 2 / 0.6);
    if (before > 0) {
      EXPECT_NEAR(before / worst, 4, 0.8);
    }
    before = worst;
    if (rank_of(PETSC_COMM_WORLD) == 0) std::printf("spacing %.3f: error %.2e of the radius\n", spacing, worst);
  }
}

template <int Dim>
void expect_bound_beyond_the_lattice() {
  const Point<Dim> reach = Point<Dim>::Constant(0.6);
  const Sphere<Dim> exact(0.5);
  const auto sampled = Sampled<Dim>::of(PETSC_COMM_WORLD, exact, Lattice<Dim>::around(-reach, reach, 0, 0.05));
  for (const auto& place : random_points<Dim>(1000, 3, 3)) {
    if ((place.cwiseAbs() - reach).maxCoeff() < 0) continue;
    const double distance = sampled->distance(place);
    EXPECT_GT(distance, 0);
    EXPECT_LE(distance, exact.distance(place) + 2e-3);  // the interpolation's own error
    EXPECT_GE(distance, 0.6 * exact.distance(place));
  }
}

TEST(Sampled, IsABoundBeyondTheLattice) {
  expect_bound_beyond_the_lattice<2>();
  expect_bound_beyond_the_lattice<3>();
}

TEST(StlShape, OfASphereIsTheSphere) {
  const Facets facets = sphere(32, 500);  // millimetres
  for (const auto& content : {ascii(facets), binary(facets)}) {
    const auto shape = read(content, 0.02, 1e-3);
    double worst = 0;
    for (const auto& place : random_points<3>(2000, 6, 0.6))
      if (place.norm() > 0.2) worst = std::max(worst, std::abs(shape->distance(place) - (place.norm() - 0.5)));
    EXPECT_LE(worst, 1.3e-3);  // of the facets 0.5 (3.4/32)^2/8, of the samples 0.02^2/8 * 2/0.2
  }
}

TEST(StlShape, OfABoxKeepsSignsNearEdges) {
  const Point<3> size(0.5, 0.4, 0.3);
  const auto shape = read(binary(box(size)), 0.01);
  const Cuboid<3> exact(size);
  for (const auto& place : random_points<3>(5000, 7, 0.35)) {
    const double distance = exact.distance(place);
    if (distance > 0.07) continue;  // beyond the lattice
    EXPECT_NEAR(shape->distance(place), distance, 0.006);
    if (std::abs(distance) > 0.006) {
      EXPECT_EQ(shape->distance(place) < 0, distance < 0) << place.transpose();
    }
  }
}

TEST(StlShape, RefusesBrokenFilesWithOneLine) {
  const Facets good = box({1, 1, 1});
  const auto changed = [&](const std::function<void(Facets&)>& change) {
    Facets facets = good;
    change(facets);
    return facets;
  };
  const Facets open = changed([](Facets& f) { f.pop_back(); });
  const Facets turned = changed([](Facets& f) { std::swap(f[3][0], f[3][1]); });
  const Facets inwards = changed([](Facets& f) {
    for (auto& facet : f) std::swap(facet[0], facet[1]);
  });
  const Facets thin = changed([](Facets& f) { f.push_back({f[0][0], f[0][1], f[0][1]}); });
  const Facets doubled = changed([](Facets& f) { f.insert(f.end(), f.begin(), f.begin() + 12); });
  const Facets infinite = changed([](Facets& f) { f[2][1][0] = std::numeric_limits<double>::infinity(); });
  const std::string text = ascii(good), bytes = binary(good);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "is no STL file"},
      {"not a solid at all\n", "is no STL file"},
      {std::string("\x7f"
                   "ELF\0\0\1",
                   7),
       "is no STL file"},
      {bytes.substr(0, 300), "as a binary one it should have 684 bytes, but has 300"},
      {bytes + "x", "but has 685"},
      {text.substr(0, text.find("endsolid")), "ends before its endsolid"},
      {text.substr(0, text.find("endloop")), "ends within a facet"},
      {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n", "line 4 must be: vertex and three numbers"},
      {"solid a\nfacet normal 0 0 1\nvertex 0 0 0\n", "line 3 must be: outer loop"},
      {"solid a\nendsolid a\n", "it has no facets"},
      {binary({}), "it has no facets"},
      {binary(open), "it is open at the edge"},
      {ascii(turned), "two facets face opposite ways at the edge"},
      {binary(inwards), "its facets face inwards"},
      {ascii(thin), "facet 13 has no area"},
      {binary(doubled), "more than two facets meet at the edge"},
      {binary(infinite), "facet 3 has a corner that is not finite"},
  };
  for (const auto& [content, words] : cases) {
    const std::string line = refusal_of<InputError>([&facets = content] { (void)read(facets, 0.1); });
    EXPECT_NE(line.find(words), std::string::npos) << words << "\n  " << line;
    EXPECT_EQ(line.find("-a_file stl_test_"), 0U) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  const std::string line = refusal_of<InputError>([&] { (void)read(bytes, 1e-4); });
  EXPECT_EQ(line.find("-a_sample_spacing " + to_text(1e-4) + ": must be at least about 3.0e-03"), 0U) << line;
  for (const std::string path : {"nowhere.stl", "."})
    EXPECT_EQ(refusal_of<InputError>([&] {
                Options options(PETSC_COMM_WORLD);
                (void)shape_from_stl(options, {path, 1, 0.1}, "a");
              }),
              "-a_file " + path + ": cannot be read");
}

Facets moved(Facets facets, const Point<3>& by) {
  for (auto& facet : facets)
    for (auto& corner : facet) corner += by;
  return facets;
}

Facets turned_round(Facets facets) {
  for (auto& facet : facets) std::swap(facet[1], facet[2]);
  return facets;
}

MeshShells shells(std::initializer_list<Facets> parts) {
  Facets all;
  for (const Facets& part : parts) all.insert(all.end(), part.begin(), part.end());
  const TriangleMesh mesh = TriangleMesh::weld(all);
  EXPECT_EQ(mesh.flaw(), "");
  EXPECT_EQ(shells_of(mesh).size(), parts.size());
  return MeshShells(shells_of(mesh), "");
}

TEST(MeshShells, OverlappingOnesAreTheirUnion) {
  const Point<3> aside(0.6, 0.1, 0);
  const MeshShells both = shells({sphere(24, 1), moved(sphere(24, 1), aside)});
  const auto exact = [&](const Point<3>& place) { return std::min(place.norm(), (place - aside).norm()) - 1; };
  for (const auto& place : random_points<3>(500, 1, 2.0)) EXPECT_NEAR(both.distance(place), exact(place), 5e-3);
  EXPECT_NEAR(both.distance(0.5 * aside), exact(0.5 * aside), 5e-3);  // within both
}

TEST(MeshShells, CavitiesBelongToWhatIsRoundThem) {
  const MeshShells nested = shells({sphere(24, 1), turned_round(sphere(24, 0.8)), sphere(24, 0.4)});
  const auto exact = [](const Point<3>& place) {
    return std::min(place.norm() - 0.4, std::max(place.norm() - 1, 0.8 - place.norm()));
  };
  for (const auto& place : random_points<3>(500, 2, 1.5)) EXPECT_NEAR(nested.distance(place), exact(place), 5e-3);
}

TEST(MeshShells, CountsThoseThatLieInTheSolidOfAnother) {
  const Facets outer = sphere(8, 1), inner = sphere(8, 0.5);
  EXPECT_EQ(shells({outer, inner}).shells_within_others(), 1U);
  EXPECT_EQ(shells({inner, outer, moved(sphere(4, 0.1), {0.7, 0, 0})}).shells_within_others(), 2U);
  EXPECT_EQ(shells({outer, turned_round(inner)}).shells_within_others(), 0U);
  EXPECT_EQ(shells({outer, turned_round(inner), sphere(8, 0.2)}).shells_within_others(), 0U);  // in the cavity
  EXPECT_EQ(shells({outer, moved(inner, {0.7, 0, 0})}).shells_within_others(), 0U);            // it sticks out
  EXPECT_EQ(shells({outer, moved(inner, {3, 0, 0})}).shells_within_others(), 0U);
}

TEST(MeshShells, OneThatFacesInwardsAloneIsRefused) {
  const Facets all = [] {
    Facets facets = sphere(4, 1);
    for (const auto& facet : moved(turned_round(sphere(4, 0.5)), {3, 0, 0})) facets.push_back(facet);
    return facets;
  }();
  EXPECT_THROW(MeshShells(shells_of(TriangleMesh::weld(all)), ""), InputError);
}

}  // namespace
}  // namespace washfsi::test
