"""Exudyn's implicit solver on its rigid body and distance constraints, from Python."""

import contextlib
import io
import math
import platform
import time
from importlib.metadata import version

import numpy as np

from . import engines, mechanism
from .mechanism import STEP, STEPS
from .table import Missing, measured, median_and_spread

try:
    import exudyn
    from exudyn.utilities import RigidBodyInertia, SensorBody, SensorObject
except ImportError:
    exudyn = None

RUNS = 9
MASS, INERTIA = 20.0, 0.3
GRAVITY = [0.0, 0.0, -9.81]
LAST, PAST_LOCK = STEPS * STEP, 2.1  # s
NOTE = "rods as distance constraints, height of point 6 prescribed; generalised alpha, index 3, default settings"


class Knuckle:
    """The mechanism from a row of `mechanism.starts`, in motion or under the load at rest."""

    def __init__(self, start, loaded=False):
        self.points = start[3:18].reshape(5, 3)
        speeds = np.zeros((5, 3)) if loaded else start[18:33].reshape(5, 3)
        self.system = exudyn.SystemContainer().AddSystem()
        self.body = self.system.CreateRigidBody(
            inertia=RigidBodyInertia(MASS, INERTIA * np.eye(3)),
            referencePosition=self.points[0],
            initialVelocity=speeds[0],
            initialAngularVelocity=_spin(self.points, speeds),
            gravity=[0.0, 0.0, 0.0] if loaded else GRAVITY,
        )
        self.links = [self._link(*link) for link in mechanism.LINKS[:5]]
        height = self.points[0, 2] - mechanism.CHASSIS["p1"][2]
        node = self.system.GetObject(self.body)["nodeNumber"]
        self.system.CreateCoordinateConstraint(
            itemNumbers=[None, node],
            coordinates=[None, 2],
            offsetUserFunction=0 if loaded else _raised(height),
        )

    def _link(self, chassis, point, length):
        local = self.points[int(point[1:]) - 6] - self.points[0]
        ends = {"localPosition0": mechanism.CHASSIS[chassis], "localPosition1": local}
        return self.system.CreateDistanceConstraint(
            itemNumbers=[self.system.CreateGround(), self.body], distance=length, **ends
        )

    def watch(self, kind):
        """A sensor of each of the five points."""
        for local in self.points - self.points[0]:
            sensor = SensorBody(
                bodyNumber=self.body, localPosition=local, outputVariableType=kind, storeInternal=True
            )
            yield self.system.AddSensor(sensor)

    def solve(self, last):
        self.system.Assemble()
        settings = exudyn.SimulationSettings()
        settings.timeIntegration.numberOfSteps = round(last / STEP)
        settings.timeIntegration.endTime = last
        settings.solutionSettings.writeSolutionToFile = False
        settings.solutionSettings.sensorsWritePeriod = STEP
        settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
        settings.timeIntegration.verboseMode = 0
        self.system.SolveDynamic(settings)


def _spin(points, speeds):
    """From the velocities of three points."""
    first, second = speeds[1] - speeds[0], speeds[2] - speeds[0]
    bottom = first @ (points[2] - points[0])
    return np.cross(first, second) / bottom if bottom else np.zeros(3)


def _raised(height):
    """How far point 6 is above where it was."""
    length = mechanism.DRIVEN_LENGTH
    c0, c1, c2 = mechanism.DRIVE

    def offset(_system, t, _item, _offset):
        return length * math.cos(c0 + (c1 + c2 * t) * t) - height

    return offset


def measure(scratch):
    if exudyn is None:
        raise Missing("exudyn cannot be imported")
    start = mechanism.starts()[0]
    time_a_step = median_and_spread([_clock(start) for _ in range(RUNS)])
    errors = mechanism.errors(_motions(start))
    np.array([_rods(row) for row in mechanism.starts()[mechanism.LOADED]]).tofile(scratch / engines.RODS)
    flags = f"wheel, Python {platform.python_version()}"
    found = version("exudyn")
    row = measured("Exudyn", found, flags, "step", time_a_step, errors, NOTE)
    yield from engines.all_at_once(engines.asked(row, scratch / engines.RODS, _past_lock(start)))


def _clock(start):
    """ns a step, without sensors."""
    knuckle = Knuckle(start)
    begin = time.perf_counter_ns()
    knuckle.solve(LAST)
    return (time.perf_counter_ns() - begin) / STEPS


def _motions(start):
    knuckle = Knuckle(start)
    kinds = exudyn.OutputVariableType
    order = (kinds.Position, kinds.Velocity, kinds.Acceleration)
    sensors = [sensor for kind in order for sensor in knuckle.watch(kind)]
    knuckle.solve(LAST)
    stored = [knuckle.system.GetSensorStoredData(sensor)[-STEPS:, 1:] for sensor in sensors]
    return np.hstack(stored)


def _rods(row):
    """Forces of the rods under the load, at rest for one step."""
    knuckle = Knuckle(row, loaded=True)
    centre = mechanism.wheel_centre(row[3:18])
    system = knuckle.system
    system.CreateForce(itemNumber=knuckle.body, localPosition=centre, loadVector=mechanism.LOAD)
    force = exudyn.OutputVariableType.Force
    sensors = [
        system.AddSensor(SensorObject(objectNumber=link, outputVariableType=force, storeInternal=True))
        for link in knuckle.links[1:]
    ]
    knuckle.solve(STEP)
    tensions = []
    for sensor, (chassis, point, length) in zip(sensors, mechanism.LINKS[1:]):
        along = (row[3:18][mechanism.unknown(point)] - mechanism.CHASSIS[chassis]) / length
        tensions.append(system.GetSensorStoredData(sensor)[-1, 1])
    return tensions


def _past_lock(start):
    knuckle = Knuckle(start)
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            knuckle.solve(PAST_LOCK)
    except exudyn.SolverError:
        return f"SolverError at t = {knuckle.system.systemData.GetTime():.3f} s"
    return "silent"
