// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "washfsi/support/option_block.hpp"
#include "washfsi/support/option_register.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

/// Every option the program knows, as it is declared: for the resolved options file and for spelling help.
class Options {
 public:
  /// `documents`: only to tell what options there are. `given`: where PETSc's options come from.
  explicit Options(MPI_Comm comm, bool documents = false, GivenOptions given = {});

  /// Opens a block of options that share a prefix (may be empty). Where the user gives none, one with the prefix
  /// `fallback` counts: -cloths_ke for the -NAME_ke of each group of cloths. Collective.
  void block(const std::string& prefix, const std::string& title, const std::function<void(OptionBlock&)>& declare,
             const std::string& fallback = "");

  /// Lets an old name stand for the present one, to be called before that is read; `notes` say so. What is on the
  /// command line counts more than what is in a file, by either name. Errors: InputError if the user gave both in one
  /// place.
  void alias(const std::string& old_name, const std::string& name);
  /// Lets an old value of an option stand for the present one; `notes` say so.
  void alias_value(const std::string& name, const std::string& old_value, const std::string& value);
  /// A name as the user gave it: the old one, perhaps.
  std::string as_given(const std::string& name) const { return register_.old_names.as_given(name); }
  /// A line for each old name that the user gave, each warning, and each reason for which options have no effect.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Replaces the recorded value of an option by one that the program has computed.
  void record(const std::string& name, const std::string& value) { register_.declared.record(name, value); }

  /// Takes a name that the user chose as the prefix of options: it must be no other part's. Errors: InputError.
  void claim_prefix(const std::string& name, const std::string& option);

  const GivenOptions& given() const { return register_.given; }
  /// Registers the options of a part that a later option has switched off, so that `reject_unread` accepts them: those
  /// in `declare` are neither declared, read nor checked. `reason` is the text of the warning.
  void leave_out(const std::string& reason, const std::function<void()>& declare);
  /// `leave_out` of each part that an earlier value of a list names, and `present` does not.
  void leave_out_dropped(const std::string& list, const std::vector<std::string>& present,
                         const std::function<void(const std::string& name)>& declare);

  /// Marks options that were read but have no effect because of others: `reject_unread` warns of those that the user
  /// gave and did not switch off; if the option with which the reason begins was given later, overriding an earlier
  /// file, it prints a note instead. A name may end with *, for all that begin so.
  void mark_idle(const std::string& reason, const std::vector<std::string>& names) {
    register_.declared.mark_idle(reason, names);
  }
  /// Adds a warning on the user's options to the notes.
  void warn(const std::string& text) { notes_.push_back("warning: " + text); }
  /// Sets the message for an option that does not exist, in place of the usual one that nobody reads it.
  void answer(const std::string& name, const std::string& text) { register_.answers[name] = text; }

  /// Stops if the user gave an option that nobody read; PETSc's own options pass, and those that were left out or are
  /// idle become `notes`. Call once all parts are set up.
  void reject_unread();

  /// An options file that repeats the run: ours with the values used, then PETSc's as the user gave them.
  std::string resolved() const;

  MPI_Comm comm() const { return comm_; }
  /// True if the user asked for -help or a document, or in `leave_out`: required options are then not required, and
  /// nothing is built.
  bool help() const { return register_.help || register_.left_out.is_leaving_out(); }
  /// Example names for lists of names that the user leaves empty, so that help (`name`) and document (`placeholder`)
  /// show the options of one. Empty otherwise.
  std::vector<std::string> examples(const char* name, const char* placeholder) const;
  /// What the user gave, and what has been declared so far.
  const OptionRegister& known() const { return register_; }

 private:
  MPI_Comm comm_;
  bool documents_ = false;
  OptionRegister register_;
  std::vector<std::string> notes_;
  std::set<std::string> claimed_;  ///< prefixes chosen by the user
};

}  // namespace washfsi
