"""Signs in a video, at rest and in motion: which of them a hand shows, frame by frame.

A sign that moves begins and ends with a hand at rest, which looks like a letter: I begins J, D begins Z. So while
a class knows signs that move, a hand that looks like the beginning of one must rest for longer before it is a letter;
while it moves it is none; and what remains of a sign that moved is no letter until the hand moves again or goes away.
"""

from pinel_desktop.gestures.movements import Glimpse, MovementWatch
from pinel_desktop.gestures.moving_signs import MovingSigns
from pinel_desktop.gestures.vote import LEAST_S, Ballot, Decision, Vote

HELD_S = 1.2  # so long a hand rests that might have begun a sign that moves
_NO_SIGNS = MovingSigns({})


class SignWatch:
    """Decides when a sign counts as shown. Without signs that move it is the vote alone."""

    def __init__(self) -> None:
        self._vote, self._movements = Vote(), MovementWatch()
        self._signs = _NO_SIGNS
        self._is_spent = False  # what the hand shows is what remains of a sign that moved

    @property
    def progress(self) -> float:
        """How near the sign that is being counted is to a decision, 0 to 1."""
        return self._vote.progress

    @property
    def label(self) -> str:
        """The sign that is being counted; "" while there is none."""
        return self._vote.label

    def know(self, signs: MovingSigns) -> None:
        """Knows these signs that move from now on."""
        self._signs = signs
        self.begin_anew()

    def begin_anew(self) -> None:
        """Forgets the frames so far."""
        self._vote.begin_anew()
        self._movements.begin_anew()
        self._is_spent = False

    def see(self, frame: Ballot, is_left: bool) -> Decision | None:
        """Takes the next frame, in which a hand is the person's left one or not; gives the sign that was shown."""
        if not self._signs.signs:
            return self._vote.count(frame)
        if frame.points is None:
            self._is_spent = False
            return self._vote.count(frame)
        movement = self._movements.see(Glimpse(frame.time_s, frame.points, is_left))
        if movement is not None:
            self._vote.begin_anew()
            reading = self._signs.read(movement)
            if reading.sign is not None:
                self._is_spent = True
                confidence = round(reading.confidence, 3)
                return Decision(reading.sign, confidence, reading.second, is_moving=True)
        if self._movements.is_moving:
            self._is_spent = False
            self._vote.begin_anew()
            return None
        if self._is_spent:
            return None
        may_begin = self._signs.may_begin(frame.points, is_left=is_left)
        return self._vote.count(frame, HELD_S if may_begin else LEAST_S)
