"""Arguments of handlers: the parts of a request, validated by the models that annotate the handler's parameters."""

from collections.abc import Callable, Mapping
from functools import cache, wraps
from typing import Any, get_type_hints

from flask import Response, request
from pydantic import ValidationError

from pinel_desktop.web.errors import invalid_request

Handler = Callable[..., Response]

_READERS: Mapping[str, Callable[[Any], object]] = {
    "path": lambda model: model.model_validate(request.view_args),
    "query": lambda model: model.model_validate(request.args.to_dict()),
    "header": lambda model: model.model_validate(dict(request.headers)),
    "body": lambda model: model.model_validate(request.get_json(silent=True)),
    "raw": lambda _: request,
}


def with_arguments(handler: Handler) -> Handler:
    """Wraps a handler for Flask. If a request does not fit the models, the response is the error `invalid_request`."""

    @wraps(handler)
    def view(**of_path: object) -> Response:
        try:
            arguments = {name: _READERS[name](kind) for name, kind in _parts_of(handler).items()}
        except ValidationError as error:
            return invalid_request(error)
        return handler(**arguments)

    return view


@cache
def _parts_of(handler: Handler) -> dict[str, Any]:
    """Returns the annotations of a handler's parameters; read at its first request."""
    hints = get_type_hints(handler)
    return {name: hints[name] for name in _READERS if name in hints}
