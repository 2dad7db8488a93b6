# SPDX-License-Identifier: BSD-3-Clause
"""Whether designs differ by more than the spread of their seeds: Welch's test, in sentences."""

import itertools
import math
import statistics
from dataclasses import dataclass

import numpy as np

LEVEL = 0.05  # a chance below this counts as a difference
MOST_PAIRS = 6  # named in a sentence
NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)

EXPLANATION = f"""How this is decided. Each design is run with several seeds, which place its cloths differently. Its figure
varies with them; the number behind ± is the standard deviation over seeds. Two designs differ when their means are further apart than
this spread explains. The measure is t: the distance of the means over the standard error of that distance. p is the chance of
such a t, or a larger one, between designs that are alike. Below {LEVEL:g} we say that they differ.

- Two designs: Welch's t, which does not take the spreads to be equal.
- Three or more: a few seeds tell little about the spread of each design, so one spread is taken from all of them together
  (pooled). Where the two designs compared vary more than that, their own spread counts. p is raised after Holm for the number of
  pairs: with designs that are all alike, the chance of naming any pair stays below {LEVEL:g}.

Values over seeds are taken to be normal. Figures are judged one by one. "Not told apart" does not mean equal: more seeds may
tell.
"""


@dataclass
class Comparison:
    """The test of two designs."""

    first: str
    second: str
    t: float
    freedom: float  # degrees of freedom
    chance: float  # p, raised after Holm when there are several pairs

    @property
    def differ(self):
        """Returns whether they differ by more than their spread."""
        return self.chance < LEVEL


def two_sided_chance(t, freedom):
    """Returns the chance that Student's t is as large, in size. With t = sqrt(n) tan(a) its density is cos(a)^(n - 1)."""
    def integral(low):
        half = 0.5 * (math.pi / 2 - low)
        return half * float(WEIGHTS @ np.cos(low + half * (NODES + 1)) ** (freedom - 1))
    return integral(math.atan(abs(t) / math.sqrt(freedom))) / integral(0)


def shares_of(first, second):
    """Returns what each sample gives to the variance of the distance of their means."""
    return [statistics.variance(values) / len(values) for values in (first, second)]


def welch(first, second):
    """Returns Welch's t and its degrees of freedom. At least one of the samples must vary."""
    shares = shares_of(first, second)
    t = (statistics.fmean(first) - statistics.fmean(second)) / math.sqrt(sum(shares))
    freedom = sum(shares) ** 2 / sum(share ** 2 / (len(values) - 1) for share, values in zip(shares, (first, second)))
    return t, freedom


def holm(chances):
    """Returns the chances raised for the number of comparisons, after Holm."""
    raised, largest = list(chances), 0.0
    for rank, place in enumerate(sorted(range(len(chances)), key=chances.__getitem__)):
        largest = max(largest, min(1.0, (len(chances) - rank) * chances[place]))
        raised[place] = largest
    return raised


def pooled_variance(samples):
    """Returns the variance within the samples, of all together, and its degrees of freedom."""
    freedom = sum(len(values) - 1 for values in samples)
    return sum((len(values) - 1) * statistics.variance(values) for values in samples) / freedom, freedom


def pooled(first, second, variance, freedom):
    """Returns t with a pooled variance, or with the samples' own where that is larger, and its degrees of freedom."""
    square = max(variance * (1 / len(first) + 1 / len(second)), sum(shares_of(first, second)))
    return (statistics.fmean(first) - statistics.fmean(second)) / math.sqrt(square), freedom


def compare(samples):
    """Returns the comparisons of all pairs of designs; `samples` has each one's values over seeds."""
    pairs = list(itertools.combinations(samples, 2))
    if len(pairs) == 1:
        tests = [welch(*samples.values())]
    else:
        within = pooled_variance(samples.values())
        tests = [pooled(samples[first], samples[second], *within) for first, second in pairs]
    chances = holm([two_sided_chance(*test) for test in tests])
    return [Comparison(*pair, *test, chance) for pair, test, chance in zip(pairs, tests, chances)]


