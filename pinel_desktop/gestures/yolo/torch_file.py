"""The network of a detector from ultralytics' `.pt` file, which is a pickle.

PyTorch reads it with `weights_only`: a pickle may only make tensors and objects of an allowed class. Allowed are the
layers of PyTorch and of ultralytics, so no function that the file names is ever called.
"""

import importlib
import os
import pickle
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.yolo.network_files import are_sides, checked_names, require_detection

Array = NDArray[np.float32]

_FOLDERS_OF_LAYERS = ("torch.nn.modules.", "ultralytics.nn.")
_SIDE = 640  # px, if the file does not say it


class TorchNetwork:
    """A network in PyTorch, on one thread."""

    def __init__(self, file: str, model: Any, names: tuple[str, ...], side: int) -> None:
        self.file, self.names, self.size = file, names, (side, side)
        self._model = model

    def __call__(self, batch: Array) -> Array:
        import torch  # noqa: PLC0415 - the extra `yolo`

        with torch.inference_mode():
            try:
                outputs = self._model(torch.from_numpy(batch))
            except Exception as error:  # whatever a layer of an unknown version raises
                raise PinelError("detector_unreadable", file=self.file) from error
        first = outputs[0] if isinstance(outputs, list | tuple) else outputs
        array: Array = first[0].numpy()
        return array


def open_pt(path: Path) -> TorchNetwork:
    """Opens a `.pt` file of ultralytics.

    Raises:
        PinelError: `detector_extra_missing` without ultralytics, `detector_pickle_refused` for a class that is no
            layer, `detector_unreadable`, `detector_task_wrong`, `detector_names_missing`.
    """
    prepare_ultralytics()
    try:
        import torch  # noqa: PLC0415 - the extra `yolo`
        import ultralytics.nn.tasks  # noqa: F401, PLC0415
    except ImportError as error:
        raise PinelError("detector_extra_missing", file=path.name) from error
    torch.set_num_threads(1)
    checkpoint = _read_weights_only(path)
    model = checkpoint.get("ema") or checkpoint.get("model")
    if not isinstance(model, torch.nn.Module):
        raise PinelError("detector_unreadable", file=path.name)
    require_detection(path.name, str(getattr(model, "task", "detect")))
    names = checked_names(path.name, getattr(model, "names", None))
    side = (checkpoint.get("train_args") or {}).get("imgsz", _SIDE)
    if not are_sides((side, side)):
        raise PinelError("detector_shape_wrong", file=path.name, shape=str(side)[:20])
    try:
        ready = model.float().eval()
    except Exception as error:  # a layer of another version
        raise PinelError("detector_unreadable", file=path.name) from error
    return TorchNetwork(path.name, ready, names, side)


def prepare_ultralytics() -> None:
    """Keeps ultralytics off the network and its settings out of the user's folders; call it before its first import."""
    os.environ |= {"YOLO_OFFLINE": "true", "YOLO_AUTOINSTALL": "false", "YOLO_VERBOSE": "false"}
    os.environ.setdefault("YOLO_CONFIG_DIR", tempfile.mkdtemp(prefix="pinel-yolo-"))


def _read_weights_only(path: Path) -> dict[str, Any]:
    """Returns the content of the file; reads it only if all its classes are layers."""
    import torch  # noqa: PLC0415 - the extra `yolo`

    try:
        named = torch.serialization.get_unsafe_globals_in_checkpoint(path)
        classes = [_layer(path, name) for name in named]
        with torch.serialization.safe_globals(classes):
            content = torch.load(path, map_location="cpu", weights_only=True)
    except PinelError:
        raise
    except pickle.UnpicklingError as error:
        raise PinelError("detector_pickle_refused", file=path.name, name="pickle") from error
    except Exception as error:  # a text file, a truncated file, an object of another version
        raise PinelError("detector_unreadable", file=path.name) from error
    if not isinstance(content, dict):
        raise PinelError("detector_unreadable", file=path.name)
    return content


def _layer(path: Path, name: str) -> Any:
    """Returns the class of a layer by its full name. Raises PinelError `detector_pickle_refused` for anything else."""
    import torch  # noqa: PLC0415 - the extra `yolo`

    module, _, attribute = name.rpartition(".")
    is_allowed = f"{module}.".startswith(_FOLDERS_OF_LAYERS)
    found = None
    if is_allowed:
        try:
            found = getattr(importlib.import_module(module), attribute, None)
        except ImportError:
            found = None
    if not (isinstance(found, type) and issubclass(found, torch.nn.Module)):
        raise PinelError("detector_pickle_refused", file=path.name, name=name[:80])
    return found
