"""Subscribes to the poses of a robot's own localisation and writes them as lines for the app (`node.py`)."""

from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped

KINDS = (
    ("geometry_msgs/msg/PoseWithCovarianceStamped", PoseWithCovarianceStamped),
    ("geometry_msgs/msg/PoseStamped", PoseStamped),
)
X, Y, YAW = 0, 7, 35  # places of the variances in a covariance of six rows


class Localisation:
    """The subscription, made once the robot publishes the topic; none without a topic in the configuration."""

    def __init__(self, node, configuration, outbox, quality):
        self._node, self._outbox, self._quality = node, outbox, quality
        topic = configuration.get("localisation_topic")
        self._waits_for = "/" + topic if topic else None

    def poll(self):
        """Subscribes to the topic if it is new."""
        topic = self._waits_for
        if topic is None:
            return
        types = {endpoint.topic_type for endpoint in self._node.get_publishers_info_by_topic(topic)}
        kind = next((kind for name, kind in KINDS if name in types), None)
        if kind is not None:
            self._waits_for = None
            self._node.create_subscription(kind, topic, self._receive, self._quality)

    def _receive(self, message):
        pose, variances = message.pose, None
        if hasattr(pose, "covariance"):
            variances = [float(pose.covariance[place]) for place in (X, Y, YAW)]
            pose = pose.pose
        q, header = pose.orientation, message.header
        self._outbox.put(
            "localised",
            position=[pose.position.x, pose.position.y],
            orientation=[q.x, q.y, q.z, q.w],
            variances=variances,
            stamp=header.stamp.sec + header.stamp.nanosec * 1e-9,
            frame=header.frame_id,
        )
