"""A YOLO detector as a recognizer: it finds hands and their signs in one pass, without landmarks."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.classifier import SignPrediction
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.recognizer import MAX_SIGNS, RecognizedSign
from pinel_desktop.gestures.yolo.address import check_file
from pinel_desktop.gestures.yolo.network_files import DetectorNetwork, open_onnx
from pinel_desktop.gestures.yolo.torch_file import open_pt

# Below the first score a box counts as no hand. From the second score on, its sign answers a capture.
MIN_SCORE, SURE_SCORE = 0.25, 0.5
# The second sign at the same place must have a score lower by this margin.
MIN_MARGIN = 0.2
_MIN_CONFIDENCE = 0.6  # the scores are not calibrated and stay below those of the landmarks
_MAX_OVERLAP = 0.5  # intersection over union; boxes that overlap more show the same hand
_GREY = 114  # of the border, as in training

Array = NDArray[np.float32]


class YoloDetector:
    """Detects signs with a network of ultralytics' YOLO (v8 and later, task `detect`, without built-in suppression)."""

    min_confidence = _MIN_CONFIDENCE

    def __init__(self, network: DetectorNetwork) -> None:
        """Tries the network once. Raises PinelError `detector_shape_wrong`, `detector_output_invalid`."""
        self._network = network
        height, width = network.size
        blank = np.full((height, width, 3), _GREY, np.uint8)
        output = self._output(blank)
        if output.ndim != 2 or output.shape[0] != 4 + len(network.names):
            raise PinelError(
                "detector_shape_wrong", file=network.file, shape="x".join(map(str, output.shape))
            )
        if not np.isfinite(output).all():
            raise PinelError("detector_output_invalid", file=network.file)

    @property
    def signs(self) -> tuple[str, ...]:
        """Names of the classes, from the file."""
        return self._network.names

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the input, in px."""
        return self._network.size

    def read(self, picture: Picture) -> list[RecognizedSign]:
        """Returns the signs of one unstretched RGB picture (height, width, 3), at most two, the best first."""
        letterboxed, scale, offset = letterbox(picture, self._network.size)
        boxes, scores = self._detections(self._output(letterboxed))
        return [
            RecognizedSign(_in_picture(box, scale, offset, picture), self._prediction(score))
            for box, score in zip(boxes, scores, strict=True)
        ]

    def track(self, picture: Picture, *, both: bool = False) -> list[RecognizedSign]:
        """Returns the signs of the next frame of a video; each frame is read alone."""
        return self.read(picture)

    def reset_tracking(self) -> None:
        """Does nothing: each frame is read alone."""

    def _output(self, letterboxed: Picture) -> Array:
        batch = letterboxed.transpose(2, 0, 1)[None].astype(np.float32) / 255
        return self._network(np.ascontiguousarray(batch))

    def _detections(self, output: Array) -> tuple[Array, Array]:
        """Returns the best boxes (k, 4) as left, top, right, bottom in px of the input, and their scores (k, classes).

        Suppresses overlapping boxes of any class, because one hand shows one sign.
        """
        rows = output.T
        rows = rows[np.isfinite(rows).all(axis=1)]
        rows = rows[rows[:, 4:].max(axis=1, initial=0.0) >= MIN_SCORE]
        corner = rows[:, :2] - rows[:, 2:4] / 2
        best = rows[:, 4:].max(axis=1, initial=0.0)
        kept = cv2.dnn.NMSBoxes(
            np.hstack([corner, rows[:, 2:4]]).tolist(), best.tolist(), MIN_SCORE, _MAX_OVERLAP
        )
        chosen = np.array(kept, np.int64).reshape(-1)[:MAX_SIGNS]
        return np.hstack([corner, corner + rows[:, 2:4]])[chosen], rows[chosen, 4:]

    def _prediction(self, scores: Array) -> SignPrediction:
        """Returns the prediction for the scores (classes,) of one box; a detector of one class has no second sign."""
        best, *others = np.argsort(scores)[::-1][:2]
        second = float(scores[others[0]]) if others else 0.0
        confidence = float(min(scores[best], 1.0))
        is_sure = confidence >= SURE_SCORE and confidence - second >= MIN_MARGIN
        return SignPrediction(
            sign=self.signs[best] if is_sure else None,
            best=self.signs[best],
            confidence=confidence,
            second=self.signs[others[0]] if others else "",
            second_confidence=second,
        )


def open_detector(path: Path) -> YoloDetector:
    """Opens a detector: ONNX, or ultralytics' `.pt`, which needs the extra `yolo`.

    Raises:
        PinelError: as `check_file`, `open_onnx`, `open_pt` and `YoloDetector`: why the file cannot be used.
    """
    check_file(path)
    return YoloDetector(open_onnx(path) if path.suffix.lower() == ".onnx" else open_pt(path))


def letterbox(picture: Picture, size: tuple[int, int]) -> tuple[Picture, float, tuple[int, int]]:
    """Fits a picture into a size (height, width) with its own aspect; fills the rest with grey.

    Returns the fitted picture, its scale, and the offset (x, y) of its corner in px.
    """
    height, width = picture.shape[:2]
    scale = min(size[0] / height, size[1] / width)
    inner_width, inner_height = max(1, round(width * scale)), max(1, round(height * scale))
    x, y = (size[1] - inner_width) // 2, (size[0] - inner_height) // 2
    fitted = np.full((*size, 3), _GREY, np.uint8)
    fitted[y : y + inner_height, x : x + inner_width] = cv2.resize(
        picture, (inner_width, inner_height), interpolation=cv2.INTER_LINEAR
    )
    return fitted, scale, (x, y)


def _in_picture(
    box: Array, scale: float, offset: tuple[int, int], picture: Picture
) -> tuple[float, float, float, float]:
    """Converts a box from px of the input to px of the picture, and cuts it at the picture's edges."""
    height, width = picture.shape[:2]
    x = np.clip((box[[0, 2]] - offset[0]) / scale, 0, width)
    y = np.clip((box[[1, 3]] - offset[1]) / scale, 0, height)
    return float(x[0]), float(y[0]), float(x[1]), float(y[1])
