"""Work is transferred between PCs by USB stick, and deleted for good."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Route, expect

from pinel_desktop.app import App
from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.past_lesson import Step, document_of, workspace_of
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PIN = "314159"


@pytest.fixture
def stick(tmp_path: Path) -> Path:
    folder = tmp_path / "Escola é aqui"
    folder.mkdir()
    return folder


@pytest.fixture
def far_pc(tmp_path: Path) -> Iterator[Browser]:
    """The teacher at another PC, by requests only; its page is not tested."""
    with App(tmp_path / "far" / "pinel.db", make_engine=FakeEngine) as app:
        pc = Browser.signed_in(app.address)
        pc.put("/api/teacher/pin", {"pin": PIN})
        yield pc


def make_group(pc: Browser | Studio, name: str = "Os Tatus", classroom: str | None = None) -> str:
    """Creates a group with its first program; returns the group's id."""
    group: str = ask(pc, "POST", "/groups", {"name": name, "classroom_id": classroom})["id"]
    ask(pc, "POST", f"/groups/{group}/programs", {"name": "Programa 1"})
    return group


def ask(pc: Browser | Studio, method: str, path: str, body: Any = None) -> Any:
    if isinstance(pc, Studio):
        return pc.send(method, path, body)
    answer = pc.send(method, f"/api{path}", body)
    assert answer.status < 300, answer.text
    return answer.data


def save_bundle(pc: Browser | Studio, folder: Path) -> str:
    """Saves the PC's work as the button does; returns the file."""
    return str(ask(pc, "POST", "/bundles", {"folder": str(folder)})["path"])


def at_the_files(studio: Studio, folder: Path) -> None:
    """Opens the exchange panel with `folder` as the shared folder."""
    studio.send("PUT", "/teacher/pin", {"pin": PIN})
    studio.send("PUT", "/folders/shared", {"path": str(folder)})
    studio.page.goto(f"{studio.origin}/#/teacher/files")
    studio.page.reload()  # the open page does not know the PIN
    expect(studio["shared-folder"]).to_have_value(str(folder))


def test_the_work_of_one_pc_comes_to_another(studio: Studio, far_pc: Browser, stick: Path) -> None:
    (program,) = ask(far_pc, "GET", f"/groups/{make_group(far_pc)}/programs")["programs"]
    steps: list[Step] = [("turn", 90)]
    version = {"workspace": workspace_of(steps), "document": document_of(steps)}
    ask(far_pc, "POST", f"/programs/{program['id']}/versions", version)
    save_bundle(far_pc, stick)
    (stick / "estragado.pinel").write_bytes(b"SQLite format 3\0 but not for long")
    at_the_files(studio, stick)
    studio["merge-files"].click()
    results = studio["merge-results"].get_by_role("listitem")
    expect(results).to_have_count(2)
    expect(results.filter(has_text="1 grupo, 1 programa")).to_have_count(1)
    expect(results.filter(has_text="estragado.pinel")).to_have_class(
        "exchange__result exchange__result--problem"
    )
    studio["merge-files"].click()
    expect(results.filter(has_text="nada de novo")).to_have_count(1)
    expect(studio.page.get_by_role("table")).to_be_visible()
    assert violations(studio, "merge-results") == []
    expect(studio["merged-lesson"]).to_have_count(1)  # both times the same
    studio["merged-lesson"].click()
    expect(studio["review-group"]).to_have_attribute("data-name", "Os Tatus")
    studio["home"].click()
    expect(studio["group-card"].filter(has_text="Os Tatus")).to_be_visible()


def test_a_double_click_on_a_file_leads_the_teacher_of_an_open_pinel_to_it(
    studio: Studio, far_pc: Browser, stick: Path, watch: Watch, tmp_path: Path
) -> None:
    make_group(far_pc)
    file = Path(save_bundle(far_pc, stick))
    file = file.rename(stick / "turma; rm -rf $HOME %n.pinel")
    (stick / "outro.pinel").write_bytes(file.read_bytes())
    at_the_files(studio, stick)
    studio.send("POST", "/teacher/leave", {})
    studio.page.goto(f"{studio.origin}/#/practice")
    studio.page.reload()
    watch.expect("403 (FORBIDDEN)")  # before the PIN
    double_click(tmp_path, stick / "foto.pinel")
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["opened-file"]).to_contain_text("foto.pinel")
    expect(studio["opened-file"]).to_contain_text("Não há um arquivo em foto.pinel.")
    assert violations(studio, "opened-file") == []
    double_click(tmp_path, file)
    expect(studio["opened-file"].get_by_role("checkbox")).to_be_checked()
    expect(studio["merge-files"]).to_have_text("Juntar 1 arquivo")
    assert violations(studio, "opened-file") == []
    assert studio.api("/groups") == {"groups": []}
    studio["merge-files"].click()
    expect(studio["merge-results"]).to_contain_text("1 grupo, 1 programa")
    expect(studio["opened-file"]).to_have_count(0)


