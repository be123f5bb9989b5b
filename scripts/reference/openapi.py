"""Prints the OpenAPI description; `npm run types` in ui/ makes the page's TypeScript types from it."""

from pinel_desktop.web.routes import description_text

if __name__ == "__main__":
    print(description_text(), end="")
