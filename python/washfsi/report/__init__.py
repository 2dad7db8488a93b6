# SPDX-License-Identifier: BSD-3-Clause
"""Runs as one HTML file that opens offline. `scripts/report` is its command."""
