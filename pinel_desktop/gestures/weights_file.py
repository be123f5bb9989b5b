"""Saves and loads a classifier as `weights/letters.npz`: arrays only, no pickle that could execute code."""

import io
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.classifier import Calibration, Projection, SignClassifier
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.networks import FOLDER

LETTERS = FOLDER / "letters.npz"
# name -> kind of the array's dtype, number of dimensions
_ARRAYS = {
    "signs": ("U", 1),
    "mean": ("f", 1),
    "scale": ("f", 1),
    "axes": ("f", 2),
    "points": ("f", 2),
    "members": ("i", 1),
    "weights": ("f", 2),
    "calibration": ("f", 1),
}
_DATE = (1980, 1, 1, 0, 0, 0)  # constant, so that equal classifiers give equal files

Arrays = dict[str, NDArray[Any]]


def save(classifier: SignClassifier, path: Path) -> None:
    """Writes a classifier; points and projection in half precision, already rounded by `classifier.stored`."""
    projection, calibration = classifier.projection, classifier.calibration
    arrays: Arrays = {
        "signs": np.array(classifier.signs),
        "mean": projection.mean.astype(np.float16),
        "scale": projection.scale.astype(np.float16),
        "axes": projection.axes.astype(np.float16),
        "points": classifier.points.astype(np.float16),
        "members": classifier.members.astype(np.int16),
        "weights": classifier.weights.astype(np.float32),
        "calibration": np.array([calibration.sharpness, calibration.no_sign]),
    }
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, values in arrays.items():
            entry = zipfile.ZipInfo(f"{name}.npy", _DATE)
            with file.open(entry, "w") as member:
                np.lib.format.write_array(member, values, allow_pickle=False)


def load(path: Path = LETTERS) -> SignClassifier:
    """Loads a classifier from a file. Raises PinelError: `gesture_model_missing`, `gesture_model_damaged`."""
    try:
        content = path.read_bytes()
        with np.load(io.BytesIO(content), allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in _ARRAYS}
    except FileNotFoundError as error:
        raise PinelError("gesture_model_missing", file=str(path)) from error
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise PinelError("gesture_model_damaged", file=str(path)) from error
    if not _fit_together(arrays):
        raise PinelError("gesture_model_damaged", file=str(path))
    real = {
        name: arrays[name].astype(np.float64) for name, (kind, _) in _ARRAYS.items() if kind == "f"
    }
    return SignClassifier(
        signs=tuple(map(str, arrays["signs"])),
        projection=Projection(real["mean"], real["scale"], real["axes"]),
        points=real["points"],
        members=arrays["members"].astype(np.int64),
        weights=real["weights"],
        calibration=Calibration(*map(float, real["calibration"])),
    )


def _fit_together(arrays: Arrays) -> bool:
    """Returns whether dtypes, shapes and values form a valid classifier of `N_FEATURES` features."""
    for name, (kind, n_dimensions) in _ARRAYS.items():
        values = arrays[name]
        if values.dtype.kind != kind or values.ndim != n_dimensions:
            return False
        if kind == "f" and not np.isfinite(values).all():
            return False
    n_signs = len(arrays["signs"])
    n_points, n_axes = arrays["points"].shape
    shapes = {
        "mean": (N_FEATURES,),
        "scale": (N_FEATURES,),
        "axes": (N_FEATURES, n_axes),
        "members": (n_points,),
        "weights": (n_points, n_signs),
        "calibration": (2,),
    }
    if any(arrays[name].shape != shape for name, shape in shapes.items()):
        return False
    members = arrays["members"]
    every_sign = np.isin(np.arange(n_signs), members).all()
    return bool(n_signs >= 2 and members.min() >= -1 and members.max() < n_signs and every_sign)
