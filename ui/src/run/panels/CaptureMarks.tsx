import { language, texts } from "../../i18n";
import { seconds } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { rove } from "../../kit/roving";
import { captureText } from "../captures/captured";
import type { CaptureAnswer } from "../reducer";

/** Answers nearer than this fraction of the strip share a mark. */
const SHARED_PART = 0.07;

interface CaptureMarksProps {
  /** In the order of the run. */
  answers: readonly CaptureAnswer[];
  /** The last tick. */
  end: number;
  onAnswers(answers: readonly CaptureAnswer[]): void;
}

/** Marks on a time strip for what captures got: a press shows it again. One stop of the Tab key. */
export function CaptureMarks({ answers, end, onAnswers }: CaptureMarksProps) {
  const length = Math.max(1, end);
  return (
    <fieldset class="captures" aria-label={texts.value.captured.marks} onKeyDown={rove}>
      {grouped(answers, length).map((group, index) => {
        const text = group.map(({ label }) => label || "–").join(" ");
        const at = `${(100 * (group[0]?.tick ?? 0)) / length}%`;
        return (
          <Button
            key={index}
            kind="bare"
            class="captures__mark"
            style={{ left: at, translate: `-${at}` }}
            label={`${text}. ${group.map(described).join("; ")}`}
            tabIndex={index === 0 ? 0 : -1}
            data-rove=""
            testId="capture-mark"
            onPress={() => onAnswers(group)}
          >
            {text}
          </Button>
        );
      })}
    </fieldset>
  );
}

const described = (answer: CaptureAnswer) =>
  `${seconds(answer.tick / 30, language.value)}: ${captureText(answer, texts.value, language.value)}`;

function grouped(answers: readonly CaptureAnswer[], length: number): CaptureAnswer[][] {
  const groups: CaptureAnswer[][] = [];
  for (const answer of answers) {
    const group = groups.at(-1);
    const isNear = group?.[0] && answer.tick - group[0].tick < SHARED_PART * length;
    if (isNear) group.push(answer);
    else groups.push([answer]);
  }
  return groups;
}
