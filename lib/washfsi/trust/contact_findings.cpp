// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/contact_findings.hpp"

#include <algorithm>

#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

template <int Dim>
Finding finding_on(const ContactForce<Dim>& contact) {
  const PairDistances& distances = contact.distances();
  const auto nearest = std::ranges::min_element(distances.less(), {}, [](const auto& item) { return item.second; });
  const std::size_t pairs = distances.less().size();
  Finding finding;
  finding.name = contact.is_with_bodies() ? "contact with bodies at the start" : "contact of cloths at the start";
  finding.text = std::to_string(pairs) + (pairs == 1 ? " pair starts" : " pairs start") +
                 format_text(" nearer than %.3g m, from %.3g m: their contact begins there until they part",
                             distances.usual(), nearest->second);
  finding.display = Display::always;
  return finding;
}

}  // namespace

template <int Dim>
Findings contact_findings(const System<Dim>& system) {
  Findings findings;
  for (const auto& force : system.model.forces.list())
    if (const auto* contact = dynamic_cast<const ContactForce<Dim>*>(force.get()))
      if (!contact->distances().less().empty()) findings.push_back(finding_on(*contact));
  return findings;
}

template Findings contact_findings<2>(const System<2>&);
template Findings contact_findings<3>(const System<3>&);

}  // namespace washfsi
