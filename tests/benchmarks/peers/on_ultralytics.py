"""YOLOv8n in ultralytics on PyTorch: detects in one picture after the other, on one thread, at 640 px.

The weights are random: what a layer costs does not depend on them, and none need to be downloaded. Protocol: the
first line is `{"pictures": FILE}`, an array (n, height, width, 3) of RGB pictures in a .npy file; for each further
line it detects in all of them and answers `{"seconds": [...]}`, processor time for each.
"""

import json
import os
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

SIDE = 640


def main() -> None:
    torch.set_num_threads(1)
    torch.manual_seed(0)
    # OpenCV's order of colours, as predict takes arrays
    pictures = np.load(json.loads(sys.stdin.readline())["pictures"])[..., ::-1]
    model = YOLO("yolov8n.yaml", verbose=False)

    def seconds(picture: np.ndarray) -> float:
        start_s = time.process_time()
        model.predict(picture, imgsz=SIDE, device="cpu", verbose=False)
        return time.process_time() - start_s

    contiguous = [np.ascontiguousarray(picture) for picture in pictures]
    for _ in sys.stdin:
        result = {"seconds": [seconds(picture) for picture in contiguous]}
        print(json.dumps(result), flush=True)


if __name__ == "__main__":
    main()
