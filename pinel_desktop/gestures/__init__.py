"""Recognises signs of Libras on a hand: pictures in, letters out; no camera, no page, no clock."""
