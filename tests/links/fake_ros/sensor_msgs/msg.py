import math
from types import SimpleNamespace


class BatteryState:
    KIND = "battery"

    @staticmethod
    def of(report):
        return SimpleNamespace(percentage=report["level"])


class LaserScan:
    KIND = "scan"

    @staticmethod
    def of(report):
        ahead = report["ahead"]
        return SimpleNamespace(
            angle_min=-math.pi / 2,
            angle_increment=math.pi / 180,
            range_min=0.1,
            range_max=8.0,
            ranges=[ahead] * 180 + [math.inf],
        )


class Range:
    KIND = "range"

    @staticmethod
    def of(report):
        header = SimpleNamespace(frame_id=report["frame"])
        return SimpleNamespace(header=header, range=report["range"], max_range=5.0)


class PointCloud:
    KIND = "points"

    @staticmethod
    def of(report):
        return SimpleNamespace(points=[SimpleNamespace(x=x, y=y) for x, y in report["points"]])
