"""Learns the errors of one robot from its runs. Pure: numpy only."""

from pinel_desktop.calibration.drive import Drive, TruePose
from pinel_desktop.calibration.estimate import Estimate
from pinel_desktop.calibration.robot import Calibration, calibrate
from pinel_desktop.calibration.umbmark import SquareErrors, umbmark

__all__ = ["Calibration", "Drive", "Estimate", "SquareErrors", "TruePose", "calibrate", "umbmark"]
