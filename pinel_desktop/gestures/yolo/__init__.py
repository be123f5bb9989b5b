"""YOLO detectors as recognizers of signs."""
