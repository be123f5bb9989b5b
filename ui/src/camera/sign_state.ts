import type { CameraSightEvent, DetectedHand } from "../api/model";

/** Summary of the detected hands, for display. */
export type SignState =
  | { readonly kind: "blind" | "no hand" | "no letter" | "two signs" }
  | ({ readonly kind: "unsure" | "sure" } & Pick<DetectedHand, "best" | "second" | "confidence">);

/** Summarises a frame while a capture waits for a number, whatever signs the hands show. */
export function numberStateOf(sight: CameraSightEvent | null): SignState {
  if (!sight?.number) return { kind: "blind" };
  const { best, second, confidence, sure } = sight.number;
  if (best === "") return { kind: sight.hands.length > 0 ? "no letter" : "no hand" };
  if (sure) return { kind: "sure", best, second, confidence };
  // a doubt is told in the order of counting, so that it does not change places from frame to frame
  const [one = best, other = second] = [best, second].sort((a, b) => Number(a) - Number(b));
  return { kind: "unsure", best: one, second: other, confidence };
}

/**
 * Summarises a frame by the rules of a capture: a movement that has just ended counts; two hands
 * with different signs do not.
 */
export function signStateOf(sight: CameraSightEvent | null): SignState {
  if (!sight) return { kind: "blind" };
  if (sight.moved) {
    return { kind: "sure", best: sight.moved, second: "", confidence: sight.moved_confidence };
  }
  const sure = sight.hands.filter((hand) => hand.sure);
  if (new Set(sure.map(({ best }) => best)).size > 1) return { kind: "two signs" };
  const hand = sure[0] ?? sight.hands[0];
  if (!hand) return { kind: "no hand" };
  const { best, second, confidence } = hand;
  if (best === "") return { kind: "no letter" };
  return { kind: sure.length > 0 ? "sure" : "unsure", best, second, confidence };
}
