"""The converted networks compute what the originals compute: LiteRT is the oracle."""

import zipfile
from typing import Any

import numpy as np
import pytest
from ai_edge_litert.interpreter import Interpreter
from numpy.typing import NDArray

from pinel_desktop.gestures.networks import Network, checked
from scripts.hand_models.__main__ import ORIGINALS, WHEELS, Original, download
from scripts.hand_models.convert import ConversionError, _Source, convert

PALM, HAND = ORIGINALS


def original(which: Original) -> bytes:
    with zipfile.ZipFile(download(WHEELS)) as wheel:
        return wheel.read(which.member)


def oracle(which: Original) -> Any:
    """The original, keeping its inner tensors so that the map can be read too."""
    interpreter = Interpreter(
        model_content=original(which),
        num_threads=1,
        experimental_preserve_all_tensors=True,
    )
    interpreter.allocate_tensors()
    return interpreter


@pytest.mark.filterwarnings("ignore:.*experimental_preserve_all_tensors")
@pytest.mark.parametrize("which", ORIGINALS, ids=["palm", "hand"])
def test_every_output_agrees_with_the_original(which: Original) -> None:
    network, interpreter = Network(which.target), oracle(which)
    details = interpreter.get_input_details()[0]
    for seed in range(3):
        random = np.random.default_rng(seed)
        picture = random.integers(0, 256, details["shape"][1:], dtype=np.uint8)
        interpreter.set_tensor(details["index"], picture[None].astype(np.float32) / 255)
        interpreter.invoke()
        for tensor, found in zip(which.outputs.values(), network(picture), strict=True):
            expected: NDArray[np.float32] = interpreter.get_tensor(tensor)[0]
            assert found.shape == expected.shape
            # landmarks count pixels up to 224 and the boxes up to 192: relative to these
            assert np.abs(found - expected).max() <= 1e-4 * max(1, np.abs(expected).max())


@pytest.mark.parametrize("which", ORIGINALS, ids=["palm", "hand"])
def test_converting_again_gives_the_same_file(which: Original) -> None:
    made = convert(original(which), [which.input], which.outputs)
    assert made == checked(which.target)


def test_a_tensor_that_depends_on_the_input_is_no_weight() -> None:
    source = _Source(original(PALM))
    with pytest.raises(ConversionError):
        source.constant(PALM.outputs["boxes"])
