from types import SimpleNamespace


class Bool:
    KIND = "bumper"

    @staticmethod
    def of(report):
        return SimpleNamespace(data=report["pressed"])
