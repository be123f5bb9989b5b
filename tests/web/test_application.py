"""What the first screen does not ask for is imported when somebody asks for it."""

import json
import subprocess
import sys
from pathlib import Path

CODE = """
import sys
from pathlib import Path
from pinel_desktop.app import App
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

with App(Path(sys.argv[1]), make_engine=FakeEngine, engine_after_s=600) as app:
    browser = Browser.signed_in(app.address)
    group = browser.post("/api/groups", {"name": "A"}).data
    program = browser.post(f"/api/groups/{group['id']}/programs", {"name": "P"}).data
    first = ["status", "groups", "classrooms", "teacher", "worlds", "robots", "real-robots"]
    first += [f"programs/{program['id']}"]
    answers = [browser.get(f"/api/{path}").status for path in first]
    answers += [browser.put("/api/camera/classroom", {"classroom_id": None}).status]
    heavy = {"pinel_desktop.web.routes", "flask_openapi3"}
    imported = sorted(heavy & {*sys.modules})
    later = [browser.get(f"/api/{path}").status for path in ("activities", "openapi.json", "no")]
    print([answers, imported, later, sorted(heavy & {*sys.modules})])
"""


def test_the_routes_of_other_screens_are_imported_with_their_first_request(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", CODE, str(tmp_path / "pinel.db")],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    answers, imported, later, after = json.loads(done.stdout.replace("'", '"'))
    assert answers == [200] * 9
    assert imported == []
    assert later == [200, 200, 404]
    assert {"pinel_desktop.web.routes", "flask_openapi3"} <= {*after}
