import { CircleQuestionMark } from "lucide-preact";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { figureWords, words } from "../i18n/review";
import { spell } from "./mark_words";
import type { FigureName, Figures } from "./model";
import { rove } from "./roving";
import { hideTip, showTip } from "./tip";

export const FIGURES: readonly FigureName[] = [
  "n_edits",
  "n_runs",
  "n_failed",
  "time_to_first_run_s",
  "attempts_until_passed",
  "active_s",
];

/** What was counted of a group; each number says what it counts. */
export function FigureRow({ group, figures }: { group: string; figures: Figures }) {
  const texts = words.value.figures;
  return (
    <ul class="figures" aria-label={texts.label(group)} onKeyDown={rove}>
      {FIGURES.map((name, index) => (
        <li key={name}>
          <Figure name={name} value={figures[name]} first={index === 0} />
        </li>
      ))}
    </ul>
  );
}

interface FigureProps {
  name: FigureName;
  value: number | null;
  first: boolean;
}

function Figure({ name, value, first }: FigureProps) {
  const texts = words.value.figures;
  const shown = value === null ? texts.unknown : inWords(name, value);
  const unit = texts[name](value ?? 0);
  const show = (event: { currentTarget: HTMLElement }) =>
    showTip(event.currentTarget, () => {
      const { message, remedy } = figureWords(name);
      return { title: message, lines: [remedy] };
    });
  return (
    <button
      type="button"
      class="figure"
      tabIndex={first ? 0 : -1}
      data-rove
      data-testid={TEST.reviewFigure}
      data-name={name}
      data-value={value ?? ""}
      aria-label={texts.ask(`${shown} ${unit}`)}
      onClick={show}
      onMouseEnter={show}
      onFocus={show}
      onMouseLeave={(event) => hideTip(event.currentTarget)}
      onBlur={(event) => hideTip(event.currentTarget)}
    >
      <b>{shown}</b> {unit}
      <CircleQuestionMark class="icon figure__ask" aria-hidden="true" />
    </button>
  );
}

function inWords(name: FigureName, value: number): string {
  return name.endsWith("_s") ? spell(value, language.value) : String(value);
}