def chance_text(chance):
    """Returns a chance for people."""
    return "p < 0.0001" if chance < 1e-4 else f"p = {chance:.2g}"


def value_text(values, unit=""):
    """Returns mean and spread of a design; the mean alone with one seed."""
    spread = f" ± {statistics.stdev(values):.2g}" if len(values) > 1 else ""
    return f"{statistics.fmean(values):.4g}{spread}" + ("" if unit in ("-", "") else f" {unit}")


def seeds_text(samples):
    """Returns the number of seeds in words."""
    least, most = (choose(map(len, samples.values())) for choose in (min, max))
    return f"{least} seeds" if least == most else f"{least} to {most} seeds"


def alike_text(tests, reference):
    """Returns which designs are not told apart: all pairs, or if they are many those with the first design."""
    alike = [test for test in tests if not test.differ]
    if len(alike) <= MOST_PAIRS:
        named = "; ".join(f"{pair.first} and {pair.second}" for pair in alike)
        return f" Not told apart: {named}." if alike else ""
    near, far = ([test.second for test in tests if test.first == reference and test.differ == differ] for differ in (False, True))
    return (f" From {reference}, the first, {', '.join(far) or 'none'} {'differs' if len(far) < 2 else 'differ'}; "
            f"not told apart from it: {', '.join(near) or 'none'}.")


def two_designs(title, samples, unit):
    """Returns the sentence for two designs."""
    test, = compare(samples)
    named = [f"{name} ({value_text(values, unit)})" for name, values in samples.items()]
    measure = f"Welch's t = {abs(test.t):.3g} with {test.freedom:.2g} degrees of freedom, {chance_text(test.chance)}"
    verdict = (f"{' and '.join(named)} differ by more than their spread" if test.differ else
               f"{' and '.join(named)} are not told apart: their spread hides any difference")
    return f"{title}: {verdict} over {seeds_text(samples)} ({measure})."


def several_designs(title, samples, unit):
    """Returns the sentences for three designs or more."""
    tests = compare(samples)
    apart = sum(test.differ for test in tests)
    order = sorted(samples, key=lambda name: -statistics.fmean(samples[name]))
    listed = ", ".join(f"{name} {value_text(samples[name], unit)}" for name in order)
    count = {0: "none", len(tests): "all"}.get(apart, apart)
    return (f"{title}: {count} of the {len(tests)} pairs of designs {'differs' if apart < 2 else 'differ'} by more than "
            f"their spread over {seeds_text(samples)} (t with pooled spread, Holm's correction, p < {LEVEL:g}). "
            f"From most to least: {listed}.{alike_text(tests, next(iter(samples)))}")


def still_text(title, samples):
    """Returns that the spread of two designs or more is not known, since seeds change nothing in them; else nothing."""
    still = [name for name, values in samples.items() if statistics.pstdev(values) <= 1e-12 * abs(statistics.fmean(values))]
    return "" if len(still) < 2 else (
        f"{title}: seeds change nothing in {', '.join(still)}. The spread is not known, so nothing can be decided.")


def sentence(title, samples, unit):
    """Returns what can be said of a figure; `samples` has each design's values, one for each seed."""
    if len(samples) < 2:
        return f"{title}: there is no second design with this figure, so nothing can be compared."
    single = [name for name, values in samples.items() if len(values) < 2]
    if single:
        who = "each design has" if len(single) == len(samples) else f"{', '.join(single)} {'has' if len(single) == 1 else 'have'}"
        return (f"{title}: {who} one seed only. The spread over seeds is not known, so nothing can be decided; "
                "run it with --seeds 3 or more.")
    return still_text(title, samples) or (two_designs if len(samples) == 2 else several_designs)(title, samples, unit)
