// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/shared_arrays.hpp"

#include "washfsi/contact/contact_force.hpp"

namespace washfsi {

void write_shared(Hdf5File& file, MPI_Comm comm, const std::string& name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  file.write_sealed(name, {{size}, {0}, {rank_of(comm) == 0 ? size : hsize_t{0}}}, values);
}

std::vector<double> read_shared(Hdf5File& file, const std::string& name) {
  const hsize_t size = file.shape(name).at(0);
  return file.read_sealed(name, {{size}, {0}, {size}}, Hdf5File::Readers::whole);
}

namespace {

// visit(the force, the name of its dataset)
template <int Dim, class Visit>
void visit_contact(const Forces<Dim>& forces, const Visit& visit) {
  for (const auto& force : forces.list())
    if (auto* contact = dynamic_cast<ContactForce<Dim>*>(force.get()))
      visit(*contact, contact->is_with_bodies() ? "/body_contact_distances" : "/contact_distances");
}

}  // namespace

// A number more, so that none is empty.
template <int Dim>
void write_contact_distances(Hdf5File& file, const Forces<Dim>& forces) {
  visit_contact(forces, [&](const ContactForce<Dim>& contact, const std::string& name) {
    if (!contact.distances().has_started()) return;
    std::vector<double> kept = contact.distances().kept();
    kept.push_back(contact.distances().usual());
    write_shared(file, forces.comm(), name, kept);
  });
}

template <int Dim>
void read_contact_distances(Hdf5File& file, Forces<Dim>& forces) {
  visit_contact(forces, [&](ContactForce<Dim>& contact, const std::string& name) {
    if (file.has(name)) contact.distances().take(read_shared(file, name));
  });
}

template void write_contact_distances<2>(Hdf5File&, const Forces<2>&);
template void write_contact_distances<3>(Hdf5File&, const Forces<3>&);
template void read_contact_distances<2>(Hdf5File&, Forces<2>&);
template void read_contact_distances<3>(Hdf5File&, Forces<3>&);

}  // namespace washfsi