def double_click(home: Path, file: Path) -> None:
    """Starts PINEL with a file while it is open, as the desktop does at a double click on it."""
    subprocess.run(
        [sys.executable, "-m", "pinel_desktop", str(file)],
        env=os.environ | {"PINEL_HOME": str(home)},
        capture_output=True,
        timeout=60,
        check=True,
    )


def test_a_group_is_deleted_for_good(studio: Studio, stick: Path) -> None:
    make_group(studio)
    at_the_files(studio, stick)
    save_bundle(studio, stick)
    studio.page.goto(f"{studio.origin}/#/teacher/classes")
    studio["deletion-open"].click()
    studio["deletion-what"].select_option(label="O grupo Os Tatus")
    expect(studio.page.get_by_text("Não dá para desfazer")).to_contain_text("1 programa")
    assert violations(studio, "deletion-what") == []
    studio.page.set_viewport_size({"width": 1024, "height": 480})
    studio["deletion-go"].click()
    done = studio["deletion-done"]
    expect(done).to_contain_text("Apagado: 1 grupo")
    expect(done.get_by_role("listitem").last).to_contain_text(".pinel")
    expect(done).to_be_focused()
    expect(done).to_be_in_viewport(ratio=1)
    assert violations(studio, "deletion-done") == []
    assert studio.api("/groups") == {"groups": []}


def test_a_group_goes_on_with_its_program_at_another_pc(
    studio: Studio, open_pc: OpenStudio, watch: Watch, tmp_path: Path
) -> None:
    watch.expect("422 (UNPROCESSABLE ENTITY)")  # response for the file that is no bundle
    enter_made_group(studio, [("move_forward", 0.5)])
    studio["open-work"].click()
    with studio.page.expect_download() as download:
        studio["program-file"].click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    assert file.suffix == ".pinel"

    other_pc = open_pc()
    other_pc["bring-program"].set_input_files(file)
    other_pc.wait_until_open()
    expect(other_pc.blocks.by_text("andar para frente")).to_contain_text("0,5")
    expect(other_pc["header-group"]).to_contain_text("Os Tatus")
    other_pc["home"].click()
    bad = tmp_path / "foto.pinel"
    bad.write_bytes(b"no bundle")
    other_pc["bring-program"].set_input_files(bad)
    refused = other_pc.page.get_by_text("O arquivo foto.pinel não foi exportado pelo PINEL")
    expect(refused).to_be_visible()


def test_the_class_of_a_brought_group_is_the_one_at_the_start(
    studio: Studio, far_pc: Browser, tmp_path: Path
) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": PIN})
    for pc, name in ((far_pc, "7º B"), (studio, "9º A")):
        make_group(pc, f"Do {name}", ask(pc, "POST", "/classrooms", {"name": name})["id"])
    studio.page.reload()
    [group] = ask(far_pc, "GET", "/groups")["groups"]
    [program] = ask(far_pc, "GET", f"/groups/{group['id']}/programs")["programs"]
    file = tmp_path / "Programa.pinel"
    file.write_bytes(far_pc.get(f"/api/programs/{program['id']}/file").body)

    expect(studio["class-chip"]).to_have_text(["9º A"])
    studio["bring-program"].set_input_files(file)
    studio.wait_until_open()
    studio["home"].click()
    expect(studio["group-card"]).to_contain_text("Do 7º B")
    studio["class-chip"].filter(has_text="9º A").click()
    expect(studio["group-card"]).to_contain_text("Do 9º A")


