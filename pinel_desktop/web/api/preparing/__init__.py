"""Preparing lessons: own activities, lesson files and real robots."""
