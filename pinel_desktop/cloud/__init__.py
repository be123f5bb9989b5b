"""The process that drives one program in many realistic robots at once, so that a group sees how firm it is."""
