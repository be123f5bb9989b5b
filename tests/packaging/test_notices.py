"""What may ship with the program, and what is said about it."""

import json
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT, load

notices = load("packaging/notices.py")


@pytest.mark.parametrize(
    "licence",
    [
        "MIT",
        "BSD-3-Clause AND 0BSD AND MIT",
        "GNU Lesser General Public License v2 or later (LGPLv2+)",
        "LGPL-2.1-or-later",
        "MIT OR GPL-3.0-only",
        "GPL-3.0-or-later WITH GCC-exception-3.1",
    ],
)
def test_what_lets_others_keep_their_own_licence_may_ship(licence: str) -> None:
    assert notices.may_ship(licence)


@pytest.mark.parametrize(
    "licence",
    [
        "GPL-3.0-only",
        "AGPL-3.0",
        "GPLv2+",
        "GNU General Public License v3 (GPLv3)",
        "MIT AND GPL-2.0-or-later",
    ],
)
def test_gpl_and_agpl_may_not(licence: str) -> None:
    assert not notices.may_ship(licence)


def test_the_offender_is_named() -> None:
    with pytest.raises(notices.LicenceError, match=r"ultralytics: AGPL-3\.0"):
        notices.check(
            [notices.Notice("ultralytics", "8.4", "AGPL-3.0"), notices.Notice("flask", "3", "MIT")]
        )


def test_what_says_nothing_about_its_licence_may_not_ship() -> None:
    with pytest.raises(notices.LicenceError, match="mystery: no licence"):
        notices.check([notices.Notice("mystery", "1", "")])


def test_a_library_that_nobody_has_looked_at_may_not_ship() -> None:
    found = list(notices.system_notices([["libmystery.so.1", "/usr/lib/libmystery.so.1"]]))
    with pytest.raises(notices.LicenceError, match=r"libmystery\.so\.1"):
        notices.check(found)


def test_libraries_that_come_with_python_on_windows_are_named() -> None:
    packages = "C:\\venv\\Lib\\site-packages"
    binaries = [
        ["VCRUNTIME140_1.dll", "C:\\Python\\VCRUNTIME140_1.dll"],
        ["libcrypto-3.dll", "C:\\Python\\DLLs\\libcrypto-3.dll"],
        ["_ssl.pyd", "C:\\Python\\DLLs\\_ssl.pyd"],
        ["cv2\\opencv_videoio_ffmpeg.dll", f"{packages}\\cv2\\opencv_videoio_ffmpeg.dll"],
        ["webview\\lib\\Microsoft.Web.WebView2.Core.dll", f"{packages}\\webview\\lib\\a.dll"],
    ]
    found = list(notices.windows_notices(binaries))
    assert [notice.name for notice in found] == [
        "Microsoft Edge WebView2 SDK",
        "Microsoft Visual C++ runtime",
        "OpenSSL",
    ]
    notices.check(found)
    unknown = list(notices.windows_notices([["mystery.dll", "C:\\Windows\\mystery.dll"]]))
    with pytest.raises(notices.LicenceError, match=r"mystery\.dll"):
        notices.check(unknown)


def test_the_distribution_of_a_module_is_found_with_its_text() -> None:
    found = {
        notice.name: notice for notice in notices.python_notices(["flask.app", "pinel_desktop.cli"])
    }
    assert "BSD" in found["Flask"].licence
    assert "Redistribution" in "".join(found["Flask"].texts)
    assert "pinel-desktop" not in found


def test_a_library_of_which_only_binaries_were_packed_is_found_by_its_folder() -> None:
    found = {notice.name: notice for notice in notices.python_notices(["cv2", "libssl.so.3"])}
    assert "Apache" in found["opencv-python-headless"].licence
    assert "FFmpeg" in "".join(found["opencv-python-headless"].texts)


def test_the_page_s_packages_are_named_and_the_tools_are_not() -> None:
    names = {notice.name for notice in notices.npm_notices(ROOT / "ui")}
    assert {"blockly", "preact", "@preact/signals-core"} <= names
    assert not {"vite", "typescript", "jsdom"} & names


def test_each_text_is_printed_once(tmp_path: Path) -> None:
    same = "Permission is hereby granted"
    text = notices.as_text(
        [notices.Notice("a", "1", "MIT", (same,)), notices.Notice("b", "2", "MIT", (same,))]
    )
    assert text.count(same) == 1
    assert "a 1: MIT\nb 2: MIT\n" in text


def test_every_direct_dependency_of_the_page_has_a_licence_in_the_lock_file() -> None:
    lock = json.loads((ROOT / "ui" / "package-lock.json").read_text("utf-8"))
    direct = lock["packages"][""]["dependencies"]
    assert all(lock["packages"][f"node_modules/{name}"].get("license") for name in direct)


def test_the_hand_networks_and_the_pictures_that_letters_were_learnt_from_are_named() -> None:
    networks, letters = notices.gesture_notices(ROOT)
    assert networks.version == "0.10.21"
    assert "Apache-2.0" in networks.licence
    assert "Apache License" in networks.texts[0]
    assert "Alfabeto em libras" in letters.name
    assert letters.licence == "CC-BY-4.0"
    notices.check([networks, letters])
