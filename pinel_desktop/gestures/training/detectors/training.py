"""Trains a YOLOv8n detector with ultralytics, exports it to ONNX, and writes its model card."""

import csv
import hashlib
import platform
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.yolo.torch_file import prepare_ultralytics

_ARCHITECTURE = "yolov8n.yaml"  # random weights: none are downloaded
_SEED = 0
# A hand that is turned left for right shows another letter to some readers, so pictures are not mirrored.
_SETTINGS: dict[str, Any] = {
    "optimizer": "AdamW",
    "lr0": 0.0015,
    "cos_lr": True,
    "fliplr": 0.0,
    "degrees": 10.0,
    "close_mosaic": 15,
    "patience": 0,
    "seed": _SEED,
    "plots": False,
    "verbose": False,
    "exist_ok": True,
}
_BATCH = 32
_MAP50, _MAP50_95 = "metrics/mAP50(B)", "metrics/mAP50-95(B)"


@dataclass(frozen=True)
class Training:
    """What to train.

    data: `data.yaml` of ultralytics. folder: for weights, curves and model card. side: of the input, px.
    device: as ultralytics names it, such as `cpu` or `0` for the first GPU; None for the best there is.
    """

    data: Path
    folder: Path
    epochs: int
    side: int
    device: str | None = None


@dataclass(frozen=True)
class TrainedDetector:
    """The files of a trained detector, and the figures of its best epoch on the validation pictures."""

    onnx: Path
    card: Path
    epochs: int
    map50: float
    map50_95: float


def train(
    training: Training, on_epoch: Callable[[int, float], object] = lambda epoch, map50: None
) -> TrainedDetector:
    """Trains a detector, or resumes a training in the same folder that was killed.

    Args:
        on_epoch: called after each epoch with its number, from 1, and mAP50.

    Raises:
        PinelError: `detector_extra_missing`, `detector_data_unreadable`.
    """
    _check_data(training.data)
    prepare_ultralytics()
    try:
        import ultralytics  # noqa: PLC0415 - the extra `yolo`
        from ultralytics.engine import trainer  # noqa: PLC0415
    except ImportError as error:
        raise PinelError("detector_extra_missing", file=_ARCHITECTURE) from error
    trainer.check_amp = lambda model: True  # the check downloads a model
    weights = training.folder / "weights"
    resumed = (weights / "last.pt").is_file() and not (training.folder / "model.onnx").is_file()
    model = ultralytics.YOLO(str(weights / "last.pt") if resumed else _ARCHITECTURE)

    def report(state: Any) -> None:
        if state.epoch < training.epochs:  # ultralytics calls it once more for the best weights
            on_epoch(state.epoch + 1, float((state.metrics or {}).get(_MAP50, 0.0)))

    model.add_callback("on_fit_epoch_end", report)
    if resumed:
        _resume(model)
    else:
        model.train(**_arguments(training))
    exported = Path(
        ultralytics.YOLO(str(weights / "best.pt")).export(
            format="onnx", imgsz=training.side, simplify=False, opset=17
        )
    )
    onnx = exported.replace(training.folder / "model.onnx")
    rows = _rows(training.folder / "results.csv")
    card = _write_card(training, rows, ultralytics.__version__)
    best = max(rows, key=lambda row: row[_MAP50_95])
    return TrainedDetector(onnx, card, len(rows), best[_MAP50], best[_MAP50_95])


def _arguments(training: Training) -> dict[str, Any]:
    folder = training.folder.resolve()
    return {
        **_SETTINGS,
        "data": str(training.data),
        "epochs": training.epochs,
        "imgsz": training.side,
        "batch": _BATCH,
        "device": training.device,
        "cache": "ram",
        "project": str(folder.parent),
        "name": folder.name,
    }


def _resume(model: Any) -> None:
    try:
        model.train(resume=True)
    except AssertionError:  # the last epoch was trained, and only the export was not
        return


def _check_data(data: Path) -> None:
    """Raises PinelError `detector_data_unreadable`."""
    try:
        is_data = data.is_file() and "names" in data.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        is_data = False
    if not is_data:
        raise PinelError("detector_data_unreadable", path=str(data))


def _rows(results: Path) -> list[dict[str, float]]:
    """Returns the epochs of ultralytics' `results.csv`."""
    with results.open(encoding="utf-8", newline="") as file:
        return [
            {name.strip(): float(value) for name, value in row.items()}
            for row in csv.DictReader(file)
        ]


def _write_card(training: Training, rows: list[dict[str, float]], version: str) -> Path:
    """Writes the curves as PNG and the model card; returns the card."""
    import torch  # noqa: PLC0415 - the extra `yolo`

    _draw_curves(rows, training.folder / "curves.png")
    best = max(rows, key=lambda row: row[_MAP50_95])
    lines = [
        "# YOLOv8n detector of signs",
        "",
        f"- Trained with `pinel gestures train-yolo`, ultralytics {version}, PyTorch {torch.__version__}, "
        f"Python {platform.python_version()}.",
        f"- Data: `{training.data.name}`, SHA-256 of pictures and labels {hash_of_data(training.data)}.",
        f"- {len(rows)} epochs at {training.side} px from random weights, seed {_SEED}, batch {_BATCH}; "
        "pictures are not mirrored.",
        f"- Best epoch {int(best['epoch'])}: mAP50 {best[_MAP50]:.3f}, mAP50-95 {best[_MAP50_95]:.3f} on the "
        "validation pictures. People who are in the training pictures too say nothing about other people.",
        "- Licence: AGPL-3.0, as ultralytics, which made it; and the licence of the pictures "
        '("Alfabeto em libras", Roboflow Universe, elainesilva: CC BY 4.0).',
        "",
        "![mAP50 and mAP50-95 by epoch](curves.png)",
    ]
    card = training.folder / "MODEL_CARD.md"
    card.write_text("\n".join(lines) + "\n", "utf-8")
    return card


def _draw_curves(rows: list[dict[str, float]], target: Path) -> None:
    from matplotlib.figure import Figure  # noqa: PLC0415 - the extra `yolo`

    figure = Figure(figsize=(7, 4), layout="constrained")
    axes = figure.add_subplot()
    for name, label in ((_MAP50, "mAP50"), (_MAP50_95, "mAP50-95")):
        axes.plot([row["epoch"] for row in rows], [row[name] for row in rows], label=label)
    axes.set(xlabel="epoch", ylim=(0, 1))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(target, dpi=120)


def hash_of_data(data: Path) -> str:
    """Returns the SHA-256 over names and contents of all pictures and labels beside `data.yaml`, in their order."""
    total = hashlib.sha256()
    for file in sorted(data.parent.rglob("*")):
        if file.parent.name in ("images", "labels") and file.is_file():
            total.update(file.relative_to(data.parent).as_posix().encode())
            total.update(hashlib.sha256(file.read_bytes()).digest())
    return total.hexdigest()
