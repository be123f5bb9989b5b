"""Commands for many runs: what they share, and `pinel sweep`."""
