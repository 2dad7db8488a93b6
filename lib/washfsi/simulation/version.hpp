// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

extern const char* const version_text;  ///< such as 0.1.0
extern const char* const git_text;      ///< commit that was built; empty outside a checkout

}  // namespace washfsi
