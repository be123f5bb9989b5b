"""`python -m pinel_desktop` is `pinel`."""

from pinel_desktop.cli import main

main()
