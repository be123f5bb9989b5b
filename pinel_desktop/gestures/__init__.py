"""Recognises signs of Libras on a hand: pictures in, letters out; no camera, no page, no clock."""

import os

# Otherwise ONNX Runtime 1.31 writes a device id into the home folder, and may send usage data; read at its import.
os.environ["ORT_DISABLE_TELEMETRY"] = "1"
