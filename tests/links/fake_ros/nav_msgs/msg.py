from types import SimpleNamespace

from geometry_msgs.msg import header_of, pose


class Odometry:
    KIND = "odometry"

    @staticmethod
    def of(report):
        _, _, _, v, omega, *_ = report["pose"]
        twist = SimpleNamespace(linear=SimpleNamespace(x=v), angular=SimpleNamespace(z=omega))
        return SimpleNamespace(
            pose=SimpleNamespace(pose=pose(report)),
            twist=SimpleNamespace(twist=twist),
            header=header_of(report),
        )
