"""Sign spotting in a video: decides frame by frame which sign, at rest or moving, a hand shows.

A moving sign starts and ends with a hand at rest, which has the shape of a letter: J starts as I, Z as D. So if a class
has taught moving signs, three rules hold:

- A hand with the shape of a moving sign's start must rest for longer before it counts as a letter.
- A hand in motion is no letter.
- After a moving sign, the hand is no letter until it moves again or leaves the frame.
"""

from pinel_desktop.gestures.moving.movements import HandObservation, MovementSegmenter
from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.stability import MIN_HOLD_S, Decision, FramePrediction, StabilityFilter

HOLD_BEFORE_MOVING_SIGN_S = 1.2  # hold time required while a taught movement may still start
_NO_SIGNS = MovingSignClassifier({})


class SignSpotter:
    """Decides when a sign counts as shown. Without moving signs, only the stability filter decides."""

    def __init__(self) -> None:
        self._stability_filter, self._segmenter = StabilityFilter(), MovementSegmenter()
        self._signs = _NO_SIGNS
        self._is_spent = False  # the hand rests after a moving sign, and is no letter

    @property
    def progress(self) -> float:
        """Progress of the candidate sign towards a decision, 0 to 1."""
        return self._stability_filter.progress

    @property
    def label(self) -> str:
        """The candidate sign; "" if there is none."""
        return self._stability_filter.label

    def set_moving_signs(self, signs: MovingSignClassifier) -> None:
        """Replaces the classifier of moving signs."""
        self._signs = signs
        self.reset()

    def set_recognizer(self, min_confidence: float, signs: MovingSignClassifier | None) -> None:
        """Prepares for the frames of another recognizer.

        Args:
            min_confidence: mean confidence from which a steady sign counts.
            signs: the moving signs that it can recognize; None for none.
        """
        self._stability_filter = StabilityFilter(min_confidence)
        self.set_moving_signs(signs or _NO_SIGNS)

    def reset(self) -> None:
        """Discards all frames."""
        self._stability_filter.reset()
        self._segmenter.reset()
        self._is_spent = False

    def update(self, frame: FramePrediction, is_left: bool) -> Decision | None:
        """Adds the next frame; returns the decision that falls with it, or None.

        Args:
            is_left: whether the frame shows the person's left hand.
        """
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
