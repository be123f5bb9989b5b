"""Bill of materials of the package: CycloneDX 1.6 in JSON (cyclonedx.org), from the licence notices and the lock files.

    python packaging/sbom.py FILE

Names, versions and licences are those of THIRD-PARTY-NOTICES.txt. Hashes are those of the lock files: of a Python
distribution the hashes of all its files, of which set-up has installed one. The same sources give the same bytes.
"""

import base64
import json
import os
import re
import sys
import uuid
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import freeze  # beside this file, as the next one
import notices
from cyclonedx.contrib.license.factories import LicenseFactory
from cyclonedx.model import HashAlgorithm, HashType
from cyclonedx.model.bom import Bom
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.output import make_outputter
from cyclonedx.schema import OutputFormat, SchemaVersion
from packageurl import PackageURL

from pinel_desktop import __version__

_KINDS = {
    notices.MEDIAPIPE: ComponentType.MACHINE_LEARNING_MODEL,
    notices.LIBRAS: ComponentType.DATA,
}
_LICENCES = LicenseFactory()


def bill_of_materials(root: Path, found: list[notices.Notice]) -> str:
    """Returns the bill of materials of the parts that have these notices."""
    program = Component(
        name="pinel-desktop",
        version=__version__,
        type=ComponentType.APPLICATION,
        bom_ref="pinel-desktop",
        licenses=[_LICENCES.make_from_string("MIT")],
    )
    hashes = python_hashes(root) | npm_hashes(root)
    parts = [_component(notice, hashes) for notice in sorted(found)]
    bom = Bom(components=parts, serial_number=_serial_number(found))
    bom.metadata.component = program
    bom.metadata.timestamp = _time_of_sources()
    bom.register_dependency(program, parts)
    return str(
        make_outputter(bom, OutputFormat.JSON, SchemaVersion.V1_6).output_as_string(indent=1)
    )


def _component(notice: notices.Notice, hashes: dict[PackageURL, list[HashType]]) -> Component:
    address = package_url(notice)
    return Component(
        name=notice.name,
        version=notice.version or None,
        type=_KINDS.get(notice.name, ComponentType.LIBRARY),
        bom_ref=str(address or f"{notice.name} {notice.version}".strip()),
        purl=address,
        licenses=[_LICENCES.make_from_string(notice.licence)],
        hashes=hashes.get(address, []) if address else [],
    )


def package_url(notice: notices.Notice) -> PackageURL | None:
    """Returns the package URL of a part that a package manager installed; None for other parts."""
    if not notice.manager:
        return None
    namespace, _, name = notice.name.rpartition("/")
    if notice.manager == "pypi":
        name = normalized(name)
    return PackageURL(notice.manager, namespace or None, name, notice.version)


def normalized(name: str) -> str:
    """Returns the name of a Python distribution as lock files write it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def python_hashes(root: Path) -> dict[PackageURL, list[HashType]]:
    """Returns the hashes of requirements.lock by package."""
    text = (root / "requirements.lock").read_text("utf-8")
    found: dict[PackageURL, list[HashType]] = {}
    for name, version, listed in re.findall(r"^([\w.-]+)==([^\s;]+)(.*(?:\n .*)*)", text, re.M):
        values = re.findall(r"--hash=sha256:([0-9a-f]{64})", listed)
        address = PackageURL("pypi", None, normalized(name), version)
        found[address] = [HashType(alg=HashAlgorithm.SHA_256, content=value) for value in values]
    return found


def npm_hashes(root: Path) -> dict[PackageURL, list[HashType]]:
    """Returns the hashes of package-lock.json by package."""
    packages = json.loads((root / "ui" / "package-lock.json").read_text("utf-8"))["packages"]
    return dict(_npm_hashes(packages))


def _npm_hashes(
    packages: dict[str, dict[str, str]],
) -> Iterator[tuple[PackageURL, list[HashType]]]:
    for place, package in packages.items():
        algorithm, _, value = package.get("integrity", "").partition("-")
        if algorithm == "sha512":
            namespace, _, name = place.rpartition("node_modules/")[2].rpartition("/")
            address = PackageURL("npm", namespace or None, name, package["version"])
            content = base64.b64decode(value).hex()
            yield address, [HashType(alg=HashAlgorithm.SHA_512, content=content)]


def _serial_number(found: list[notices.Notice]) -> uuid.UUID:
    """Returns the same number for the same parts of the same release."""
    parts = [f"{notice.name} {notice.version} {notice.licence}" for notice in sorted(found)]
    return uuid.uuid5(uuid.NAMESPACE_OID, "\n".join([f"pinel-desktop {__version__}", *parts]))


def _time_of_sources() -> datetime:
    seconds = os.environ.get("SOURCE_DATE_EPOCH", freeze.SAME_BYTES["SOURCE_DATE_EPOCH"])
    return datetime.fromtimestamp(int(seconds), UTC)


def main() -> None:
    root = Path(__file__).resolve().parents[1]
    Path(sys.argv[1]).write_text(bill_of_materials(root, notices.parts(root)), "utf-8")


if __name__ == "__main__":
    main()
