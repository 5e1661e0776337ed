"""Suspension Explorer (formerly open-kinematics)."""

from .table import Missing


def measure(_scratch):
    raise Missing(
        "Suspension Explorer is neither on PyPI nor on npm (the PyPI package `kinematics` is another's); "
        "it drives the wheel's height, not a link's angle"
    )
