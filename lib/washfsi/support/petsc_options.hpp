// SPDX-License-Identifier: BSD-3-Clause
//
// The options in PETSc's database, and functions that tell which are for PETSc itself. Names are without the dash.
#pragma once

#include <map>
#include <string>

namespace washfsi {

/// Whether a word is the name of an option by PETSc's rule: a dash or two and a letter, and no number such as -inf.
bool is_option_name(const std::string& word);

/// Every option in PETSc's database with its value, which may be empty.
std::map<std::string, std::string> options_in_database();

/// Whether PETSc itself reads an option, or a solver of ours that it sets up.
bool is_for_petsc(const std::string& name);
/// Options that PETSc itself reads, some of them only when it finalizes.
bool belongs_to_petsc(const std::string& name);
/// Options of our solvers that PETSc reads when one has solved: too late to tell whether it will.
bool is_read_after_solving(const std::string& name);
/// PETSc's names of solvers' options, of which none of ours goes without a prefix.
bool lacks_prefix(const std::string& name);

}  // namespace washfsi
