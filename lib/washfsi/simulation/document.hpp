// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// The documents that the program can print instead of running.
enum class Document {
  none,
  options,     ///< all options
  quantities,  ///< the columns of the case's history.csv
};
const ChoiceNames<Document>& names_of(Document);

/// -document. Collective. Errors: InputError.
Document document_from_options(Options& options);

/// All options in two and in three dimensions, in tables in Markdown. CLOTH, BODY and LINE stand for names that users
/// choose. Collective.
std::string document_options(MPI_Comm comm);

/// The measured quantities of the case, in a table in Markdown. Collective. Errors: InputError.
template <int Dim>
std::string document_quantities(Options& options);

extern template std::string document_quantities<2>(Options&);
extern template std::string document_quantities<3>(Options&);

}  // namespace washfsi
