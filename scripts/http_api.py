"""Shows the HTTP interface as a page, without the app: `make api`.

RapiDoc draws docs/openapi.json. It comes with the development environment; its fonts from the internet are off.
"""

import webbrowser
from pathlib import Path
from threading import Timer

from flask import Flask, Response, redirect, send_file
from flask_openapi3_rapidoc.plugins import RegisterPlugin
from werkzeug.serving import make_server

DOCUMENT = Path(__file__).resolve().parents[1] / "docs" / "openapi.json"


def create_page() -> Flask:
    """The page at `/rapidoc`, and the document that it draws."""
    app = Flask(__name__, static_folder=None)
    app.config["RAPIDOC_CONFIG"] = {"load-fonts": "false", "render-style": "read", "theme": "light"}
    app.register_blueprint(RegisterPlugin.register(doc_url="openapi.json"))
    app.add_url_rule("/openapi.json", "document", lambda: send_file(DOCUMENT))
    app.add_url_rule("/", "start", _to_page)
    return app


def _to_page() -> Response:
    response: Response = redirect("/rapidoc")  # type: ignore[assignment]  # werkzeug's type, of which Flask's is one
    return response


if __name__ == "__main__":
    server = make_server("127.0.0.1", 0, create_page())
    address = f"http://127.0.0.1:{server.server_port}/"
    print(f"The HTTP interface: {address} (Ctrl-C ends)", flush=True)
    Timer(0.5, webbrowser.open, (address,)).start()
    server.serve_forever()
