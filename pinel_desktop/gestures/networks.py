"""MediaPipe's two hand networks as ONNX files, run with ONNX Runtime.

Set-up writes the files (scripts/hand_models). A file is opened only if it has the checksum of the tested file.
"""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import onnxruntime
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError

FOLDER = Path(__file__).parent / "weights"
Array = NDArray[np.float32]


@dataclass(frozen=True)
class NetworkFile:
    """A file in FOLDER and its SHA-256."""

    name: str
    sha256: str


PALM = NetworkFile("palm.onnx", "c06940aaf6159abfdf201c6cd01a0cf63d9567c18cb87dea335e9f6426cbcf4e")
HAND = NetworkFile("hand.onnx", "1216d7ec34812031e2b8c7ef11a9c1a7927e409284dd09f52d796cd43c121e3e")


class Network:
    """One network, computed on the calling thread alone."""

    def __init__(self, file: NetworkFile, folder: Path = FOLDER) -> None:
        """Raises PinelError: `gesture_model_missing`, `gesture_model_damaged`."""
        self._session = onnxruntime.InferenceSession(
            checked(file, folder), session_options(), providers=["CPUExecutionProvider"]
        )
        self._input: str = self._session.get_inputs()[0].name

    def __call__(self, picture: NDArray[np.uint8]) -> Sequence[Array]:
        """Returns the outputs for one RGB picture (height, width, 3) with the network's input size."""
        batch = picture[None].astype(np.float32) / 255
        outputs: Sequence[Array] = self._session.run(None, {self._input: batch})
        return [output[0] for output in outputs]


def session_options() -> onnxruntime.SessionOptions:
    """Returns options for a network on the calling thread alone: spinning worker threads would slow other programs."""
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    options.inter_op_num_threads = 1
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    return options


def checked(file: NetworkFile, folder: Path = FOLDER) -> bytes:
    """Returns the content of a network's file. Raises PinelError if the file is missing or has another checksum."""
    path = folder / file.name
    try:
        content = path.read_bytes()
    except OSError as error:
        raise PinelError("gesture_model_missing", file=str(path)) from error
    if hashlib.sha256(content).hexdigest() != file.sha256:
        raise PinelError("gesture_model_damaged", file=str(path))
    return content
