# SPDX-License-Identifier: BSD-3-Clause
"""Studies: many runs, one table of their results, and what can be decided from it. `scripts/study` is its command."""
