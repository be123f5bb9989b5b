"""WebView2, the web view of Windows: blocks navigation to anything but the page.

Written from the source of pywebview 6.2 (webview/platforms/edgechromium.py); not yet run on Windows.
"""

from collections.abc import Callable
from typing import Any

from pinel_desktop.desktop.policy import NavigationDecision


def install_policy(view: Any, judge: Callable[[str], NavigationDecision]) -> None:
    """Cancels each navigation of the page and of its frames that `judge` does not show.

    Files that the page creates need no navigation: WebView2 downloads them, and pywebview asks where to.

    Args:
        view: the control `Microsoft.Web.WebView2.WinForms.WebView2`, before the page loads.
    """

    def decide(_sender: Any, navigation: Any) -> None:
        if judge(str(navigation.Uri)) != "show":
            navigation.Cancel = True

    def watch_frames(_sender: Any, _completed: Any) -> None:
        if view.CoreWebView2 is not None:  # None if WebView2 failed to start
            view.CoreWebView2.FrameNavigationStarting += decide

    view.NavigationStarting += decide
    view.CoreWebView2InitializationCompleted += watch_frames
