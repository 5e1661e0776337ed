"""The table of results: a CSV that is whole after each row, and a readable print."""

import csv
from dataclasses import dataclass, fields

import numpy as np

QUANTITIES = {
    "newton": "one Newton iteration: residual, Jacobian, solve, update",
    "position": "1 ms step: position",
    "step": "1 ms step: position, velocity, acceleration",
}
ACCURACY = (1e-14, 1e-11, 1e-8)
"""What a right result may be off by: m, m/s, m/s^2."""


class Missing(Exception):
    """A rival that this machine does not have, and why."""


@dataclass
class Row:
    method: str
    version: str = ""
    flags: str = ""
    quantity: str = ""
    step_s: float | str = ""
    nanoseconds: float | str = ""
    spread_ns: float | str = ""
    error_position_m: float | str = ""
    error_velocity_m_s: float | str = ""
    error_acceleration_m_s2: float | str = ""
    note: str = ""

    def errors(self):
        found = (self.error_position_m, self.error_velocity_m_s, self.error_acceleration_m_s2)
        return [error for error in found if error != ""]

    def is_right(self):
        return all(error <= bound for error, bound in zip(self.errors(), ACCURACY))


class Table:
    def __init__(self, path):
        self.path = path
        self.rows = []

    def add(self, row):
        self.rows.append(row)
        self.write()

    def write(self):
        with self.path.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow([field.name for field in fields(Row)])
            for row in self.rows:
                writer.writerow([_figure(value) for value in vars(row).values()])

    def print(self):
        for quantity, meaning in QUANTITIES.items():
            rows = sorted((r for r in self.rows if r.quantity == quantity), key=lambda r: r.nanoseconds)
            if rows:
                self._print_quantity(f"{quantity}: {meaning}", rows)
        missing = [row for row in self.rows if row.nanoseconds == ""]
        if missing:
            print("\nnot measured")
        for row in missing:
            print(f"  {row.method}: {row.note}")

    @staticmethod
    def _print_quantity(heading, rows):
        ours = min((r.nanoseconds for r in rows if r.method.startswith("ours")), default=None)
        print(f"\n{heading}")
        print(f"  {'ns':>11} {'spread':>9} {'x ours':>8}  {'errors: m, m/s, m/s^2':<24}  method, flags")
        for row in rows:
            ratio = f"{row.nanoseconds / ours:8.2f}" if ours else " " * 8
            errors = " ".join(f"{error:7.0e}" for error in row.errors())
            wrong = "" if row.is_right() else "  INACCURATE"
            figures = f"{row.nanoseconds:11.1f} {row.spread_ns:9.1f} {ratio}  {errors:<24}"
            print(f"  {figures}  {row.method}, {row.flags}{wrong}")
        print("  x ours: time over that of ours in its fastest build")


def measured(method, version, flags, quantity, time, errors, note):
    """A row; `time` is median and spread in ns, `errors` what was computed of position and rates."""
    known = [*(float(error) for error in errors), "", "", ""][:3]
    step = 0.001
    return Row(method, version, flags, quantity, step, *time, *known, note)


def median_and_spread(batches):
    """Median and interquartile range."""
    low, middle, high = np.percentile(batches, [25, 50, 75])
    return float(middle), float(high - low)


def _figure(value):
    return f"{value:.4g}" if isinstance(value, float) else value
