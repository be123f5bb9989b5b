import type { CameraChangedEvent, CameraSightEvent, SeenSign } from "../../api/model";

/** A hand as the camera sees it. */
export const hand = (more: Partial<SeenSign> = {}): SeenSign => ({
  points: Array.from({ length: 21 }, (_, n) => [0.4 + n / 100, 0.5]),
  handedness: "right",
  best: "B",
  confidence: 0.97,
  second: "",
  sure: true,
  ...more,
});

/** What the camera sees: these hands. */
export const sightOf = (...hands: SeenSign[]): CameraSightEvent => ({
  type: "camera_sight",
  hands,
  label: hands.find(({ sure }) => sure)?.best ?? "",
  progress: 0,
  moved: "",
  moved_confidence: 0,
  aspect: 4 / 3,
});

/** The camera changes; with a code it is of no use. */
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
