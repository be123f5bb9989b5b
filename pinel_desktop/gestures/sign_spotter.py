"""Signs in a video, at rest and in motion: which of them a hand shows, frame by frame.

A sign that moves begins and ends with a hand at rest, which looks like a letter: I begins J, D begins Z. So while
a class knows signs that move, a hand that looks like the beginning of one must rest for longer before it is a letter;
while it moves it is none; and what remains of a sign that moved is no letter until the hand moves again or goes away.
"""

from pinel_desktop.gestures.movements import HandObservation, MovementSegmenter
from pinel_desktop.gestures.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.stability import MIN_HOLD_S, Decision, FramePrediction, StabilityFilter

HOLD_BEFORE_MOVING_SIGN_S = 1.2  # so long a hand rests that might have begun a sign that moves
_NO_SIGNS = MovingSignClassifier({})


class SignSpotter:
    """Decides when a sign counts as shown. Without signs that move it is the vote alone."""

    def __init__(self) -> None:
        self._stability_filter, self._segmenter = StabilityFilter(), MovementSegmenter()
        self._signs = _NO_SIGNS
        self._is_spent = False  # what the hand shows is what remains of a sign that moved

    @property
    def progress(self) -> float:
        """How near the sign that is being counted is to a decision, 0 to 1."""
        return self._stability_filter.progress

    @property
    def label(self) -> str:
        """The sign that is being counted; "" while there is none."""
        return self._stability_filter.label

    def set_moving_signs(self, signs: MovingSignClassifier) -> None:
        """Knows these signs that move from now on."""
        self._signs = signs
        self.reset()

    def reset(self) -> None:
        """Forgets the frames so far."""
        self._stability_filter.reset()
        self._segmenter.reset()
        self._is_spent = False

    def update(self, frame: FramePrediction, is_left: bool) -> Decision | None:
        """Takes the next frame, in which a hand is the person's left one or not; gives the sign that was shown."""
        if not self._signs.signs:
            return self._stability_filter.update(frame)
        if frame.points is None:
            self._is_spent = False
            return self._stability_filter.update(frame)
        movement = self._segmenter.update(HandObservation(frame.time_s, frame.points, is_left))
        if movement is not None:
            self._stability_filter.reset()
            prediction = self._signs.predict(movement)
            if prediction.sign is not None:
                self._is_spent = True
                confidence = round(prediction.confidence, 3)
                return Decision(prediction.sign, confidence, prediction.second, is_moving=True)
        if self._segmenter.is_moving:
            self._is_spent = False
            self._stability_filter.reset()
            return None
        if self._is_spent:
            return None
        may_begin = self._signs.may_begin(frame.points, is_left=is_left)
        return self._stability_filter.update(
            frame, HOLD_BEFORE_MOVING_SIGN_S if may_begin else MIN_HOLD_S
        )
