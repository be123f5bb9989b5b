import { texts } from "../i18n";
import { listen } from "../kit/listen";
import { blocksPart, clampedPart, DEFAULT_PART, setBlocksPart } from "./split";

const STEP = 2;

/** The line between blocks and floor: drag it, or arrow keys; Home and a double click restore the default. */
export function Splitter() {
  const { studio } = texts.value;
  const now = blocksPart.value;
  const onKeyDown = (event: KeyboardEvent) => {
    const moved = partAfter(event.key, now);
    if (moved === null) return;
    event.preventDefault();
    setBlocksPart(moved);
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: an <hr> cannot be focused and moved
    <div
      class="splitter"
      role="separator"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={studio.split}
      aria-valuenow={Math.round(now)}
      aria-valuemin={0}
      aria-valuemax={100}
      title={studio.splitHelp}
      data-testid="splitter"
      onKeyDown={onKeyDown}
      onDblClick={() => setBlocksPart(DEFAULT_PART)}
      onPointerDown={drag}
    />
  );
}

function partAfter(key: string, now: number): number | null {
  if (key === "Home") return DEFAULT_PART;
  const direction = { ArrowLeft: -1, ArrowRight: 1 }[key];
  return direction === undefined ? null : clampedPart(now + direction * STEP, innerWidth);
}

/** Moves the line with the pointer; stores its place at the end. */
function drag(event: PointerEvent): void {
  if (event.button !== 0) return;
  event.preventDefault(); // no text is selected meanwhile
  const line = event.currentTarget as HTMLElement;
  const frame = line.parentElement?.getBoundingClientRect();
  if (!frame) return;
  line.focus();
  line.setPointerCapture(event.pointerId);
  const partAt = ({ clientX }: PointerEvent) =>
    clampedPart(((clientX - frame.left) / frame.width) * 100, frame.width);
  const stop = listen(line, {
    pointermove: (moved) => {
      blocksPart.value = partAt(moved);
    },
    pointerup: () => end(),
    pointercancel: () => end(),
  });
  const end = () => {
    stop();
    setBlocksPart(blocksPart.peek());
  };
}
