from types import SimpleNamespace


class BatteryState:
    KIND = "battery"

    @staticmethod
    def of(report):
        return SimpleNamespace(percentage=report["level"])
