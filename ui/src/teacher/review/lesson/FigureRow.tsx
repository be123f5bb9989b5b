import { CircleQuestionMark } from "lucide-preact";
import type { Figures, OpenedHints } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { rove } from "../../../kit/roving";
import { roundDuration } from "../../time_words";
import { hideTip, showTip } from "../marks/tip";
import type { FigureName } from "../model";
import { figureWords } from "../words";

export const FIGURES: readonly FigureName[] = [
  "n_edits",
  "n_runs",
  "n_failed",
  "time_to_first_run_s",
  "attempts_until_passed",
  "n_hints",
  "active_s",
];

interface FigureRowProps {
  group: string;
  figures: Figures;
  hints: readonly OpenedHints[];
}

/** The figures of a group, each with a tooltip that explains it. */
export function FigureRow({ group, figures, hints }: FigureRowProps) {
  const say = texts.value.review.figures;
  return (
    <ul class="figures" aria-label={say.label(group)} onKeyDown={rove}>
      {FIGURES.map((name, index) => (
        <li key={name}>
          <Figure
            name={name}
            value={figures[name]}
            first={index === 0}
            more={name === "n_hints" ? hintLines(hints) : []}
          />
        </li>
      ))}
    </ul>
  );
}

interface FigureProps {
  name: FigureName;
  value: number | null;
  first: boolean;
  /** Lines of its tooltip that say what was counted. */
  more: readonly string[];
}

function Figure({ name, value, first, more }: FigureProps) {
  const say = texts.value.review.figures;
  const shown = value === null ? say.unknown : inWords(name, value);
  const unit = say[name](value ?? 0);
  const show = (event: { currentTarget: HTMLElement }) =>
    showTip(event.currentTarget, () => {
      const { message, remedy } = figureWords(name);
      return { title: message, lines: [...more, remedy] };
    });
  return (
    <Button
      kind="bare"
      class="figure aside"
      tabIndex={first ? 0 : -1}
      data-rove
      testId="review-figure"
      data-name={name}
      data-value={value ?? ""}
      label={say.ask(`${shown} ${unit}`)}
      onPress={show}
      onMouseEnter={show}
      onFocus={show}
      onMouseLeave={(event) => hideTip(event.currentTarget)}
      onBlur={(event) => hideTip(event.currentTarget)}
    >
      <b>{shown}</b> {unit}
      <CircleQuestionMark class="icon figure__ask" aria-hidden="true" />
    </Button>
  );
}

/** Which hints of each activity were opened. */
function hintLines(hints: readonly OpenedHints[]): string[] {
  const { detail } = texts.value.review;
  return hints.map(({ title, n }) => `${title}: ${detail.hintsRead(n)}.`);
}

function inWords(name: FigureName, value: number): string {
  return name.endsWith("_s") ? roundDuration(value, language.value) : String(value);
}
