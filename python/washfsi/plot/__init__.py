# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results. `scripts/plot` is the command."""
