import math
from types import SimpleNamespace


def header():
    return SimpleNamespace(stamp=SimpleNamespace(sec=0, nanosec=0), frame_id="")


def pose(report):
    x, y, yaw, *_ = report["pose"]
    return SimpleNamespace(
        position=SimpleNamespace(x=x, y=y),
        orientation=SimpleNamespace(x=0.0, y=0.0, z=math.sin(yaw / 2), w=math.cos(yaw / 2)),
    )


def header_of(report):
    stamp = report["pose"][5]
    one = header()
    one.stamp = SimpleNamespace(sec=int(stamp), nanosec=int(stamp % 1 * 1e9))
    one.frame_id = report["pose"][6]
    return one


class Twist:
    def __init__(self):
        self.linear, self.angular = SimpleNamespace(x=0.0), SimpleNamespace(z=0.0)


class TwistStamped:
    def __init__(self):
        self.header, self.twist = header(), Twist()


class PoseStamped:
    KIND = "odometry"

    @staticmethod
    def of(report):
        return SimpleNamespace(pose=pose(report), header=header_of(report))


class PoseWithCovarianceStamped:
    KIND = "localised"

    @staticmethod
    def of(report):
        covariance = [0.0] * 36
        covariance[0] = covariance[7] = 0.0004
        inner = SimpleNamespace(pose=pose(report), covariance=covariance)
        return SimpleNamespace(pose=inner, header=header_of(report))
