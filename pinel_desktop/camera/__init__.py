"""The camera: a process that sees signs, and the app's side of it."""
