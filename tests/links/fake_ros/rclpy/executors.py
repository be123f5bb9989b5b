import threading


class SingleThreadedExecutor:
    def __init__(self, *, context):
        self._ended = threading.Event()

    def add_node(self, node):
        pass

    def spin(self):
        self._ended.wait()

    def shutdown(self):
        self._ended.set()
