"""Learns the errors of one robot from its runs. Pure, but for `recorded.py`, which reads the store."""

from pinel_desktop.calibration.drive import Drive
from pinel_desktop.calibration.estimate import Estimate
from pinel_desktop.calibration.robot import Calibration, calibrate
from pinel_desktop.calibration.umbmark import SquareErrors, umbmark

__all__ = ["Calibration", "Drive", "Estimate", "SquareErrors", "calibrate", "umbmark"]
