"""A minimal pywebview program with our editor; prints when its workspace is drawn, and closes at the end of its input.

python window_bare.py INDEX_HTML
"""

import sys
import time

import webview

from pinel_desktop.desktop.ending import end_process

DRAWN = "!!document.querySelector('.blocklyDraggable')"


def watch(window: webview.Window) -> None:
    window.events.shown.wait()
    while window.run_js(DRAWN) is not True:
        time.sleep(0.01)
    print(time.monotonic(), flush=True)
    sys.stdin.read()
    window.destroy()


def main() -> None:
    window = webview.create_window("bare", sys.argv[1], width=1366, height=768, maximized=True)
    assert window is not None
    webview.start(watch, [window], gui="gtk")
    end_process(0)


main()
