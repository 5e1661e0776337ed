"""Pinocchio in C++, from the headers of its wheel."""

import sysconfig
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from . import engines
from .eigen import INCLUDE
from .table import Missing

HEADERS = Path(sysconfig.get_path("purelib")) / "cmeel.prefix/include"
# As the wheel's CMake package has them: it knows more kinds of joints than Boost's default lists hold.
LIMITS = {
    "BOOST_MPL_LIMIT_LIST_SIZE": 30,
    "BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS": None,
    "BOOST_FUSION_INVOKE_MAX_ARITY": 10,
}


def measure(scratch):
    try:
        found = version("pin")
    except PackageNotFoundError as reason:
        raise Missing("pin is not installed") from reason
    if not INCLUDE.exists():
        raise Missing("Eigen is not installed (apt-get install libeigen3-dev)")
    headers = ["-isystem", HEADERS, "-isystem", INCLUDE]
    program, flags = engines.compiled(scratch, "pinocchio.cpp", headers, LIMITS)
    note = "driven link and knuckle a tree of joints; four rods closed by our Newton on its Jacobians"
    yield engines.row(scratch, [program], "Pinocchio", found, flags, note)
