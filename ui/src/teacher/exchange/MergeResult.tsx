import { CircleCheck, TriangleAlert } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { Merged } from "../api/exchange";
import { TEST } from "../app/testids";
import { StillIn } from "./Deletion";
import { counted, outcome } from "./outcome";
import { words } from "./words";

interface Properties {
  merged: Merged;
  onDelete(): void;
  onKeep(): void;
}

/** What one file brought, or why it was refused. */
export function MergeResult({ merged, onDelete, onKeep }: Properties) {
  const { problem } = merged;
  const say = words.value;
  const answer = useRef<HTMLParagraphElement>(null);
  const isGone = merged.removed !== null;
  useEffect(() => {
    if (isGone) answer.current?.focus(); // the button that was pressed is no longer there
  }, [isGone]);
  const Icon = problem ? TriangleAlert : CircleCheck;
  return (
    <li class={`exchange__result exchange__result--${problem ? "problem" : "good"}`}>
      <Icon class="icon" aria-hidden="true" />
      <p ref={answer} tabIndex={-1}>
        {problem ? (
          <>
            <strong>{refusal(merged.name, problem.message)}</strong> {problem.remedy}
          </>
        ) : (
          outcome(merged, say)
        )}
      </p>
      {merged.would_delete && (
        <div class="deletion__sure" data-testid={TEST.wouldDelete}>
          <p>
            {say.doomed(
              merged.computer ?? merged.name,
              merged.would_delete.names.join(", "),
              counted(merged.would_delete, say) || say.programs(0),
            )}
          </p>
          <div class="exchange__buttons">
            <button
              type="button"
              class="button button--stop"
              data-testid={TEST.deleteToo}
              onClick={onDelete}
            >
              {say.deleteToo}
            </button>
            <button type="button" class="button" onClick={onKeep}>
              {say.keepHere}
            </button>
          </div>
        </div>
      )}
      {merged.left_in.length > 0 && (
        <div class="deletion__done">
          <StillIn paths={merged.left_in} />
        </div>
      )}
    </li>
  );
}

/** Most refusals name the file themselves. */
function refusal(name: string, message: string): string {
  return message.includes(name) ? message : `${name}: ${message}`;
}
