"""Mean average precision of a detector, by ultralytics' validator."""

from pathlib import Path

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.yolo.torch_file import prepare_ultralytics


def average_precision(detector: Path, data: Path, side: int) -> dict[str, float]:
    """Returns `map50` and `map50_95` of a detector on the validation pictures of `data.yaml`.

    Raises:
        PinelError: `detector_extra_missing`.
    """
    prepare_ultralytics()
    try:
        import ultralytics  # noqa: PLC0415 - the extra `yolo`
    except ImportError as error:
        raise PinelError("detector_extra_missing", file=detector.name) from error
    model = ultralytics.YOLO(str(detector), task="detect")
    found = model.val(data=str(data), imgsz=side, batch=1, device="cpu", plots=False, verbose=False)
    return {"map50": float(found.box.map50), "map50_95": float(found.box.map)}