def test_what_was_deleted_elsewhere_goes_when_the_teacher_says_so(
    studio: Studio, far_pc: Browser, stick: Path
) -> None:
    group = make_group(far_pc)
    old = save_bundle(far_pc, stick)
    ask(far_pc, "DELETE", f"/groups/{group}")
    save_bundle(far_pc, stick)
    at_the_files(studio, stick)
    ask(studio, "POST", "/bundles/merge", {"paths": [old]})

    expect(studio["found-file"]).to_have_count(2)
    studio["merge-files"].click()
    expect(studio["would-delete"]).to_contain_text(
        "Os Tatus, Programa 1 (aqui ainda há 1 grupo, 1 programa)"
    )
    assert violations(studio, "would-delete") == []
    assert len(studio.api("/groups")["groups"]) == 1
    studio.page.reload()  # nobody has decided
    expect(studio["undecided"]).to_contain_text("o que aqui ainda há: 1 grupo, 1 programa")
    assert violations(studio, "undecided") == []
    studio["undecided"].get_by_role("button").click()
    expect(studio["would-delete"]).to_contain_text("Os Tatus, Programa 1")
    expect(studio["undecided"]).to_have_count(0)
    studio["merge-files"].click()
    studio["delete-too"].click()
    expect(studio["would-delete"]).to_have_count(0)
    expect(studio["merge-results"]).to_contain_text("Apagado: 1 grupo, 1 programa.")
    expect(studio["merge-results"].locator("p").first).to_be_focused()
    expect(studio["merge-results"]).to_contain_text("Não volta, porque foi apagado para sempre")
    assert studio.api("/groups") == {"groups": []}
    studio["merge-files"].click()
    expect(studio["merge-results"]).to_contain_text(
        "nada de novo. Não volta, porque foi apagado para sempre: 1 grupo, 1 programa"
    )
    assert studio.api("/groups") == {"groups": []}


def test_a_group_that_was_moved_is_named_and_stays_everywhere(
    studio: Studio, far_pc: Browser, stick: Path
) -> None:
    old = ask(far_pc, "POST", "/classrooms", {"name": "8º B"})["id"]
    moved, _ = (
        ask(far_pc, "POST", "/groups", {"name": name, "classroom_id": old})["id"]
        for name in ("Os Tatus", "As Araras")
    )
    at_the_files(studio, stick)
    ask(studio, "POST", "/bundles/merge", {"paths": [save_bundle(far_pc, stick)]})
    ask(far_pc, "DELETE", f"/classrooms/{old}")
    save_bundle(far_pc, stick)
    new = studio.send("POST", "/classrooms", {"name": "9º B"})["id"]
    studio.send("PATCH", f"/groups/{moved}", {"classroom_id": new})
    studio.send("POST", f"/groups/{moved}/programs", {"name": "Volta"})

    expect(studio["found-file"]).to_have_count(2)
    studio["merge-files"].click()
    tatus = studio["can-keep"].filter(has_text="Os Tatus")
    expect(tatus).to_contain_text("Está agora na turma 9º B. Mais novo aqui: 1 programa")
    expect(tatus.get_by_role("checkbox")).to_be_checked()
    araras = studio["can-keep"].filter(has_text="As Araras").get_by_role("checkbox")
    expect(araras).not_to_be_checked()
    assert violations(studio, "can-keep") == []
    studio["delete-too"].click()
    expect(studio["merge-results"]).to_contain_text("Mantido em todos os computadores: Os Tatus")
    assert [one["id"] for one in studio.api("/groups")["groups"]] == [moved]
    ask(far_pc, "POST", "/bundles/merge", {"paths": [save_bundle(studio, stick)]})
    [back] = ask(far_pc, "GET", "/groups")["groups"]
    assert (back["id"], back["n_programs"]) == (moved, 1)


def test_a_file_without_names_is_merged_only_when_it_is_ticked(studio: Studio, stick: Path) -> None:
    make_group(studio)
    at_the_files(studio, stick)
    studio.page.get_by_label("Sem nomes nem textos").check()
    studio["save-bundle"].click()
    expect(studio.page.get_by_text("Salvo em PINEL-sem-nomes-")).to_be_visible()
    file = studio["found-file"].filter(has_text="Sem nomes")
    expect(file.get_by_role("checkbox")).not_to_be_checked()
    expect(studio["merge-files"]).to_have_count(0)
    studio.page.get_by_label("Sem nomes nem textos").uncheck()
    studio["save-bundle"].click()
    own = studio["found-file"].filter(has_text="Deste computador")
    expect(own).to_have_count(1)
    expect(own.get_by_role("checkbox")).not_to_be_checked()  # it brings nothing
    own.get_by_role("checkbox").check()
    studio["merge-files"].click()
    expect(studio["merge-results"].get_by_role("listitem")).to_have_count(1)
    own.get_by_role("checkbox").uncheck()
    assert len(studio.api("/groups")["groups"]) == 1

    file.get_by_role("checkbox").check()
    expect(studio.page.get_by_text("aparecem duas vezes")).to_be_visible()
    assert violations(studio, "found-file") == []
    studio["merge-files"].click()
    expect(studio["merge-results"]).to_contain_text("Vieram sem nomes")
    assert len(studio.api("/groups")["groups"]) == 2


