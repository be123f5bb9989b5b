import { CircleCheck, TriangleAlert } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { Merged } from "../../api/model";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { DeletedOnOtherPc } from "./DeletedOnOtherPc";
import { FilesLeft } from "./FilesLeft";
import { outcome } from "./outcome";

interface MergeResultProps {
  merged: Merged;
  /** Whether the file is a lesson file whose lesson is not open yet. */
  isLesson: boolean;
  /** Applies the deletion of the other PC, except for these groups and programs. */
  onDelete(retained: readonly string[]): Promise<void>;
  onDecline(): void;
}

/** Result of merging one file, or the reason of its refusal. */
export function MergeResult({ merged, isLesson, onDelete, onDecline }: MergeResultProps) {
  const { problem } = merged;
  const labels = texts.value.exchange;
  const answer = useRef<HTMLParagraphElement>(null);
  const isRemoved = merged.removed !== null || merged.kept.length > 0;
  useEffect(() => {
    if (isRemoved) answer.current?.focus(); // the pressed button no longer exists
  }, [isRemoved]);
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
          [outcome(merged, labels), isLesson && labels.lessonCame].filter(Boolean).join(" ")
        )}
      </p>
      {merged.n_unconfirmed > 0 && (
        <p class="notice-box exchange__warning">{labels.unconfirmed.came}</p>
      )}
      {merged.would_delete && (
        <DeletedOnOtherPc
          computer={merged.computer ?? merged.name}
          pending={merged.would_delete}
          onDelete={onDelete}
          onDecline={onDecline}
        />
      )}
      {merged.left_in.length > 0 && (
        <div class="deletion__done notice-box">
          <FilesLeft paths={merged.left_in} />
        </div>
      )}
    </li>
  );
}

/** Names the file unless the message does. */
function refusal(name: string, message: string): string {
  return message.includes(name) ? message : labelled(name, message);
}
