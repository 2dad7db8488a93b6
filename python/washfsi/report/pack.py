# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a run in one compressed text, which the page unpacks as typed arrays."""

import base64
import zlib

import numpy as np

KINDS = {"f4": np.float32, "u1": np.uint8, "u2": np.uint16, "u4": np.uint32}
ALIGNMENT = 4  # [bytes], of the start of each array


class Pack:
    """Arrays behind each other. What `add` returns goes into the page's data, and names the place of an array."""

    def __init__(self):
        self._parts, self._size = [], 0

    def add(self, array, kind="f4"):
        """Adds an array as numbers of a kind, rows behind each other; returns its kind, first byte and count."""
        numbers = np.ascontiguousarray(array, KINDS[kind])
        bytes_ = numbers.tobytes()
        place = {"kind": kind, "start": self._size, "count": numbers.size}
        self._parts.append(bytes_ + bytes(-len(bytes_) % ALIGNMENT))
        self._size += len(self._parts[-1])
        return place

    def add_scaled(self, array, low, high, kind="u2"):
        """Adds numbers between two limits as integers from 0 to the largest of the kind; returns the place with the
        limits. What is beyond a limit counts as the limit."""
        most = np.iinfo(KINDS[kind]).max
        share = (np.asarray(array, float) - low) / (high - low if high > low else 1.0)
        whole = np.rint(most * np.clip(np.nan_to_num(share, posinf=1, neginf=0), 0, 1))
        return self.add(whole, kind) | {"low": float(low), "high": float(high), "most": int(most)}

    def text(self):
        """Returns all arrays, compressed (zlib) and as base64."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), 9)).decode("ascii")


def unpack(text):
    """Returns the bytes of a pack; the page does the same."""
    return zlib.decompress(base64.b64decode(text))
