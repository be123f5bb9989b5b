"""`pinel gestures`: classifies letters of Libras in pictures, evaluates and trains the classifier, teaches signs."""

import json
import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pinel_desktop.commands.database import key_of, opened_store
from pinel_desktop.commands.detectors import compare, train_yolo, yolo_data
from pinel_desktop.commands.options import chosen_database, database_option, recognizer_option
from pinel_desktop.commands.printing import Failure, print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.letters import LANDMARKS
from pinel_desktop.messages import language_of_system
from storage.limits import MAX_TAUGHT_SAMPLES

if TYPE_CHECKING:
    from pinel_desktop.gestures.recognizer import SignRecognizer
    from pinel_desktop.gestures.training.photo_features import PhotoFeatures
    from pinel_desktop.gestures.training.photos import Photo
    from storage import Store

_UNUSABLE = 2
_FOLDER = click.Path(path_type=Path, file_okay=False)
_FILE = click.Path(path_type=Path, dir_okay=False)
# Click must not check the files: an unreadable file is reported in its turn, the others are read.
_IMAGE = click.Path(path_type=Path, readable=False)
_recordings_option = click.option(
    "--recordings",
    type=_FILE,
    help="Keep what was found in the pictures in this file, and use it the next time.",
)


class _Aspect(click.ParamType[float]):
    """Width and height with a colon between, such as 16:9; becomes their quotient."""

    name = "W:H"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        if isinstance(value, float):
            return value
        match = re.fullmatch(r"(\d{1,5}(?:\.\d+)?):(\d{1,5}(?:\.\d+)?)", str(value))
        aspect = float(match[1]) / float(match[2]) if match and float(match[2]) else 0.0
        if not 0.1 <= aspect <= 10:
            self.fail("is not of the form W:H between 1:10 and 10:1, such as 16:9.", param, ctx)
        return aspect


@click.group()
def command() -> None:
    """Recognise letters of Libras in pictures."""


for _subcommand in (yolo_data, train_yolo, compare):
    command.add_command(_subcommand)


@command.command()
@click.argument("images", metavar="IMAGE...", nargs=-1, required=True, type=_IMAGE)
@click.option(
    "--aspect", type=_Aspect(), help="Shape of the pictures before they were stretched, e.g. 16:9."
)
@recognizer_option
@click.pass_context
def classify(
    ctx: click.Context, images: tuple[Path, ...], aspect: float | None, recognizer: str | None
) -> None:
    """Classify the letter that a hand shows in each picture; print one JSON object per line.

    `letter` is null if the prediction is rejected. `best` is the likeliest letter at any confidence, null without a
    hand. `box` is left, top, right, bottom in pixels of the unstretched picture. `handedness` is right for a picture
    that is not mirrored, null from a detector. Exit status: 0 all pictures were read, 2 at least one could not be read.
    """
    with _exit_on_error():
        from pinel_desktop.gestures.recognizers import open_recognizer  # noqa: PLC0415 - slow to import

        opened = open_recognizer(recognizer or LANDMARKS)
    all_read = True
    for image in images:
        try:
            click.echo(json.dumps(_classified(opened, image, aspect), ensure_ascii=False))
        except PinelError as error:
            print_problem(error, language_of_system())
            all_read = False
    ctx.exit(0 if all_read else _UNUSABLE)


@command.command()
@click.argument("folder", metavar="DIR", type=_FOLDER)
@click.option(
    "--leave-one-source-out",
    "table",
    type=_FILE,
    metavar="SOURCES.CSV",
    help="Train without each source in turn and test on it.",
)
@click.option(
    "--sequences", is_flag=True, help="Also make short videos of the pictures; some minutes more."
)
@click.option(
    "--numbers", is_flag=True, help="Measure only how raised fingers are counted; some minutes."
)
@recognizer_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@_recordings_option
def evaluate(
    folder: Path,
    table: Path | None,
    sequences: bool,
    numbers: bool,
    recognizer: str | None,
    as_json: bool,
    recordings: Path | None,
) -> None:
    """Measure the accuracy of letter recognition in the labelled pictures of DIR, or the counting of fingers.

    sources.csv is in DIR, or beside it. Without --leave-one-source-out, the shipped letters are measured. They were
    trained on the same people, so the results do not apply to other people. With --recognizer yolo:FILE, a detector is
    measured as it is.
    """
    is_detector = recognizer not in (None, LANDMARKS)
    if is_detector and (table or sequences or numbers):
        raise click.UsageError("a detector is measured as it is: leave out the other options")
    with _exit_on_error():
        from pinel_desktop.gestures import weights_file  # noqa: PLC0415 - slow to import
        from pinel_desktop.gestures.training import evaluation, photos  # noqa: PLC0415

        found = photos.read_photos(folder, table)
        if is_detector:
            report = _detected(found, str(recognizer))
        elif numbers:
            report = _counted(found)
        else:
            recorded = _recorded(found, recordings)
            if table:
                report = evaluation.evaluate_unseen(recorded)
            else:
                report = evaluation.evaluate_known(recorded, weights_file.load())
            report["speed_ms"] = evaluation.speed_ms(found)
        if sequences and not numbers:
            from pinel_desktop.gestures.training.moving_report import (  # noqa: PLC0415
                moving_report,
            )
            from pinel_desktop.gestures.training.sequences import sequences_report  # noqa: PLC0415

            report["sequences"] = sequences_report(found, recorded)
            report["signs_that_move"] = moving_report(found, recorded)
    if as_json:
        click.echo(json.dumps(report, ensure_ascii=False))
    else:
        click.echo("\n".join(_lines(report)))


