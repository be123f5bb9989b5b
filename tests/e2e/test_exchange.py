"""Work goes from PC to PC by stick, and is deleted for good."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PIN = "314159"


@pytest.fixture
def stick(tmp_path: Path) -> Path:
    folder = tmp_path / "Escola é aqui"
    folder.mkdir()
    return folder


@pytest.fixture
def other_pc(tmp_path_factory: pytest.TempPathFactory, browser: Browser) -> Iterator[Studio]:
    """The teacher's PC, with an empty file of its own."""
    app = AppProcess(tmp_path_factory.mktemp("other"))
    context = browser.new_context(locale="pt-BR", reduced_motion="reduce")
    context.set_default_timeout(15_000)
    page = context.new_page()
    page.goto(app.start())
    yield Studio(page)
    context.close()
    app.stop()


def at_the_files(studio: Studio, folder: Path) -> None:
    """Behind the door, with the folder as the school's."""
    studio.tell("PUT", "/teacher/pin", {"pin": PIN})
    studio.tell("PUT", "/folders/shared", {"path": str(folder)})
    studio.page.goto(f"{studio.origin}/#/teacher/files")
    studio.page.reload()  # the page has not heard of the PIN
    expect(studio["shared-folder"]).to_have_value(str(folder))


def test_the_work_of_one_pc_comes_to_another(studio: Studio, other_pc: Studio, stick: Path) -> None:
    studio.enter_group("Os Tatus")
    at_the_files(studio, stick)
    studio["save-bundle"].click()
    expect(studio.page.get_by_text("Salvo em")).to_contain_text("1 grupo e 0 rodadas")
    assert len(list(stick.glob("*.pinel"))) == 1

    (stick / "estragado.pinel").write_bytes(b"SQLite format 3\0 but not for long")
    at_the_files(other_pc, stick)
    other_pc["merge-files"].click()
    results = other_pc["merge-results"].get_by_role("listitem")
    expect(results).to_have_count(2)
    expect(results.filter(has_text="1 grupo, 1 programa")).to_have_count(1)
    expect(results.filter(has_text="estragado.pinel")).to_have_class(
        "exchange__result exchange__result--problem"
    )
    other_pc["merge-files"].click()
    expect(results.filter(has_text="nada novo")).to_have_count(1)
    expect(other_pc.page.get_by_role("table")).to_be_visible()
    assert violations(other_pc) == []
    other_pc["home"].click()
    expect(other_pc["group-card"].filter(has_text="Os Tatus")).to_be_visible()


def test_a_group_is_deleted_for_good(studio: Studio, stick: Path) -> None:
    studio.enter_group("Os Tatus")
    at_the_files(studio, stick)
    studio["save-bundle"].click()
    expect(studio.page.get_by_text("Salvo em")).to_be_visible()
    studio.page.goto(f"{studio.origin}/#/teacher/classes")
    studio["deletion-open"].click()
    studio["deletion-what"].select_option(label="O grupo Os Tatus")
    expect(studio.page.get_by_text("Não dá para desfazer")).to_contain_text("1 programa")
    assert violations(studio) == []
    studio.page.set_viewport_size({"width": 1024, "height": 480})
    studio["deletion-go"].click()
    done = studio["deletion-done"]
    expect(done).to_contain_text("Apagado: 1 grupo")
    expect(done.get_by_role("listitem").last).to_contain_text(".pinel")
    expect(done).to_be_focused()
    expect(done).to_be_in_viewport(ratio=1)
    assert violations(studio) == []
    assert studio.api("/groups") == {"groups": []}


