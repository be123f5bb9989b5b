"""Repositories for classes, groups, lessons, taught signs, programs, versions, notes, settings and computers."""
