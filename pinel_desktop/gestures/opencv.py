"""OpenCV with limits. Import `cv2` from here only: OpenCV reads the limits while it is loaded."""

import os

# the header of a small file can declare a picture of any size
os.environ.setdefault("OPENCV_IO_MAX_IMAGE_PIXELS", str(100_000_000))
# the app reports camera problems with messages of its own
os.environ.setdefault("OPENCV_LOG_LEVEL", "SILENT")

import cv2

__all__ = ["cv2"]
