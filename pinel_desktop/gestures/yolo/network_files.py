"""The network of a detector from an ONNX file, and what a network of any file offers."""

import ast
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import onnxruntime
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.networks import session_options

Array = NDArray[np.float32]

_SIDES = (32, 2048)  # px, of the input
_MAX_CLASSES = 1000
_MAX_NAME = 100  # characters, as in an answer of a capture
_FOLDER_OF_EXTERNAL_DATA = "session.model_external_initializers_file_folder_path"


class DetectorNetwork(Protocol):
    """The network of a detector: (1, 3, height, width) RGB in 0..1 -> (4 + classes, n)."""

    file: str
    names: tuple[str, ...]
    size: tuple[int, int]

    def __call__(self, batch: Array) -> Array: ...


class OnnxNetwork:
    """A network in ONNX Runtime, on one thread."""

    def __init__(
        self, file: str, session: onnxruntime.InferenceSession, metadata: Mapping[str, str]
    ) -> None:
        """Raises PinelError `detector_task_wrong`, `detector_shape_wrong`, `detector_names_missing`."""
        require_detection(file, metadata.get("task", "detect"))
        self.file = file
        self._session = session
        self.size, self._input = self._checked_input(metadata)
        self.names = checked_names(file, _literal(metadata.get("names", "")))

    def __call__(self, batch: Array) -> Array:
        try:
            outputs = self._session.run(None, {self._input: batch})
        except Exception as error:  # the runtime has no common class of its errors
            raise PinelError("detector_unreadable", file=self.file) from error
        output = np.asarray(outputs[0])
        return output[0] if output.ndim else output

    def _checked_input(self, metadata: Mapping[str, str]) -> tuple[tuple[int, int], str]:
        """Returns height and width, and the name of the input. Dynamic sides are those of the training."""
        inputs = self._session.get_inputs()
        shape = list(inputs[0].shape) if inputs else []
        sides = shape[2:]
        if any(not isinstance(side, int) for side in sides):
            sides = _literal(metadata.get("imgsz", "")) or []
        is_usable = (
            len(inputs) == 1
            and inputs[0].type == "tensor(float)"
            and len(shape) == 4
            and shape[1] == 3
            and shape[0] in (1, "batch", None)
            and are_sides(sides)
        )
        if not is_usable:
            raise PinelError(
                "detector_shape_wrong", file=self.file, shape="x".join(map(str, shape))
            )
        return (int(sides[0]), int(sides[1])), inputs[0].name


def open_onnx(path: Path) -> OnnxNetwork:
    """Opens an ONNX file that needs no other file.

    Raises:
        PinelError: `detector_unreadable`, `detector_not_alone` for external data or operators of its own, and the
            errors of `OnnxNetwork`.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise PinelError("detector_unreadable", file=path.name) from error
    # The runtime looks for external data in the working folder. An empty folder has none.
    with tempfile.TemporaryDirectory() as empty:
        options = session_options()
        options.add_session_config_entry(_FOLDER_OF_EXTERNAL_DATA, empty)
        options.log_severity_level = 4
        try:
            session = onnxruntime.InferenceSession(
                content, options, providers=["CPUExecutionProvider"]
            )
        except Exception as error:  # as above
            text = str(error).lower()
            is_alone = "external data" not in text and "not a registered" not in text
            code = "detector_unreadable" if is_alone else "detector_not_alone"
            raise PinelError(code, file=path.name) from error
    return OnnxNetwork(path.name, session, session.get_modelmeta().custom_metadata_map)


def require_detection(file: str, task: str) -> None:
    """Raises PinelError `detector_task_wrong` for the model of another task, such as `classify` or `segment`."""
    if task != "detect":
        raise PinelError("detector_task_wrong", file=file, task=task[:40])


def checked_names(file: str, names: Any) -> tuple[str, ...]:
    """Returns the names of the classes 0, 1, 2, ... from a mapping or a list.

    Raises:
        PinelError: `detector_names_missing`.
    """
    if isinstance(names, dict) and set(names) == set(range(len(names))):
        names = [names[number] for number in range(len(names))]
    if not isinstance(names, list) or not 1 <= len(names) <= _MAX_CLASSES:
        raise PinelError("detector_names_missing", file=file)
    texts = tuple(str(name).strip()[:_MAX_NAME] for name in names)
    if not all(texts) or len(set(texts)) != len(texts):
        raise PinelError("detector_names_missing", file=file)
    return texts


def are_sides(sides: Any) -> bool:
    """Returns whether these are height and width of a usable input, in px."""
    return (
        isinstance(sides, list | tuple)
        and len(sides) == 2
        and all(isinstance(side, int) and _SIDES[0] <= side <= _SIDES[1] for side in sides)
    )


def _literal(text: str) -> Any:
    """Reads a literal of Python, as ultralytics writes it, without evaluating anything; None if it is none."""
    try:
        return ast.literal_eval(text)
    except (ValueError, SyntaxError, RecursionError, MemoryError):
        return None
