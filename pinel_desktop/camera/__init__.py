"""The camera: a process that recognises signs, and the app's side of it."""
