"""`pinel gestures yolo-data`, `train-yolo` and `compare`: a detector of one's own, and how it compares."""

import json
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pinel_desktop.commands.printing import Failure
from pinel_desktop.errors import PinelError

if TYPE_CHECKING:
    from pinel_desktop.gestures.training.photos import Photo

_FOLDER = click.Path(path_type=Path, file_okay=False)
_FILE = click.Path(path_type=Path, dir_okay=False)


@click.command()
@click.argument("photos", metavar="DIR", type=_FOLDER)
@click.argument("target", metavar="TARGET", type=_FOLDER)
@click.option("--without", metavar="SOURCE", help="Validate on this source, and train without it.")
def yolo_data(photos: Path, target: Path, without: str | None) -> None:
    """Write the labelled pictures of DIR (with sources.csv) into TARGET, as a detector is trained on them.

    The stretch of the pictures is undone.
    """
    try:
        from pinel_desktop.gestures.training.detectors.dataset import write_dataset  # noqa: PLC0415
        from pinel_desktop.gestures.training.photos import read_photos  # noqa: PLC0415 - slow

        found = read_photos(photos)
        with click.progressbar(length=len(found), file=sys.stderr) as progress:
            data = write_dataset(found, target, without, lambda: progress.update(1))
    except PinelError as error:
        raise Failure(error) from error
    click.echo(data)


@click.command()
@click.argument("data", metavar="DATA.YAML", type=_FILE)
@click.option("--output", type=_FOLDER, default=Path("detector"), show_default=True, help="Folder.")
@click.option("--epochs", type=click.IntRange(1, 10_000), default=150, show_default=True)
@click.option("--imgsz", type=click.IntRange(32, 2048), default=320, show_default=True, help="px.")
@click.option("--device", help="As ultralytics names it: cpu, 0 for the first GPU.")
def train_yolo(data: Path, output: Path, epochs: int, imgsz: int, device: str | None) -> None:
    """Train a YOLOv8n detector with ultralytics, which the extra `yolo` installs (licence AGPL-3.0).

    Writes model.onnx, MODEL_CARD.md and curves.png into the output folder. A training that was killed is resumed by the
    same command. A GPU is used if there is one.
    """
    try:
        from pinel_desktop.gestures.training.detectors.training import Training, train  # noqa: PLC0415 - slow

        trained = train(
            Training(data, output, epochs, imgsz, device),
            lambda epoch, map50: click.echo(f"{epoch}/{epochs}  mAP50 {map50:.3f}", err=True),
        )
    except PinelError as error:
        raise Failure(error) from error
    click.echo(
        f"{trained.onnx}: {trained.epochs} epochs, mAP50 {trained.map50:.3f}, "
        f"mAP50-95 {trained.map50_95:.3f}"
    )


@click.command()
@click.argument("photos", metavar="DIR", type=_FOLDER)
@click.option("--detector", type=_FILE, required=True, help="Trained on the split `train`.")
@click.option(
    "--left-out",
    metavar="SOURCE=FILE",
    multiple=True,
    help="A detector that was trained without this source; may be repeated.",
)
@click.option("--recordings", type=_FILE, help="Keep what was found in the pictures in this file.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def compare(
    photos: Path, detector: Path, left_out: tuple[str, ...], recordings: Path | None, as_json: bool
) -> None:
    """Compare landmarks and a detector on the same labelled pictures of DIR; print a table in Markdown.

    The landmarks are trained without the tested pictures, as the detectors are. mAP needs the extra `yolo`.
    """
    pairs = dict(pair.partition("=")[::2] for pair in left_out)
    if not all(pairs.values()):
        raise click.UsageError("--left-out needs SOURCE=FILE")
    try:
        report, precision = _compared(photos, detector, pairs, recordings)
    except PinelError as error:
        raise Failure(error) from error
    from pinel_desktop.gestures.training.detectors.comparison import as_table  # noqa: PLC0415 - slow

    if as_json:
        click.echo(json.dumps({**report, "average_precision": precision}))
    else:
        click.echo(as_table(report, precision))


def _compared(
    folder: Path, detector: Path, left_out: dict[str, str], recordings: Path | None
) -> tuple[dict[str, object], dict[str, float] | None]:
    from pinel_desktop.gestures.training.detectors.comparison import Comparison, compare  # noqa: PLC0415
    from pinel_desktop.gestures.training.photo_features import load_photo_features  # noqa: PLC0415
    from pinel_desktop.gestures.training.photos import read_photos  # noqa: PLC0415

    photos = read_photos(folder)
    with click.progressbar(length=len(photos), file=sys.stderr) as progress:
        features = load_photo_features(photos, recordings, lambda: progress.update(1))
    files = {source: Path(file) for source, file in left_out.items()}
    report = compare(Comparison(photos, features, detector, files))
    return report, _average_precision(photos, detector) if "valid" in report["sets"] else None


def _average_precision(photos: "list[Photo]", detector: Path) -> dict[str, float] | None:
    """Returns None without the extra."""
    from pinel_desktop.gestures.training.detectors.average_precision import average_precision  # noqa: PLC0415
    from pinel_desktop.gestures.training.detectors.dataset import write_dataset  # noqa: PLC0415
    from pinel_desktop.gestures.yolo.detector import open_detector  # noqa: PLC0415

    with tempfile.TemporaryDirectory() as place:
        data = write_dataset(photos, Path(place))
        try:
            return average_precision(detector, data, max(open_detector(detector).size))
        except PinelError as error:
            if error.code != "detector_extra_missing":
                raise
            return None
