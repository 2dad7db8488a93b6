// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/cloth/sheet.hpp"

namespace washfsi {

/// The lattice of an undeformed sheet: which edges, quads and bends there are, and what area each stands for. An edge
/// and a quad have the number k of their lowest marker, a bend that of the marker in its middle. Areas are over ds dr.
class ReferenceLattice {
 public:
  /// The sheet must outlive it.
  ReferenceLattice(const Sheet& of_sheet, std::size_t markers)
      : sheet(of_sheet),
        m(std::max<std::size_t>(sheet.width, 1)),
        n(markers / m),
        bending(bending_of(sheet.fabric)),
        along_s(sheet.lattice, n),
        along_r(sheet.lattice, m) {}

  const Sheet& sheet;
  const std::size_t m, n;  ///< markers along r, rows
  const BendingModuli bending;
  const MarkerRow along_s, along_r;

  bool has_edge_s(std::size_t k) const { return k + m < n * m; }
  bool has_edge_r(std::size_t k) const { return k % m + 1 < m; }
  bool has_quad(std::size_t k) const { return has_edge_s(k) && has_edge_r(k); }
  bool bends_along_s(std::size_t k) const { return k >= m && has_edge_s(k); }
  bool bends_along_r(std::size_t k) const { return k % m > 0 && has_edge_r(k); }
  /// Area of an edge along s, an edge along r, and a marker with its bends.
  double share_s(std::size_t k) const { return along_r.share(k % m); }
  double share_r(std::size_t k) const { return along_s.share(k / m); }
  double share(std::size_t k) const { return share_r(k) * share_s(k); }
  /// Share of an edge's area that has no quad.
  double bare_s(std::size_t k) const { return along_r.overhang() * ((k % m == 0) + !has_edge_r(k)); }
  double bare_r(std::size_t k) const { return along_s.overhang() * ((k < m) + !has_edge_s(k)); }
  /// The factor w_b of a marker's bends (cloth/sheet.hpp).
  double bend_weight(std::size_t k) const { return bends_along_s(k) && bends_along_r(k) ? 1 : bending.alone; }
  /// The factor w_t of a quad's twist.
  double twist_weight(std::size_t k) const {
    const double of_s = 1 + along_s.overhang() * ((k < m) + !has_edge_s(k + m));
    const double of_r = 1 + along_r.overhang() * ((k % m == 0) + (k % m + 2 == m));
    return of_s * of_r;
  }
};

}  // namespace washfsi
