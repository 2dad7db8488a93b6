# SPDX-License-Identifier: BSD-3-Clause
"""Runs in ParaView. `scripts/paraview` is the command."""
