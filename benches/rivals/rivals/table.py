"""The table of results: a CSV that is whole after each row, and a readable print."""

import csv
from dataclasses import dataclass, fields

import numpy as np

QUANTITIES = {
    "newton": "one Newton iteration: residual, Jacobian, solve, update",
    "position": "1 ms step: position",
    "step": "1 ms step: position, velocity, acceleration",
}
ENGINE_COLUMNS = ["", "us", "x ours", "m", "m/s", "m/s^2", "rods, N", "past the lock", "how; flags"]
ACCURACY = (1e-14, 1e-11, 1e-8)
"""What a right result may be off by: m, m/s, m/s^2."""

HEADLINE = "headline"
"""How the note of a method's best variant begins."""


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
    error_rods_n: float | str = ""
    past_lock: str = ""
    note: str = ""

    def all_errors(self):
        motion = (self.error_position_m, self.error_velocity_m_s, self.error_acceleration_m_s2)
        return (*motion, self.error_rods_n)

    def errors(self):
        return [error for error in self.all_errors()[:3] if error != ""]

    def is_right(self):
        return all(error <= bound for error, bound in zip(self.errors(), ACCURACY))

    def remark(self):
        """What a reader must not miss."""
        if not self.is_right():
            return "  INACCURATE"
        return f"  <- {HEADLINE}" if self.note.startswith(HEADLINE) else ""

    def family(self):
        """The method without its variant."""
        return self.method.split(", ")[0]


class Table:
    def __init__(self, path):
        self.path = path
        self.rows = []
        self.write()

    def add(self, row):
        self.rows.append(row)
        self.write()

    def write(self):
        with self.path.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow([field.name for field in fields(Row)])
            for row in self.rows:
                writer.writerow([_figure(value) for value in vars(row).values()])

    def of(self, quantity):
        """Its rows, the fastest first."""
        rows = [row for row in self.rows if row.quantity == quantity]
        return sorted(rows, key=lambda row: row.nanoseconds)

    def missing(self):
        return [row for row in self.rows if row.nanoseconds == ""]

    def print(self):
        for quantity, meaning in QUANTITIES.items():
            rows = self.of(quantity)
            if not rows:
                continue
            print(f"\n{quantity}: {meaning}")
            print(f"  {'ns':>11} {'spread':>9} {'x ours':>8}  {'errors: m, m/s, m/s^2':<24}  method, flags")
            for row in rows:
                errors = " ".join(f"{error:7.0e}" for error in row.errors())
                figures = f"{row.nanoseconds:11.1f} {row.spread_ns:9.1f} {_ratio(row, rows):>8}  {errors:<24}"
                print(f"  {figures}  {row.method}, {row.flags}{row.remark()}")
        print("\nx ours: time over that of the fastest of ours")
        for row in self.missing():
            print(f"not measured: {row.method}: {row.note}")

    def markdown(self, heading):
        """The fastest right variant of each method, and what could not be measured."""
        lines = [f"{heading}", ""]
        lines += ["| | method | ns | x ours | errors: m, m/s, m/s^2 | flags |", "| --- " * 6 + "|"]
        for quantity in QUANTITIES:
            best = {}
            rows = self.of(quantity)
            for row in rows:
                if row.is_right() and not row.past_lock:
                    best.setdefault(row.family(), row)
            for row in best.values():
                errors = ", ".join(f"{error:.0e}" for error in row.errors())
                figures = f"{row.nanoseconds:,.0f} | {_ratio(row, rows)} | {errors}"
                lines.append(f"| `{quantity}` | {row.method} {row.version} | {figures} | {row.flags} |")
        lines += ["", *(f"Not measured: {row.note}." for row in self.missing())]
        return "\n".join(lines).rstrip() + "\n"

    def engines(self, heading):
        """General multibody engines, and ours in the same run: of each method the fastest build."""
        lines = [f"{heading}", ""]
        lines += [f"| {' | '.join(ENGINE_COLUMNS)} |", "| --- " * len(ENGINE_COLUMNS) + "|"]
        rows = self.of("step")
        fastest = {}
        for row in rows:
            if row.past_lock:
                fastest.setdefault(row.method, row)
        for row in fastest.values():
            errors = " | ".join(f"{error:.0e}" if error != "" else "" for error in row.all_errors())
            name = f"{row.method} {row.version}"
            time = f"{row.nanoseconds / 1000:.2f} | {_ratio(row, rows)}"
            lines.append(f"| {name} | {time} | {errors} | {row.past_lock} | {row.note}; {row.flags} |")
        return "\n".join(lines) + "\n"


def _ratio(row, rows):
    ours = min((r.nanoseconds for r in rows if r.family() == "ours"), default=None)
    return f"{row.nanoseconds / ours:.2f}" if ours else ""


def measured(method, version, flags, quantity, time, errors, note):
    """A row; `time` is median and spread in ns, `errors` what was computed of position and rates."""
    known = [*(float(error) for error in errors), "", "", ""][:3]
    step = 0.001
    return Row(method, version, flags, quantity, step, *time, *known, note=note)


def median_and_spread(batches):
    """Median and interquartile range."""
    low, middle, high = np.percentile(batches, [25, 50, 75])
    return float(middle), float(high - low)


def _figure(value):
    return f"{value:.4g}" if isinstance(value, float) else value
