"""Detectors that the teacher puts on this PC, in place of the landmarks, and which of them reads the signs."""

import contextlib
import re
import shutil
import unicodedata
from pathlib import Path

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LANDMARKS, YOLO
from pinel_desktop.gestures.yolo.address import check_file
from pinel_desktop.settings import RECOGNIZER, Settings
from storage.file.atomic_files import atomic_write

ENDING = ".onnx"  # a `.pt` file needs PyTorch, which the package does not have
_LOAD_S = 30.0
_MAX_NAME = 60


class Detectors:
    """The detector files of this PC, in one folder; their names are without ending.

    Args:
        command: recognizer of the command line, which counts in place of the setting; None without one.
    """

    def __init__(
        self, folder: Path, settings: Settings, camera: CameraClient, command: str | None
    ) -> None:
        self._folder, self._settings, self._camera = folder, settings, camera
        self.command = command
        camera.set_recognizer(command or self._address(settings[RECOGNIZER]))

    @property
    def chosen(self) -> str:
        """Name of the chosen detector; "" for the landmarks."""
        return self._settings[RECOGNIZER]

    @property
    def in_use(self) -> str:
        """Name of the detector that reads the signs; "" while the landmarks do."""
        name = self._camera.recognizer.in_use
        return "" if name == LANDMARKS else Path(name).stem

    def names(self) -> list[str]:
        """Returns the names of all detectors, sorted."""
        with contextlib.suppress(OSError):
            return sorted(file.stem for file in self._folder.glob(f"*{ENDING}") if file.is_file())
        return []

    def wait_until_known(self) -> None:
        """Waits until the camera has loaded the chosen detector, or has found that it cannot."""
        if self._camera.recognizer.name != LANDMARKS:
            self._camera.wait_for_recognizer(_LOAD_S)

    def choose(self, name: str) -> None:
        """Reads signs with a detector, from now on; "" stands for the landmarks. Waits until it is loaded.

        Raises:
            PinelError: `recognizer_of_command`, or why it cannot be used; the one before then stays.
        """
        self._require_choice()
        if name and name not in self.names():
            raise PinelError("detector_missing", file=f"{name}{ENDING}")
        self._load(self._address(name))
        self._settings.choose(RECOGNIZER, name)

    def add(self, upload: Path, file_name: str) -> str:
        """Moves a detector file into the folder and chooses it; returns its name.

        Raises:
            PinelError: as `choose`; the file is then not kept, and one of the same name stays.
        """
        self._require_choice()
        if not file_name.lower().endswith(ENDING):
            raise PinelError("detector_type_wrong", file=file_name, allowed=ENDING)
        name = _as_name(file_name)
        tried = upload.rename(upload.with_name(f"{name}{ENDING}"))
        check_file(tried)
        self._load(f"{YOLO}:{tried}")
        target = self._folder / tried.name
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            with atomic_write(target) as part:
                shutil.copyfile(tried, part)
        except OSError as error:
            self._camera.set_recognizer(self._address(self.chosen))
            raise PinelError("export_failed", path=str(target)) from error
        self.choose(name)
        return name

    def remove(self, name: str) -> None:
        """Deletes a detector; if it was chosen, the landmarks read the signs again."""
        if name not in self.names():
            raise PinelError("detector_missing", file=f"{name}{ENDING}")
        if name == self.chosen:
            self.choose("")
        with contextlib.suppress(OSError):
            (self._folder / f"{name}{ENDING}").unlink(missing_ok=True)

    def _address(self, name: str) -> str:
        return f"{YOLO}:{self._folder / f'{name}{ENDING}'}" if name else LANDMARKS

    def _require_choice(self) -> None:
        """Raises PinelError `recognizer_of_command`."""
        if self.command is not None:
            raise PinelError("recognizer_of_command", name=self.command)

    def _load(self, address: str) -> None:
        """Makes the camera load a recognizer. Raises PinelError if it cannot; the chosen one then reads on."""
        self._camera.set_recognizer(address)
        if address == LANDMARKS:
            return
        state = self._camera.wait_for_recognizer(_LOAD_S)
        if state.is_loaded and not state.problem:
            return
        self._camera.set_recognizer(self._address(self.chosen))
        raise state.problem or PinelError("recognizer_slow", name=Path(address).name)


def _as_name(file_name: str) -> str:
    """Returns the file's name without folder, ending, accents and other signs."""
    plain = unicodedata.normalize("NFKD", Path(file_name).stem).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9_-]+", "-", plain).strip("-")[:_MAX_NAME] or "detector"
