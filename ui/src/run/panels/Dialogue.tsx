import { BellRing, CircleQuestionMark, MessageCircle, Reply } from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { language, texts } from "../../i18n";
import { seconds } from "../../i18n/format";
import type { DialogueLine } from "../output";
import { spokenText } from "../values";

const ICONS = {
  said: MessageCircle,
  asked: CircleQuestionMark,
  answered: Reply,
  beeped: BellRing,
} as const;

/** The list scrolls to each new line while the distance to its end is at most this, in pixels. */
const AT_END_PX = 48;

/** The dialogue: messages and questions of the robot, answers of the group; the newest line is in view. */
export function Dialogue({ lines }: { lines: readonly DialogueLine[] }) {
  const { show } = texts.value;
  const list = useRef<HTMLDivElement>(null);
  const atEnd = useRef(true);
  const follow = () => {
    const { current } = list;
    if (current && atEnd.current) current.scrollTop = current.scrollHeight;
  };
  useLayoutEffect(follow, [lines]);
  useEffect(() => {
    const sizes = new ResizeObserver(follow);
    if (list.current) sizes.observe(list.current);
    return () => sizes.disconnect();
  }, []);
  return (
    <div
      class="talk"
      ref={list}
      role="log"
      aria-label={show.talk}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it
      tabIndex={0}
      data-testid="talk"
      onScroll={({ currentTarget: { scrollTop, clientHeight, scrollHeight } }) => {
        atEnd.current = scrollTop + clientHeight > scrollHeight - AT_END_PX;
      }}
    >
      <ol>
        {lines.map((line) => (
          <LineView key={line.number} line={line} />
        ))}
      </ol>
    </div>
  );
}

function LineView({ line: { kind, text, tick } }: { line: DialogueLine }) {
  const Icon = ICONS[kind];
  return (
    <li class={`talk__line talk__line--${kind}`} data-kind={kind} data-testid="talk-line">
      <Icon class="icon" aria-hidden="true" />
      {kind !== "beeped" && <span class="visually-hidden">{texts.value.show[kind]}</span>}
      <span class="talk__text grows shrinks">{lineText(kind, text)}</span>
      <time class="aside rigid">{seconds(tick / 30, language.value)}</time>
    </li>
  );
}

function lineText(kind: DialogueLine["kind"], text: DialogueLine["text"]): string {
  if (kind === "beeped") return texts.value.show.beeps({ count: Number(text) });
  return kind === "answered" && typeof text === "string" ? text : spokenText(text, language.value);
}
