"""Opens `.pt` files of many kinds with PyTorch, as a program of its own: prints a code for each, as JSON.

Arguments: a folder for the files, and the folder of the installed PyTorch and ultralytics.
"""

import json
import os
import pickle
import site
import sys
from pathlib import Path

folder = Path(sys.argv[1])
site.addsitedir(sys.argv[2])
os.chdir(folder)

import torch  # noqa: E402 - found above

from pinel_desktop.errors import PinelError  # noqa: E402
from pinel_desktop.gestures.yolo.detector import open_detector  # noqa: E402
from pinel_desktop.gestures.yolo.torch_file import prepare_ultralytics  # noqa: E402

prepare_ultralytics()
# PyTorch's build without CUDA has no operators of torchvision; none is needed to open a file
OPERATORS = torch.library.Library("torchvision", "DEF")
for operator in ("nms", "qnms"):
    OPERATORS.define(f"{operator}(Tensor dets, Tensor scores, float iou_threshold) -> Tensor")

from ultralytics.nn.tasks import DetectionModel  # noqa: E402


class Command:
    """Runs a command of the system when it is unpickled."""

    def __reduce__(self) -> tuple[object, ...]:
        return os.system, ("touch executed",)


class Expression:
    """Evaluates an expression when it is unpickled."""

    def __reduce__(self) -> tuple[object, ...]:
        return eval, ("open('executed', 'w')",)


def detector(**attributes: object) -> DetectionModel:
    made = DetectionModel("yolov8n.yaml", nc=2, verbose=False)
    for name, value in {"names": {0: "A", 1: "B"}, "task": "detect", **attributes}.items():
        setattr(made, name, value)
    return made


torch.save({"model": detector(), "train_args": {"imgsz": 64}}, "usable.pt")
torch.save({"model": Command()}, "command.pt")
torch.save({"model": detector(), "train_args": Expression()}, "hidden.pt")
Path("pickle.pt").write_bytes(pickle.dumps({"model": Command()}))
torch.save({"model": detector(task="segment")}, "segment.pt")
torch.save({"model": detector(names=None)}, "nameless.pt")
torch.save({"model": torch.nn.Linear(2, 2)}, "layer.pt")
torch.save(torch.zeros(3), "tensor.pt")
Path("truncated.pt").write_bytes(Path("usable.pt").read_bytes()[:100_000])
Path("text.pt").write_text("no model")

codes = {}
for file in sorted(folder.glob("*.pt")):
    try:
        codes[file.stem] = " ".join(open_detector(file).signs)
    except PinelError as error:
        codes[file.stem] = error.code
print(json.dumps({"codes": codes, "executed": Path("executed").exists()}))
