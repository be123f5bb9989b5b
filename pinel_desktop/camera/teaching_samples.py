"""Training samples for `pinel gestures teach`, without the app: from pictures, or from a camera."""

import base64
import time
from pathlib import Path

from pinel_desktop.camera.frame_analyzer import FrameAnalyzer
from pinel_desktop.camera.sign_training import MovementCollector, SampleCollector, pack
from pinel_desktop.camera.source import CameraSource
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.pictures import read_picture
from pinel_desktop.gestures.recognition import LandmarkRecognizer

_TIMEOUT_S = 15.0  # without a sample
_FRAME_S = 0.5


def sample_of_picture(recognizer: LandmarkRecognizer, path: Path, aspect: float | None) -> bytes:
    """Returns the only hand of a picture, encoded as in the store.

    Args:
        aspect: width divided by height of the picture before it was stretched; None if it was not stretched.

    Raises:
        PinelError: the picture cannot be read; `teach_hand_missing` if it shows no hand, or two.
    """
    hands = recognizer.read(read_picture(path, aspect))
    features = hands[0].features if len(hands) == 1 else None
    packed = pack(features) if features is not None else None
    if packed is None:
        raise PinelError("teach_hand_missing", file=str(path))
    return base64.b64decode(packed)


def samples_of_camera(source: str, n_samples: int, *, is_moving: bool) -> list[bytes]:
    """Records hands at rest, or movements, encoded as in the store. Blocks until a person has shown all of them.

    Args:
        source: address of the camera, as for `camera.frames.open_reader`.

    Raises:
        PinelError: the camera's problem; `sign_recording_stopped` or `movement_recording_stopped` after `_TIMEOUT_S`
            without a sample.
    """
    analyzer = FrameAnalyzer(LandmarkRecognizer())
    collector = MovementCollector() if is_moving else SampleCollector()
    camera = CameraSource(source)
    samples: list[bytes] = []
    last_frame_s, last_sample_s = 0.0, time.monotonic()
    try:
        while len(samples) < n_samples:
            if problem := camera.problem:
                raise problem
            if time.monotonic() - last_sample_s > _TIMEOUT_S:
                kind = "movement" if is_moving else "sign"
                raise PinelError(f"{kind}_recording_stopped")
            frame = camera.next_frame(last_frame_s, _FRAME_S)
            if frame is None:
                continue
            last_frame_s = frame.time_s
            if sample := collector.update(frame.time_s, analyzer.analyze(frame.raw)):
                samples.append(base64.b64decode(sample))
                last_sample_s = time.monotonic()
    finally:
        camera.close()
    return samples
