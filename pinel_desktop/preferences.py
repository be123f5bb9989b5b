"""What a person chose for this PC: language and camera, and what the page keeps."""

import contextlib
from typing import Any

from pinel_desktop.messages import LANGUAGES, language_of_system
from pinel_desktop.page_settings import PAGE_LANGUAGE, PageSettings
from storage import Store, StoreError

_FIRST_CAMERA = "0"


class Preferences:
    """Kept in the store where it can be written, else until the app ends.

    Attributes:
        page: what the page keeps.
    """

    def __init__(self, store: Store, page: PageSettings) -> None:
        self._store, self.page = store, page
        language, camera = self._kept("language"), self._kept("camera")
        self._language: str = language if language in LANGUAGES else language_of_system()
        self._camera: str = camera if isinstance(camera, str) else _FIRST_CAMERA
        if language in LANGUAGES:
            self._tell_page()

    @property
    def language(self) -> str:
        """Of page and messages."""
        return self._language

    @language.setter
    def language(self, language: str) -> None:
        self._language = language
        self._keep("language", language)
        self._tell_page()

    @property
    def camera(self) -> str:
        """Number of the webcam to look through, "0" for the first."""
        return self._camera

    @camera.setter
    def camera(self, camera: str) -> None:
        self._camera = camera
        self._keep("camera", camera)

    def _tell_page(self) -> None:
        """The page is served in its language before the store is open."""
        if self.page.values.get(PAGE_LANGUAGE) != self._language:
            self.page.keep(PAGE_LANGUAGE, self._language)

    def _kept(self, key: str) -> Any:
        with contextlib.suppress(StoreError):
            return self._store.settings.get(key)

    def _keep(self, key: str, value: str) -> None:
        with contextlib.suppress(StoreError):
            self._store.settings.set(key, value)
