"""Frames with a drawn hand, on one thread: while it is followed, where it is looked for, and what a detector takes.

`make bench` installs the detector (ultralytics on PyTorch) into the environment of the compared programs. It runs in a
process of its own, in turns with ours, on the same pictures in the camera's size; what counts is processor time.
"""

import json
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

import numpy as np
import pytest

from pinel_desktop.camera.frames import HEIGHT, WIDTH
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.gestures.recognizer import RecognizedSign
from pinel_desktop.gestures.yolo.detector import open_detector
from tests.gestures.drawn import drawn_hand, on_wall

PEER = Path(__file__).parent / "peers" / "on_ultralytics.py"
PEERS = Path(__file__).parents[2] / "build" / "peers"
N_FRAMES = 60
MIN_GAIN = 2.0
TRACKING_MS, COLD_MS = 15, 50
N_PICTURES, N_ROUNDS = 4, 12
MIN_GAIN_ON_DETECTOR = 5.0
MIN_GAIN_ON_ONNX, ONNX_MS = 1.5, 45
needs_detector = pytest.mark.skipif(
    not (PEERS / ".ready-detector").exists(),
    reason="PyTorch or ultralytics could not be installed into build/peers: not compared",
)


def median_ms(work: Callable[[], object]) -> float:
    times = []
    for _ in range(N_FRAMES):
        started = time.perf_counter()
        work()
        times.append(1000 * (time.perf_counter() - started))
    return median(times)


def test_following_a_hand_takes_less_than_half_of_looking_for_it() -> None:
    recogniser = LandmarkRecognizer()
    frame = on_wall(drawn_hand(size=320), 1280, 720, 300, 100)
    recogniser.track(frame)
    tracking = median_ms(lambda: recogniser.track(frame))
    cold = median_ms(lambda: recogniser.read(frame))
    print(f"\ntracking {tracking:.1f} ms, cold {cold:.1f} ms a frame; {cold / tracking:.1f} times")
    print(f"wanted on an idle PC: at most {TRACKING_MS} and {COLD_MS} ms")
    assert cold / tracking >= MIN_GAIN


def moving_hand() -> list[Picture]:
    """Frames in which the hand moves by a few pixels, so that it is followed."""
    hand = drawn_hand(size=320)
    return [on_wall(hand, WIDTH, HEIGHT, 160 + 3 * n, 90 + 2 * n) for n in range(N_PICTURES)]


def seconds_of(
    detect: Callable[[Picture], list[RecognizedSign]], pictures: list[Picture]
) -> list[float]:
    """Processor time of each picture; asserts that its hand is seen."""
    times = []
    for picture in pictures:
        start_s = time.process_time()
        hands = detect(picture)
        times.append(time.process_time() - start_s)
        assert len(hands) == 1
    return times


@contextmanager
def detector(
    pictures: list[Picture], folder: Path, **options: str
) -> Iterator[Callable[[], list[float]]]:
    """The detector in its process: gives the processor time of each picture."""
    np.save(folder / "pictures.npy", np.array(pictures))
    with subprocess.Popen(
        [PEERS / "bin" / "python", PEER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        requests, output = process.stdin, process.stdout
        print(
            json.dumps({"pictures": str(folder / "pictures.npy"), **options}),
            file=requests,
            flush=True,
        )

        def seconds() -> list[float]:
            print("go", file=requests, flush=True)
            return list(json.loads(output.readline())["seconds"])

        yield seconds
        requests.close()


@needs_detector
def test_a_hand_and_its_letter_take_a_fifth_of_a_detector_at_640(tmp_path: Path) -> None:
    recogniser, pictures = LandmarkRecognizer(), moving_hand()
    with detector(pictures, tmp_path) as detect:
        methods: dict[str, Callable[[], list[float]]] = {
            "tracking": lambda: seconds_of(recogniser.track, pictures),
            "cold": lambda: seconds_of(recogniser.read, pictures),
            "detector": detect,
        }
        # the first two rounds lay out memory
        rounds = [
            {name: method() for name, method in methods.items()} for _ in range(N_ROUNDS + 2)
        ][2:]
    gains = {name: median(sum(r["detector"]) / sum(r[name]) for r in rounds) for name in methods}
    ms = {name: 1000 * median(sum(r[name]) for r in rounds) / N_PICTURES for name in methods}
    print(
        f"\nthe same {N_PICTURES} pictures of {WIDTH} x {HEIGHT} px in turns, one thread each, processor time:\n"
        f"  a hand that is followed, and its letter     {ms['tracking']:6.1f} ms\n"
        f"  a hand that is looked for, and its letter   {ms['cold']:6.1f} ms\n"
        f"  YOLOv8n of random weights, predict at 640   {ms['detector']:6.1f} ms (ultralytics on PyTorch)\n"
        f"  followed {gains['tracking']:.1f} times faster, at least {MIN_GAIN_ON_DETECTOR:.0f};"
        f" looked for {gains['cold']:.1f} times"
    )
    assert gains["tracking"] >= MIN_GAIN_ON_DETECTOR


@needs_detector
def test_a_detectors_file_is_read_faster_than_by_ultralytics(tmp_path: Path) -> None:
    """The same ONNX file, at 320 px, in ours and in ultralytics' predict."""
    pictures, file = moving_hand(), tmp_path / "yolov8n.onnx"
    packages = str(Path(np.__file__).parents[1])
    with detector(pictures, tmp_path, onnx=str(file), packages=packages) as theirs:
        theirs()
        ours = open_detector(file)

        def read() -> list[float]:
            times = []
            for picture in pictures:
                start_s = time.process_time()
                ours.read(picture)
                times.append(time.process_time() - start_s)
            return times

        rounds = [(sum(read()), sum(theirs())) for _ in range(N_ROUNDS + 2)][2:]
    gain = median(other / own for own, other in rounds)
    ms = [1000 * median(side) / N_PICTURES for side in zip(*rounds, strict=True)]
    print(
        f"\nYOLOv8n from one ONNX file at 320, one thread each, processor time: {ms[0]:.1f} ms, wanted {ONNX_MS};"
        f" ultralytics' predict {ms[1]:.1f} ms: {gain:.2f} times, at least {MIN_GAIN_ON_ONNX}"
    )
    assert gain >= MIN_GAIN_ON_ONNX
