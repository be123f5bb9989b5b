"""Preparing lessons: own activities, presets of classes, the file that takes a lesson to all PCs, real robots."""
