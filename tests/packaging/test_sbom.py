"""The bill of materials: each part of the package, with version, licence and hashes, in the form of CycloneDX."""

import json
from importlib.resources import files
from pathlib import Path
from typing import Any
from urllib.parse import urljoin

import jsonschema_rs
import pytest

from tests.packaging.loading import ROOT, load

notices = load("packaging/notices.py")
sbom = load("packaging/sbom.py")
contents = load("packaging/contents.py")
REFERENCED, SUFFIX = ("spdx", "jsf-0.82"), "SNAPSHOT.schema.json"


@pytest.fixture(scope="module")
def parts() -> list[Any]:
    """Notices of some Python distributions, and of all packages of the page."""
    page = json.loads((ROOT / "ui" / "package-lock.json").read_text("utf-8"))["packages"]
    names = ("blockly", "@preact/signals")
    return [
        *notices.python_notices(["flask.app", "pydantic_core"]),
        *(
            notices.Notice(name, page[f"node_modules/{name}"]["version"], "MIT", (), "npm")
            for name in names
        ),
        notices.Notice("libpython", "", "PSF-2.0"),
        notices.Notice(notices.MEDIAPIPE, "0.10.21", "Apache-2.0, converted to ONNX"),
        notices.Notice(notices.LIBRAS, "", "CC-BY-4.0"),
    ]


@pytest.fixture(scope="module")
def bom(parts: list[Any]) -> Any:
    return json.loads(sbom.bill_of_materials(ROOT, parts))


def schema(name: str) -> Any:
    """A schema of CycloneDX, as its Python library brings it."""
    file = files("cyclonedx.schema._res") / f"{name}.{SUFFIX}"
    return json.loads(file.read_text("utf-8"))


def component(bom: Any, name: str) -> Any:
    return next(one for one in bom["components"] if one["name"] == name)


def test_it_meets_the_schema(bom: Any) -> None:
    whole = schema("bom-1.6")
    parts = {urljoin(whole["$id"], f"{name}.{SUFFIX}"): schema(name) for name in REFERENCED}
    registry = jsonschema_rs.Registry(list(parts.items()))
    validator = jsonschema_rs.validator_for(whole, registry=registry)
    assert [error.message for error in validator.iter_errors(bom)] == []
    assert not validator.is_valid(bom | {"components": [{"name": "without a type"}]})


def test_every_part_is_a_component_with_its_licence(bom: Any, parts: list[Any]) -> None:
    names = {one["name"] for one in bom["components"]}
    assert names == {notice.name for notice in parts}
    assert all(one["licenses"] for one in bom["components"])
    assert component(bom, "Flask")["licenses"] == [{"license": {"id": "BSD-3-Clause"}}]
    assert component(bom, notices.MEDIAPIPE)["type"] == "machine-learning-model"


@pytest.mark.parametrize(
    ("name", "address", "algorithm"),
    [
        ("Flask", "pkg:pypi/flask@", "SHA-256"),
        ("pydantic_core", "pkg:pypi/pydantic-core@", "SHA-256"),
        ("blockly", "pkg:npm/blockly@", "SHA-512"),
        ("@preact/signals", "pkg:npm/%40preact/signals@", "SHA-512"),
    ],
)
def test_what_a_package_manager_installed_has_address_and_hashes(
    name: str, address: str, algorithm: str, bom: Any
) -> None:
    found = component(bom, name)
    assert found["purl"] == address + found["version"]
    assert {one["alg"] for one in found["hashes"]} == {algorithm}


def test_the_hashes_are_those_of_the_lock_file(bom: Any) -> None:
    lock = (ROOT / "requirements.lock").read_text("utf-8")
    flask = lock.partition("\nflask==")[2].partition("\nflask-openapi3==")[0]
    hashes = component(bom, "Flask")["hashes"]
    assert len(hashes) == flask.count("--hash=sha256:")
    assert all(one["content"] in flask for one in hashes)


def test_the_same_parts_give_the_same_text(bom: Any, parts: list[Any]) -> None:
    assert json.loads(sbom.bill_of_materials(ROOT, parts[::-1])) == bom
    other = json.loads(sbom.bill_of_materials(ROOT, parts[:-1]))
    assert other["serialNumber"] != bom["serialNumber"]


def test_a_package_without_it_is_not_complete(tmp_path: Path) -> None:
    (tmp_path / "THIRD-PARTY-NOTICES.txt").write_text("notices", "utf-8")
    assert contents.missing_provenance(tmp_path) == ["pinel-desktop.cdx.json"]
    (tmp_path / "pinel-desktop.cdx.json").write_text("{}", "utf-8")
    assert contents.missing_provenance(tmp_path) == []
