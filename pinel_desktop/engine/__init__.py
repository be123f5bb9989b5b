"""The process that executes live runs: messages in, events out."""
