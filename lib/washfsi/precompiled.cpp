// SPDX-License-Identifier: BSD-3-Clause
// Nothing: its target compiles headers once for all others.
