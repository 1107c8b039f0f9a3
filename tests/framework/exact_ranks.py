#!/usr/bin/env python3
"""exact_ranks.py DRIVER [SAMPLES]: ranks, signed-rank statistics, exact p and mean ranks of tie-rich samples, as the program
computes them (rankDriver.cpp) and in exact arithmetic."""
import random
import subprocess
import sys
from collections import Counter
from fractions import Fraction

LANE = 64  # bits of one coefficient of a polynomial that is kept in one whole number


def shared_ranks(values):
    """Ranks from 1 on, equal values sharing the mean of theirs."""
    counts = Counter(values)
    ranks, below = {}, 0
    for value in sorted(counts, key=lambda value: (value is None, value or 0)):  # None: no answer, above all
        ranks[value] = Fraction(2 * below + counts[value] + 1, 2)
        below += counts[value]
    return [ranks[value] for value in values]


def signed_rank(first, second):
    """Statistic, two-sided p (None of fewer than six pairs), and the signed order of the sizes of log(first / second)."""
    sizes, signs = [], []
    for a, b in zip(first, second):
        sizes.append(Fraction(max(a, b), min(a, b)))
        signs.append((a > b) - (a < b))
    number = {size: i + 1 for i, size in enumerate(sorted({size for size, sign in zip(sizes, signs) if sign}))}
    order = [sign * number[size] if sign else 0 for size, sign in zip(sizes, signs)]
    kept = [(size, sign) for size, sign in zip(sizes, signs) if sign]
    ranks = shared_ranks([size for size, _ in kept])
    statistic = sum((rank for rank, (_, sign) in zip(ranks, kept) if sign > 0), Fraction(0))
    if len(kept) < 6:
        return statistic, None, order
    ways = 1  # coefficient k: of how many signs the doubled rank sum is k
    total = 0
    for rank in ranks:
        twice = int(2 * rank)
        ways += ways << (LANE * twice)
        total += twice
    least = min(int(2 * statistic), total - int(2 * statistic))
    mask = (1 << LANE) - 1
    tail = sum(ways >> (LANE * k) & mask for k in range(least + 1))
    return statistic, min(Fraction(1), Fraction(2 * tail, 2 ** len(ranks))), order


def median(values):
    """Of costs of which None is above all; None where it is one of these, or half of it."""
    order = sorted(values, key=lambda value: (value is None, value or 0))
    low, high = order[(len(order) - 1) // 2], order[len(order) // 2]
    return None if low is None or high is None else (low + high) / 2


def mean_ranks(rows):
    return [sum(column) / len(rows) for column in zip(*(shared_ranks([median(cell) for cell in row]) for row in rows))]


def text_of(value):
    """As a decimal that reads back as the same number of nanoseconds."""
    return "-1" if value is None else f"{int(value * 10**9) / 10**9:.9f}" if value.denominator > 1 else str(value)


def pairs_sample(rng):
    """Costs with few distinct ratios: multiples of small numbers, halves, or times in milliseconds."""
    unit = rng.choice([Fraction(1), Fraction(1, 2), Fraction(1, 1000), Fraction(1, 10**9)])
    count = rng.randint(6, 20)
    base = [rng.choice([1, 2, 3, 5, 7, 10, 48, 1000, 999983]) for _ in range(count)]
    first = [unit * b * rng.randint(1, 4) for b in base]
    second = [unit * b * rng.randint(1, 4) for b in base]
    return first, second


def main():
    driver, samples = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    rng = random.Random(2026)
    lines, expected = [], []
    for _ in range(samples):
        first, second = pairs_sample(rng)
        lines.append("pairs " + " ".join(f"{text_of(a)} {text_of(b)}" for a, b in zip(first, second)))
        expected.append(("pairs", signed_rank(first, second)))
    for _ in range(samples // 10):
        planners, repetitions, points = rng.randint(3, 6), rng.randint(1, 6), rng.randint(10, 15)
        cost = lambda: None if rng.random() < 0.1 else Fraction(rng.randint(1, 6))
        rows = [[[cost() for _ in range(repetitions)] for _ in range(planners)] for _ in range(points)]
        cells = " ".join(text_of(value) for row in rows for cell in row for value in cell)
        lines.append(f"ranks {planners} {repetitions} {cells}")
        expected.append(("ranks", mean_ranks(rows)))
    answer = subprocess.run([driver], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
    wrong = 0
    for line, (kind, want), got in zip(lines, expected, answer.stdout.splitlines(), strict=True):
        numbers = got.split()
        if kind == "pairs":
            statistic, p, order = want
            right = Fraction(numbers[0]) == statistic and [int(n) for n in numbers[2:]] == order
            right = right and abs(float(numbers[1]) - (-1 if p is None else float(p))) <= 1e-14
        else:
            right = all(abs(float(n) - float(rank)) <= 1e-12 for n, rank in zip(numbers, want, strict=True))
        if not right:
            wrong += 1
            if wrong <= 5:
                print(f"{line}\n  exact: {want}\n  program: {got}")
    print(f"{len(lines)} samples, {wrong} differ from exact arithmetic")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
