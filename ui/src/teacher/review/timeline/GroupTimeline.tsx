import { useRef } from "preact/hooks";
import type { TimelineEntry } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { rove } from "../../../kit/roving";
import { hashOf } from "../../../shell/route";
import { roundDuration, timeOfDay } from "../../time_format";
import { shortDay } from "../days";
import { outcomeOf } from "../model";
import { OutcomeIcon } from "../OutcomeIcon";
import { type TimelineIndex, textOf } from "../timeline_entries/timeline_texts";
import { hideTip, isTipOf, showTip, TIP_ID, tip } from "../timeline_entries/tip";
import { differenceOf } from "../timeline_entries/version_differences";
import { barHeight, type PlacedEvent, type Tick, type TimelineLayout } from "./timeline_layout";

/** Vertical position of the base line, and total height; pixels, as in lesson.css. */
const BASE = 42;
const HEIGHT = 60;

interface GroupTimelineProps {
  group: string;
  book: TimelineIndex;
  layout: TimelineLayout;
}

/** The timeline of a group: a bar per burst of edits, a round icon per run, arcs for repairs. */
export function GroupTimeline({ group, book, layout }: GroupTimelineProps) {
  const { line } = texts.value.review;
  return (
    <div class="line" style={{ width: `${layout.width}px`, "--line-width": layout.width }}>
      <Ground layout={layout} />
      <ol aria-label={`${line.label({ group })}. ${line.keys}`} onKeyDown={rove}>
        {layout.entries.map((placed) => (
          <li
            key={placed.entry.run_id ?? `${placed.entry.version_id}/${placed.index}`}
            class={`line__place line__place--${placed.entry.kind}`}
            style={{
              left: `${placed.x}px`,
              width: `${placed.width}px`,
              height: `${placed.height}px`,
            }}
          >
            <TimelineEvent placed={placed} book={book} />
          </li>
        ))}
      </ol>
    </div>
  );
}

function TimelineEvent({
  placed: { entry, index },
  book,
}: {
  placed: PlacedEvent;
  book: TimelineIndex;
}) {
  const touched = useRef(false);
  const plain = textOf(entry, book, null);
  const outcome = outcomeOf(entry);
  const isRun = entry.kind === "run";
  const show = (event: { currentTarget: HTMLElement }) =>
    showTip(event.currentTarget, () => {
      const text = textOf(entry, book, differenceOf(book.changeOf(entry)));
      return touched.current
        ? { ...text, lines: [...text.lines, texts.value.review.line.tapAgain] }
        : text;
    });
  return (
    <a
      class={`review-entry review-entry--${isRun ? "run" : "edit"}`}
      href={addressOf(entry)}
      tabIndex={index === 0 ? 0 : -1}
      data-rove
      data-testid="review-entry"
      data-kind={entry.kind}
      data-outcome={isRun ? outcome : undefined}
      data-repairs={entry.repairs ?? undefined}
      aria-label={`${plain.title}. ${plain.lines.join(" ")}`}
      aria-describedby={tip.value && isShown(entry) ? TIP_ID : undefined}
      onPointerDown={(event) => {
        touched.current = event.pointerType === "touch" && !isTipOf(event.currentTarget);
      }}
      onClick={(event) => {
        // touch has no hover: the first tap shows the tooltip, the second opens the link
        if (!touched.current) return hideTip();
        event.preventDefault();
        show(event);
      }}
      onMouseEnter={show}
      onFocus={show}
      onMouseLeave={(event) => hideTip(event.currentTarget)}
      onBlur={(event) => hideTip(event.currentTarget)}
    >
      {isRun ? <OutcomeIcon outcome={outcome} /> : <span class="review-entry__bar" />}
    </a>
  );
}

const isShown = (entry: TimelineEntry) =>
  tip.value?.anchor.getAttribute("href") === addressOf(entry);

/** The address that an event opens: the replay of a run, or the two versions of a burst of edits. */
export function addressOf(entry: TimelineEntry): string {
  if (entry.run_id) return hashOf({ screen: "replay", run: entry.run_id });
  const { program_id, since, version_id } = entry;
  if (!program_id || !version_id) return hashOf({ screen: "runs" });
  return since
    ? hashOf({ screen: "differences", program: program_id, before: since, after: version_id })
    : hashOf({ screen: "versions", program: program_id, version: version_id });
}

/** Base line, ruler, folded pauses, and arcs from failed runs to their repairs. */
function Ground({ layout }: { layout: TimelineLayout }) {
  const { line } = texts.value.review;
  const { width, ticks, folds, arcs, entries, lengths } = layout;
  const end = Math.max(...entries.map(({ x, width: wide }) => x + wide / 2), 0);
  const round = entries.find(({ entry }) => entry.kind === "run")?.height ?? barHeight(1);
  return (
    <svg class="line__ground" width={width} height={HEIGHT} aria-hidden="true">
      <path class="line__rest" d={`M0 ${BASE}H${Math.max(end, layout.end)}`} />
      <path class="line__base" d={`M0 ${BASE}H${end}`} />
      {lengths.map(({ from, to }) => (
        <path key={from} class="line__length" d={`M${from} ${BASE}H${to}`} />
      ))}
      {folds.map(({ x, fold, isNight, isLabelled }) => (
        <g key={fold.from} class="line__fold" transform={`translate(${x} ${BASE})`}>
          <title>{line.fold({ time: roundDuration(fold.seconds, language.value) })}</title>
          <rect x="-7" y="-4" width="14" height="8" />
          <path d="M-7 5l4-10M3 5l4-10" />
          {isLabelled && (
            <text y="16">
              {isNight
                ? shortDay(fold.from + fold.seconds, language.value)
                : line.minutes({ n: Math.round(fold.seconds / 60) })}
            </text>
          )}
        </g>
      ))}
      {ticks.map((tick) => (
        <g
          key={`${tick.labelKind}/${tick.time}`}
          class={tick.x < 20 ? "line__tick line__tick--first" : "line__tick"}
          transform={`translate(${tick.x} ${BASE})`}
        >
          <path d="M0 0v5" />
          <text y="16">{tickText(tick)}</text>
        </g>
      ))}
      {arcs.map(({ from, to }) => (
        <path key={`${from}/${to}`} class="line__arc" d={arcPath(from, to, BASE - round)} />
      ))}
    </svg>
  );
}

function tickText({ time, labelKind, from }: Tick): string {
  const { line } = texts.value.review;
  if (labelKind === "day") return shortDay(time, language.value);
  if (labelKind === "clock") return timeOfDay(new Date(time * 1000).toISOString(), language.value);
  const minutes = Math.round((time - from) / 60);
  return minutes === 0 ? line.begin : line.minutes({ n: minutes });
}

/** Path of an arrow from above one event to above another. */
function arcPath(from: number, to: number, top: number): string {
  const high = Math.max(-2, top - 8 - (to - from) / 8);
  const head = `M${to - 4} ${top - 5}L${to} ${top}L${to + 3} ${top - 6}`;
  return `M${from} ${top}C${from} ${high} ${to} ${high} ${to} ${top}${head}`;
}