def test_what_lies_in_the_bin_is_counted_with_the_group(studio: Studio, stick: Path) -> None:
    [program] = studio.api(f"/groups/{make_group(studio)}/programs")["programs"]
    studio.send("DELETE", f"/programs/{program['id']}")
    studio.page.reload()
    expect(studio["group-card"]).to_contain_text("1 programa na lixeira · 0 rodadas")
    at_the_files(studio, stick)
    studio.page.goto(f"{studio.origin}/#/teacher/classes")
    expect(studio["class-group"]).to_contain_text("1 programa na lixeira")
    studio["deletion-open"].click()
    studio["deletion-what"].select_option(label="O grupo Os Tatus")
    warning = studio.page.get_by_text("Não dá para desfazer")
    expect(warning).to_contain_text("1 programa (1 na lixeira) e 0 rodadas")


def test_classes_of_the_same_name_are_distinguished(
    studio: Studio, far_pc: Browser, stick: Path
) -> None:
    studio.send("PUT", "/teacher/pin", {"pin": PIN})
    for pc, name in ((far_pc, "PC 1"), (studio, "PC 2")):
        ask(pc, "PATCH", "/computer", {"name": name})
        classroom = ask(pc, "POST", "/classrooms", {"name": "7º B"})["id"]
        ask(pc, "POST", f"/classrooms/{classroom}/lessons", {"title": f"Aula no {name}"})
    ask(studio, "POST", "/bundles/merge", {"paths": [save_bundle(far_pc, stick)]})
    studio.page.reload()
    for place in ("/#/", "/#/teacher/lessons", "/#/teacher/classes"):
        studio.page.goto(studio.origin + place)
        expect(studio["class-chip"]).to_have_text(["7º B · PC 1", "7º B · PC 2"])


def test_answers_about_one_folder_do_not_stand_under_another(
    studio: Studio, stick: Path, tmp_path: Path
) -> None:
    make_group(studio)
    (stick / "estragado.pinel").write_bytes(b"SQLite format 3\0 but not for long")
    at_the_files(studio, stick)
    studio["save-bundle"].click()
    saved = studio.page.get_by_text("Salvo em")
    expect(saved).to_contain_text("1 grupo e 0 rodadas")
    assert len(list(stick.glob("*.pinel"))) == 2
    expect(saved).not_to_contain_text("pendrive")
    studio["merge-files"].click()
    refused = studio["merge-results"].get_by_role("listitem").filter(has_text="estragado.pinel")
    expect(refused).not_to_contain_text(str(stick))
    studio.page.get_by_role("button", name="Procurar de novo").click()
    expect(studio["merge-results"]).to_have_count(0)
    expect(saved).to_have_count(0)

    studio["merge-files"].click()
    # each result that arrives moves what is below it
    expect(studio["merge-results"].get_by_role("listitem")).to_have_count(1)
    empty = tmp_path / "vazia"
    empty.mkdir()
    studio["shared-folder"].fill(str(empty))
    studio.page.get_by_role("button", name="Usar esta pasta").click()
    expect(studio.page.get_by_text("Ainda sem arquivos")).to_be_visible()
    expect(studio["merge-results"]).to_have_count(0)
    with studio.page.expect_response("**/api/folders/shared"):
        studio["shared-backups"].check()
    studio.page.reload()
    expect(studio["shared-backups"]).to_be_checked()


def test_a_merging_that_goes_on_while_somebody_looks_again_shows_nothing_later(
    studio: Studio, far_pc: Browser, stick: Path
) -> None:
    make_group(far_pc)
    at_the_files(studio, stick)
    save_bundle(far_pc, stick)
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    studio.page.route("**/api/bundles/merge", hold)
    studio["merge-files"].click()
    studio.eventually(lambda: len(held), 1)
    studio.page.get_by_role("button", name="Procurar de novo").click()
    held[0].continue_()
    expect(studio["merge-files"]).not_to_have_attribute("aria-busy", "true")
    expect(studio["merge-results"]).to_have_count(0)


def test_a_school_folder_that_does_not_answer_stays_in_its_field_and_is_named(
    studio: Studio, stick: Path
) -> None:
    make_group(studio)
    at_the_files(studio, stick)
    away = stick.rename(stick.with_name("fora"))
    studio.page.reload()
    expect(studio["shared-folder"]).to_have_value(str(stick))
    expect(studio.page.get_by_role("alert")).to_contain_text("não responde agora")
    places = studio.page.get_by_role("group")
    expect(places.filter(has_text=stick.name)).to_contain_text("não responde agora")
    expect(studio["save-bundle"]).to_have_count(0)
    away.rename(stick)
    expect(studio["save-bundle"]).to_be_visible()  # the page checks again every few seconds
    expect(studio.page.get_by_text("não responde agora")).to_have_count(0)
