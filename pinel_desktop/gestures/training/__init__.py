"""Learning the letters from a folder of labelled photographs, and measuring how well that goes."""
