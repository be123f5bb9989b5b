"""YOLOv8n in ultralytics: detects in one picture after the other, on one thread; on PyTorch at 640 px.

The weights are random: what a layer costs does not depend on them, and none need to be downloaded. Protocol: the
first line is `{"pictures": FILE}`, an array (n, height, width, 3) of RGB pictures in a .npy file; for each further
line it detects in all of them and answers `{"seconds": [...]}`, processor time for each. With `{"onnx": FILE,
"packages": FOLDER}` as well, it writes its network to an ONNX file for 320 px first, and detects with that; onnx and
onnxruntime are in the folder.
"""

import contextlib
import json
import os
import site
import sys
import tempfile
import time

os.environ |= {"YOLO_OFFLINE": "true", "YOLO_AUTOINSTALL": "false", "YOLO_VERBOSE": "false"}
os.environ["YOLO_CONFIG_DIR"] = tempfile.mkdtemp()

import numpy as np
import torch

# PyPI's torchvision has no operators for PyTorch's build without CUDA: it wants to find them, and detection needs none
OPERATORS = torch.library.Library("torchvision", "DEF")
for name in ("nms", "qnms"):
    OPERATORS.define(f"{name}(Tensor dets, Tensor scores, float iou_threshold) -> Tensor")

from ultralytics import YOLO  # noqa: E402 - see above

SIDE, SIDE_OF_ONNX = 640, 320


def exported(model: YOLO, file: str) -> YOLO:
    """The same network from an ONNX file, which it writes. Its messages do not mix with the answers."""
    os.chdir(os.path.dirname(file))
    with contextlib.redirect_stdout(sys.stderr):
        written = model.export(format="onnx", imgsz=SIDE_OF_ONNX, simplify=False, opset=17)
        os.replace(written, file)
        return YOLO(file, task="detect", verbose=False)


def main() -> None:
    torch.set_num_threads(1)
    torch.manual_seed(0)
    request = json.loads(sys.stdin.readline())
    # OpenCV's order of colours, as predict takes arrays
    pictures = np.load(request["pictures"])[..., ::-1]
    model, side = YOLO("yolov8n.yaml", verbose=False), SIDE
    if "onnx" in request:
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})  # one thread of ONNX Runtime
        site.addsitedir(request["packages"])
        model, side = exported(model, request["onnx"]), SIDE_OF_ONNX

    def seconds(picture: np.ndarray) -> float:
        start_s = time.process_time()
        model.predict(picture, imgsz=side, device="cpu", verbose=False)
        return time.process_time() - start_s

    contiguous = [np.ascontiguousarray(picture) for picture in pictures]
    for _ in sys.stdin:
        result = {"seconds": [seconds(picture) for picture in contiguous]}
        print(json.dumps(result), flush=True)


if __name__ == "__main__":
    main()
