"""Trains detectors, and compares them with the landmarks."""
