"""OpenCV, loaded with limits: everything that needs it imports it from here, since it reads them while it is loaded."""

import os

# a small file can claim to be a picture of any size
os.environ.setdefault("OPENCV_IO_MAX_IMAGE_PIXELS", str(100_000_000))
# what is wrong with a camera is told in words of our own
os.environ.setdefault("OPENCV_LOG_LEVEL", "SILENT")

import cv2

__all__ = ["cv2"]
