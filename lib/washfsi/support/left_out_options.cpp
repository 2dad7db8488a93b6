// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/left_out_options.hpp"

#include <utility>

#include "washfsi/support/errors.hpp"

namespace washfsi {

void LeftOutOptions::leave_out(const std::string& reason, const std::function<void()>& declare) {
  const std::string before = std::exchange(reason_, reason);
  try {
    declare();
  } catch (const InputError&) {  // defaults that do not fit each other matter to nobody
  }
  reason_ = before;
}

}  // namespace washfsi
