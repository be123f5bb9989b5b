"""Which shared libraries of the building machine go into the package."""

from tests.packaging.loading import load

contents = load("packaging/contents.py")


def test_the_libraries_that_webkit_loads_too_stay_outside() -> None:
    numpy = ("numpy.libs/libgfortran-040039e1.so.5", "/venv/libgfortran-040039e1.so.5", "BINARY")
    python = ("libpython3.11.so.1.0", "/lib/libpython3.11.so.1.0", "BINARY")
    others = [
        (name, f"/lib/{name}", "BINARY") for name in ("libstdc++.so.6", "libz.so.1", "libssl.so.3")
    ]
    assert contents.without_shared([python, *others, numpy]) == [python, numpy]


def test_a_library_that_the_table_does_not_name_is_left_to_the_smoke_test() -> None:
    """Leaving it out without a word could leave the package without a part."""
    unknown = ("libgnutls.so.30", "/lib/libgnutls.so.30", "BINARY")
    assert contents.without_shared([unknown]) == [unknown]


def test_what_ships_names_its_licence() -> None:
    rows = contents.system_libraries()
    assert {row.stem for row in rows if row.ships} >= {"libpython3"}
    assert all(row.licence for row in rows if row.ships)
    assert {row.stem for row in rows if not row.ships} >= {"libstdc++", "libgcc_s", "libcrypto"}


def test_links_to_libraries_do_not_ship() -> None:
    library = ("cv2.libs/libpng.so", "/wheel/libpng.so", "BINARY")
    assert contents.without_links([library, ("libpng.so", "cv2.libs/libpng.so", "SYMLINK")]) == [
        library
    ]
