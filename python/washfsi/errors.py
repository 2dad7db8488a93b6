# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong with results and runs."""


class ResultsError(Exception):
    """A file of results is missing or cannot be read."""


class RunError(Exception):
    """A run has failed. The message is the program's own line; `status` is its exit status."""

    def __init__(self, message, status):
        super().__init__(message)
        self.status = status
