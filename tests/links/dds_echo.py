"""Answers each Twist at once with an Odometry at `x` of its velocity: `python -m tests.links.dds_echo DOMAIN`."""

import sys

from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.util import duration

from pinel_desktop.links.dds import messages as m
from pinel_desktop.links.dds.session import Session


def main() -> None:
    session = Session(int(sys.argv[1]), ("127.0.0.1",))
    commands = session.reader("cmd_vel", m.Twist)
    odometry = session.writer("odom", m.Odometry)
    waiting = WaitSet(session.participant)
    new = ReadCondition(commands, SampleState.NotRead | ViewState.Any | InstanceState.Any)
    waiting.attach(new)
    print("ready", flush=True)
    while True:
        waiting.wait(duration(milliseconds=100))
        for sample in commands.take(4):
            if isinstance(sample, m.Twist):
                pose = m.Pose(m.Point(sample.linear.x))
                odometry.write(m.Odometry(pose=m.PoseWithCovariance(pose)))


if __name__ == "__main__":
    main()
