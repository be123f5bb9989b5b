"""Loads modules of packaging/ and scripts/, which are not packages, to avoid name clashes."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
# a script of packaging/ finds those beside it, as it does when it is run
sys.path.append(str(ROOT / "packaging"))


def load(place: str) -> ModuleType:
    """The module in the file `place`, relative to the root of the repository."""
    name = "pinel_" + place.replace("/", "_").removesuffix(".py")
    spec = importlib.util.spec_from_file_location(name, ROOT / place)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module
