"""A small detector in place of a trained one: real ONNX, whose class is the colour that prevails in the picture.

Red is "A" and green is "B", in a box in the middle; a grey picture shows nothing.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import onnx
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper

SIDE = 64
BOX = (32.0, 24.0, 40.0, 30.0)  # centre x, y, width, height in px of the input
METADATA = {"task": "detect", "names": "{0: 'A', 1: 'B'}", "imgsz": f"[{SIDE}, {SIDE}]"}
RED, GREEN, GREY = (250, 20, 20), (20, 250, 20), (110, 110, 110)


def model(
    metadata: Mapping[str, str] = METADATA,
    *,
    shape: Sequence[int | str] = (1, 3, SIDE, SIDE),
    box: Sequence[float] = BOX,
    operator: str = "",
    input_type: int = TensorProto.FLOAT,
) -> onnx.ModelProto:
    """Returns the detector: scores are (mean of red - mean of blue) and (mean of green - mean of blue), at least 0.

    Args:
        operator: domain of an operator of its own; "" for none.
    """
    numbers: dict[str, Any] = {
        "box": np.array(box, np.float32).reshape(1, 4, 1),
        "colours": np.array([[1, 0, -1], [0, 1, -1]], np.float32).reshape(2, 3, 1, 1),
        "flat": np.array([1, 2, 1], np.int64),
    }
    nodes = [
        helper.make_node("GlobalAveragePool", ["images"], ["means"]),
        helper.make_node("Conv", ["means", "colours"], ["differences"]),
        helper.make_node("Relu", ["differences"], ["positive"]),
        helper.make_node("Reshape", ["positive", "flat"], ["scores"]),
        helper.make_node("Concat", ["box", "scores"], ["joined"], axis=1),
        helper.make_node(
            "Identity" if not operator else "Own", ["joined"], ["output0"], domain=operator
        ),
    ]
    graph = helper.make_graph(
        nodes,
        "colours",
        [helper.make_tensor_value_info("images", input_type, list(shape))],
        [helper.make_tensor_value_info("output0", TensorProto.FLOAT, [1, 6, 1])],
        [numpy_helper.from_array(values, name) for name, values in numbers.items()],
    )
    opsets = [
        helper.make_opsetid("", 17),
        *([helper.make_opsetid(operator, 1)] if operator else []),
    ]
    made = helper.make_model(graph, opset_imports=opsets, ir_version=8)
    helper.set_model_props(made, dict(metadata))
    return made


def write_detector(path: Path, made: onnx.ModelProto | None = None) -> Path:
    """Writes a detector, by default the one of `model`; returns the path."""
    path.write_bytes((made or model()).SerializeToString())
    return path


def coloured(
    colour: tuple[int, int, int], width: int = 320, height: int = 240
) -> NDArray[np.uint8]:
    """Returns a picture of one colour, RGB."""
    return np.full((height, width, 3), colour, np.uint8)


def write_pictures(folder: Path, colour: tuple[int, int, int], n: int = 3) -> Path:
    """Writes pictures of one colour, which stand in for a webcam; returns their folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for number in range(n):
        cv2.imwrite(str(folder / f"{number}.png"), coloured(colour)[:, :, ::-1])
    return folder
