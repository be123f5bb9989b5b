"""A YOLO detector as a recognizer of signs: network files, detection, training, measurement."""