@command.command()
@click.argument("folder", metavar="DIR", type=_FOLDER)
@click.option("--output", type=_FILE, help="Where to write; by default the letters that ship.")
@click.option("--seed", type=int, help="Another seed than the one that the letters that ship have.")
@_recordings_option
def train(folder: Path, output: Path | None, seed: int | None, recordings: Path | None) -> None:
    """Train the letters on the labelled pictures of DIR (with sources.csv), and write them."""
    with _exit_on_error():
        from pinel_desktop.gestures import weights_file  # noqa: PLC0415 - slow to import
        from pinel_desktop.gestures.training import letter_training, photos  # noqa: PLC0415

        recorded = _recorded(photos.read_photos(folder), recordings)
        letters = letter_training.train(recorded, letter_training.SEED if seed is None else seed)
        target = output or weights_file.LETTERS
        weights_file.save(letters, target)
    size = target.stat().st_size
    click.echo(
        f"{target}: {len(letters.signs)} letters, {len(letters.points)} samples, {size} bytes"
    )


@command.command()
@click.argument("name", metavar="NAME")
@click.argument("images", metavar="IMAGE...", nargs=-1, type=_IMAGE)
@click.option("--class", "classroom", required=True, help="The class that teaches (name or key).")
@click.option(
    "--camera",
    "source",
    metavar="SOURCE",
    help="Instead of pictures: number of a webcam from 0, or a video, folder or recording that stands in for one.",
)
@click.option("--moving", is_flag=True, help="The sign moves (experimental); needs --camera.")
@click.option(
    "--aspect", type=_Aspect(), help="Shape of the pictures before they were stretched, e.g. 16:9."
)
@database_option
@click.pass_context
def teach(
    ctx: click.Context,
    name: str,
    images: tuple[Path, ...],
    classroom: str,
    source: str | None,
    moving: bool,
    aspect: float | None,
) -> None:
    """Teach a class the sign NAME, from pictures with one hand each, or with a camera.

    A camera records ten hands at rest, or with --moving five movements, each from rest to rest. Prints one JSON object:
    class, sign, is_moving, added, and the current numbers of samples and movements. A running app uses the sign when a
    program of the class or the practice screen is opened next. Exit status: 0, or 2 if a picture was unusable; the
    others are used nevertheless.
    """
    if bool(images) == bool(source) or (moving and not source):
        raise click.UsageError("give either pictures or --camera; --moving needs --camera")
    with opened_store(chosen_database(ctx), may_be_new=False) as store:
        found = key_of(classroom, store.classrooms.all())
        sign = store.taught_signs.name_to_teach(found, name, is_moving=moving)
        with _exit_on_error():
            samples = (
                _samples_of_camera(source, is_moving=moving)
                if source
                else _samples_of_pictures(images, aspect)
            )
        if samples:
            store.taught_signs.add(found, sign, b"".join(samples), is_moving=moving)
            report = _taught(store, found, sign, len(samples), is_moving=moving)
            click.echo(json.dumps(report, ensure_ascii=False))
    ctx.exit(0 if source or len(samples) == len(images) else _UNUSABLE)