def test_a_group_goes_on_with_its_program_at_another_pc(
    studio: Studio, other_pc: Studio, tmp_path: Path
) -> None:
    studio.enter_group("Os Tatus")
    studio.build_square("0,5")
    studio.wait_until_saved()
    studio["open-work"].click()
    with studio.page.expect_download() as taken:
        studio["program-file"].click()
    file = tmp_path / taken.value.suggested_filename
    taken.value.save_as(file)
    assert file.suffix == ".pinel"

    other_pc["bring-program"].set_input_files(file)
    other_pc.wait_until_open()
    expect(other_pc.blocks.by_words("andar para frente")).to_contain_text("0,5")
    expect(other_pc["header-group"]).to_contain_text("Os Tatus")
    other_pc["home"].click()
    bad = tmp_path / "foto.pinel"
    bad.write_bytes(b"no bundle")
    other_pc["bring-program"].set_input_files(bad)
    expect(other_pc.page.get_by_text("não foi exportado pelo PINEL")).to_be_visible()


def test_what_was_deleted_elsewhere_goes_when_the_teacher_says_so(
    studio: Studio, other_pc: Studio, stick: Path
) -> None:
    studio.enter_group("Os Tatus")
    at_the_files(studio, stick)
    studio["save-bundle"].click()
    expect(studio.page.get_by_text("Salvo em")).to_be_visible()
    at_the_files(other_pc, stick)
    other_pc["merge-files"].click()
    expect(other_pc["merge-results"]).to_contain_text("1 grupo")

    [group] = studio.api("/groups")["groups"]
    studio.tell("DELETE", f"/groups/{group['id']}")
    for file in stick.glob("*.pinel"):
        file.unlink()
    studio["save-bundle"].click()
    expect(studio.page.get_by_text("Salvo em")).to_contain_text("0 grupos")

    other_pc["merge-files"].click()
    expect(other_pc["would-delete"]).to_contain_text("Os Tatus")
    assert violations(other_pc) == []
    assert len(other_pc.api("/groups")["groups"]) == 1
    other_pc["delete-too"].click()
    expect(other_pc["would-delete"]).to_have_count(0)
    assert other_pc.api("/groups") == {"groups": []}


def test_answers_about_one_folder_do_not_stand_under_another(
    studio: Studio, stick: Path, tmp_path: Path
) -> None:
    studio.enter_group("Os Tatus")
    (stick / "estragado.pinel").write_bytes(b"SQLite format 3\0 but not for long")
    at_the_files(studio, stick)
    studio["save-bundle"].click()
    saved = studio.page.get_by_text("Salvo em")
    expect(saved).to_be_visible()
    expect(saved).not_to_contain_text("pendrive")
    studio["merge-files"].click()
    refused = studio["merge-results"].get_by_role("listitem").filter(has_text="estragado.pinel")
    expect(refused).not_to_contain_text(str(stick))
    studio.page.get_by_role("button", name="Procurar de novo").click()
    expect(studio["merge-results"]).to_have_count(0)
    expect(saved).to_have_count(0)

    studio["merge-files"].click()
    expect(studio["merge-results"]).to_be_visible()
    empty = tmp_path / "vazia"
    empty.mkdir()
    studio["shared-folder"].fill(str(empty))
    studio.page.get_by_role("button", name="Usar esta pasta").click()
    expect(studio.page.get_by_text("Ainda sem arquivos")).to_be_visible()
    expect(studio["merge-results"]).to_have_count(0)


def test_a_school_folder_that_does_not_answer_stays_in_its_field_and_is_named(
    studio: Studio, stick: Path
) -> None:
    studio.enter_group("Os Tatus")
    at_the_files(studio, stick)
    away = stick.rename(stick.with_name("fora"))
    studio.page.reload()
    expect(studio["shared-folder"]).to_have_value(str(stick))
    expect(studio.page.get_by_role("alert")).to_contain_text("não responde agora")
    places = studio.page.get_by_role("group")
    expect(places.filter(has_text=stick.name)).to_contain_text("não responde agora")
    expect(studio["save-bundle"]).to_have_count(0)
    away.rename(stick)
    expect(studio["save-bundle"]).to_be_visible()  # looked for again every few seconds
    expect(studio.page.get_by_text("não responde agora")).to_have_count(0)
