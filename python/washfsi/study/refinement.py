# SPDX-License-Identifier: BSD-3-Clause
"""What survives a finer grid: an estimate of each figure from its grids, and whether designs keep their order."""

import itertools
import math
import statistics
from dataclasses import dataclass

from washfsi.study.verdict import compare, still_text, value_text

FIRST = 1.0  # order of convergence of the immersed boundary, where no third grid shows another
ORDERS = (0.3, 4.0)  # an observed order outside of these says that the grids are too coarse to show one

EXPLANATION = """How the estimates are made. Richardson's extrapolation continues the two finest grids to cells of no width:
f + (f - c)/(r^p - 1), with the figures f and c on the finer and the coarser grid, r times as many cells, and the order of convergence
p. With three grids p is the observed order, if there is one; otherwise it is 1, that of the immersed boundary. The band behind ± is the size of
the continuation itself and twice the standard error over seeds, as the root of their squares: the figure on the finest grid lies within it,
near its edge. It is an estimate of the error of the cells, not a bound.

A pair of designs may be ranked by a figure if it differs with the same sign on both of the two finest grids by more than the spread
over seeds.
"""


@dataclass
class Estimate:
    """A figure continued to cells of no width."""

    value: float
    band: float
    order: float
    observed: bool  # whether three grids show the order


def order_of(factors, values):
    """Returns the observed order of convergence of three grids, None where there is none. `factors`: how many times as many
    cells they have along each axis."""
    coarse, middle, fine = (1 / factor for factor in factors)
    steps = values[0] - values[1], values[1] - values[2]
    if steps[0] * steps[1] <= 0:
        return None
    def miss(order):
        return (coarse ** order - middle ** order) / (middle ** order - fine ** order) - steps[0] / steps[1]
    low, high = ORDERS
    if miss(low) * miss(high) > 0:
        return None
    for _ in range(60):
        centre = 0.5 * (low + high)
        low, high = (low, centre) if miss(low) * miss(centre) <= 0 else (centre, high)
    return 0.5 * (low + high)


def error_of(values):
    """Returns the standard error of a mean over seeds, 0 with one seed."""
    return statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else 0.0


def estimate(samples):
    """Returns the estimate of a figure from its values over seeds on two grids or more, {factor: values}."""
    factors = sorted(samples)
    means = [statistics.fmean(samples[factor]) for factor in factors]
    observed = order_of(factors[-3:], means[-3:]) if len(factors) > 2 else None
    order = observed or FIRST
    share = 1 / ((factors[-1] / factors[-2]) ** order - 1)
    further = share * (means[-1] - means[-2])
    error = math.hypot((1 + share) * error_of(samples[factors[-1]]), share * error_of(samples[factors[-2]]))
    return Estimate(means[-1] + further, math.hypot(further, 2 * error), order, observed is not None)


def pairs_of(grids):
    """Returns the pairs of designs in three lists: those that differ with the same sign on both grids, those that change places,
    and the rest. `grids`: of the coarser and the finer, the values over seeds of each design."""
    kept, reversed_pairs, rest = [], [], []
    tests = [compare(samples) for samples in grids]
    for coarse, fine in zip(*tests):
        named = (fine.first, fine.second) if fine.t > 0 else (fine.second, fine.first)
        if not (coarse.differ and fine.differ):
            rest.append(named)
        else:
            (kept if coarse.t * fine.t > 0 else reversed_pairs).append(named)
    return kept, reversed_pairs, rest


def by_means(title, grids):
    """Returns the sentence for designs with one seed: their order alone."""
    orders = [sorted(samples, key=lambda name: -statistics.fmean(samples[name])) for samples in grids]
    if orders[0] == orders[1]:
        return (f"{title}: the order is the same on both grids, {' > '.join(orders[1])}. One seed does not tell whether that is chance; "
                "run it with --seeds 3 or more.")
    return f"{title}: may not be ranked. The order is {' > '.join(orders[0])} on the coarser grid and {' > '.join(orders[1])} on the finer."


def named_pairs(pairs):
    """Returns pairs in words, each with the larger first."""
    return "; ".join(f"{first} > {second}" for first, second in pairs)


def ranking(title, grids):
    """Returns what of the ranking by a figure survives, in a sentence. `grids`: of the two finest grids, the coarser first, the values
    over seeds of each design."""
    common = [name for name in grids[0] if name in grids[1]]
    missing = [name for name in {**grids[0], **grids[1]} if name not in common]
    told = ranking_of(title, [{name: samples[name] for name in common} for samples in grids])
    return told + (f" On one grid only: {', '.join(missing)}." if missing else "")


def ranking_of(title, grids):
    """Returns the sentence on designs that both grids have."""
    if len(grids[0]) < 2:
        return f"{title}: fewer than two designs have this figure on both grids."
    if any(len(values) < 2 for samples in grids for values in samples.values()):
        return by_means(title, grids)
    if undecided := still_text(title, grids[0]) or still_text(title, grids[1]):
        return undecided
    kept, reversed_pairs, rest = pairs_of(grids)
    if reversed_pairs:
        return f"{title}: may not be ranked. On the finer grid, other than on the coarser, {named_pairs(reversed_pairs)}."
    if not kept:
        return f"{title}: may not be ranked. No pair of designs differs on both grids by more than its spread over seeds."
    if not rest:
        return f"{title}: may be ranked. On both grids {named_pairs(kept)}."
    return f"{title}: may be ranked in part. On both grids {named_pairs(kept)}; not told apart on one of them at least: {named_pairs(rest)}."


def estimate_text(samples):
    """Returns the estimate of a figure for people: value, band and order."""
    found = estimate(samples)
    order = f"observed order {found.order:.2g}" if found.observed else f"order {found.order:g}"
    return f"{found.value:.4g} ± {found.band:.2g} ({order})"


def estimate_rows(title, unit, designs):
    """Returns the rows of the table of estimates for a figure; `designs` has {factor: values} for each design."""
    return [[title + (f" [{unit}]" if unit not in ("", "-") else ""), design, samples, estimate_text(samples)]
            for design, samples in designs.items() if len(samples) > 1]


def table(rows):
    """Returns the table of estimates in Markdown."""
    factors = sorted(set(itertools.chain.from_iterable(samples for _, _, samples, _ in rows)))
    heads = ["figure", "design", *(f"cells x {factor:g}" for factor in factors), "estimate"]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for title, design, samples, told in rows:
        cells = [value_text(samples[factor]) if factor in samples else "" for factor in factors]
        lines.append("| " + " | ".join([title, design, *cells, told]) + " |")
    return "\n".join(lines) + "\n"
