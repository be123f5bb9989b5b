import type {
  CameraChangedEvent,
  CameraSightEvent,
  DetectedHand,
  DetectedNumber,
} from "../../api/model";

const POINTS = Array.from({ length: 21 }, (_, n) => [0.4 + n / 100, 0.5]);

const boxOf = (points: number[][]) => {
  const [xs, ys] = [points.map(([x = 0]) => x), points.map(([, y = 0]) => y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
};

/** A detected hand. */
export const hand = (more: Partial<DetectedHand> = {}): DetectedHand => ({
  box: boxOf(more.points ?? POINTS),
  points: POINTS,
  handedness: "right",
  best: "B",
  confidence: 0.97,
  second: "",
  sure: true,
  ...more,
});

/** The result of a frame with these hands. */
export const sightOf = (...hands: DetectedHand[]): CameraSightEvent => ({
  type: "camera_sight",
  hands,
  label: hands.find(({ sure }) => sure)?.best ?? "",
  progress: 0,
  moved: "",
  moved_confidence: 0,
  aspect: 4 / 3,
  number: null,
});

/** The result of a frame while a capture waits for a number: one hand with this number. */
export const numberOf = (more: Partial<DetectedNumber> = {}): CameraSightEvent => ({
  ...sightOf(hand({ best: "", sure: false })),
  number: { best: "3", confidence: 0.99, second: "4", sure: true, progress: 0.5, ...more },
});

/** A change of the camera's state; a code stands for a problem. */
export const changed = (
  state: CameraChangedEvent["state"],
  code: string | null = null,
): CameraChangedEvent => ({
  type: "camera_state",
  state,
  code,
  params: code ? { number: 1 } : {},
  message: code ? "Não há câmera." : "",
  remedy: code ? "Liguem o cabo." : "",
});
