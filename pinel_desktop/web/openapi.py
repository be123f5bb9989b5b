"""Prints the OpenAPI description; the page's TypeScript types are made from it.

python -m pinel_desktop.web.openapi > ui/src/api/openapi.json
"""

from pinel_desktop.web.routes import description_text

if __name__ == "__main__":
    print(description_text(), end="")