def _samples_of_camera(source: str, *, is_moving: bool) -> list[bytes]:
    from pinel_desktop.camera.teaching_samples import samples_of_camera  # noqa: PLC0415 - slow
    from pinel_desktop.school.sign_teaching import N_MOVEMENTS, N_SAMPLES  # noqa: PLC0415

    return samples_of_camera(source, N_MOVEMENTS if is_moving else N_SAMPLES, is_moving=is_moving)


def _samples_of_pictures(images: tuple[Path, ...], aspect: float | None) -> list[bytes]:
    """Returns a sample of each usable picture; prints the problems of the others."""
    from pinel_desktop.camera.teaching_samples import sample_of_picture  # noqa: PLC0415 - slow
    from pinel_desktop.gestures.recognition import LandmarkRecognizer  # noqa: PLC0415

    recognizer, samples = LandmarkRecognizer(), []
    for image in images[:MAX_TAUGHT_SAMPLES]:
        try:
            samples.append(sample_of_picture(recognizer, image, aspect))
        except PinelError as error:
            print_problem(error, language_of_system())
    return samples


def _taught(
    store: "Store", classroom: str, sign: str, n_added: int, *, is_moving: bool
) -> dict[str, Any]:
    known = next(one for one in store.taught_signs.of_classroom(classroom) if one.sign == sign)
    return {
        "class": store.classrooms.get(classroom).name,
        "sign": sign,
        "is_moving": is_moving,
        "added": n_added,
        "samples": known.n_samples,
        "movements": known.n_movements,
    }


@contextmanager
def _exit_on_error() -> Iterator[None]:
    """Ends the command with the error's message if the body raises PinelError."""
    try:
        yield
    except PinelError as error:
        raise Failure(error) from error


def _recorded(found: "list[Photo]", recordings_file: Path | None) -> "PhotoFeatures":
    from pinel_desktop.gestures.training.photo_features import load_photo_features  # noqa: PLC0415 - slow to import

    with click.progressbar(length=len(found), file=sys.stderr) as progress:
        return load_photo_features(found, recordings_file, lambda: progress.update(1))


def _detected(found: "list[Photo]", recognizer: str) -> dict[str, Any]:
    from pinel_desktop.gestures.recognizers import open_recognizer  # noqa: PLC0415 - slow to import
    from pinel_desktop.gestures.training.detectors.comparison import figures  # noqa: PLC0415

    opened = open_recognizer(recognizer)
    with click.progressbar(length=len(found), file=sys.stderr) as progress:
        return {"photos": len(found), **figures(opened, found, lambda: progress.update(1))}


def _counted(found: "list[Photo]") -> dict[str, Any]:
    from pinel_desktop.gestures.training.number_report import (  # noqa: PLC0415 - slow to import
        n_counted,
        number_report,
    )

    with click.progressbar(length=n_counted(found), file=sys.stderr) as progress:
        return number_report(found, lambda: progress.update(1))


def _classified(recognizer: "SignRecognizer", image: Path, aspect: float | None) -> dict[str, Any]:
    """Returns one line of `classify`; `ms` is the time for the recognition in ms. Raises PinelError."""
    from pinel_desktop.gestures.pictures import read_picture  # noqa: PLC0415 - slow to import
    from pinel_desktop.gestures.recognizer import clearest  # noqa: PLC0415

    picture = read_picture(image, aspect)
    started = time.perf_counter()
    clearest_hand = clearest(recognizer.read(picture))
    ms = round(1000 * (time.perf_counter() - started), 1)
    nothing = dict.fromkeys(("letter", "best", "confidence", "second", "box", "handedness"))
    if clearest_hand is None:
        return {"file": str(image), **nothing, "ms": ms}
    reading = clearest_hand.prediction
    return {
        "file": str(image),
        "letter": reading.sign,
        "best": reading.best,
        "confidence": round(reading.confidence, 3),
        "second": reading.second,
        "box": [round(side) for side in clearest_hand.box],
        "handedness": clearest_hand.hand.handedness if clearest_hand.hand else None,
        "ms": ms,
    }


def _lines(report: dict[str, Any], name: str = "") -> Iterator[str]:
    """Yields a report as text: one line for each metric, proportions with their 95 % intervals."""
    if set(report) == {"share", "low", "high", "n", "of"}:
        share = "-" if report["share"] is None else f"{report['share']:.3f}"
        yield f"{name}: {share} [{report['low']:.3f}, {report['high']:.3f}] of {report['of']}"
        return
    for key, value in report.items():
        inner = f"{name} / {key}" if name else key
        if isinstance(value, dict):
            yield from _lines(value, inner)
        else:
            yield f"{inner}: {value}"
