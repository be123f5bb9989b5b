"""Prints the OpenAPI description, from which `npm run types` in ui/ generates the page's types."""

from pinel_desktop.web.description import description_text

if __name__ == "__main__":
    print(description_text(), end="")
