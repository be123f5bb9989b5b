import type { GoalPicture } from "../api/model";
import { drawnHand } from "./drawn_hand";
import { hasDrawing, SignDrawing } from "./SignDrawing";

/** The hands of the signs that decide what the robot does, beside the picture of the goal. */
export function GoalHands({ goal }: { goal: GoalPicture }) {
  const signs = [...new Set(goal.lines.map(({ sign }) => sign))].filter(
    (sign) => sign !== null && hasDrawing(sign),
  );
  if (signs.length === 0) return null;
  return (
    <span class="goal-hands row middle" aria-hidden="true">
      {signs.map((sign) => (
        <span key={sign} class="row middle" data-sign={sign}>
          <SignDrawing sign={sign ?? ""} hand={drawnHand.value} />
          {sign}
        </span>
      ))}
    </span>
  );
}
