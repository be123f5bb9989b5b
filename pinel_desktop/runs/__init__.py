"""A run as one value (`RunSpec`): its start, recorded inputs, verification and plots."""
