"""Repositories for classes, groups, lessons, programs, versions, notes, settings and computers."""
