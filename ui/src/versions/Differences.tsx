import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { ArrowLeft, ChevronDown, ChevronUp } from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { hashOf } from "../app/route";
import { problem } from "../app/session";
import { TEST } from "../app/testids";
import type { Difference } from "../editor/difference_sign";
import type { BlocksReader } from "../editor/reader";
import { texts } from "../i18n";
import type { Compared } from "./DifferencesScreen";
import { differenceWords } from "./difference_words";
import { type Differing, differing, kindsOf } from "./differences";
import { ReadBlocks } from "./ReadBlocks";
import { SideChoice } from "./SideChoice";
import { Sign } from "./Sign";

interface DifferencesProps {
  compared: Compared;
  programId: string;
}

export function Differences({ compared, programId }: DifferencesProps) {
  const { difference } = compared;
  const before = useSignal<BlocksReader | null>(null);
  const after = useSignal<BlocksReader | null>(null);
  const filled = useSignal(0);
  const chosen = useSignal<number | null>(null);
  const words = texts.value.keeping;

  useSignalEffect(() => {
    if (!before.value || !after.value) return;
    fill(before.value, compared.before.workspace);
    fill(after.value, compared.after.workspace);
    // blocks of one size on both sides
    const scale = Math.min(before.value.fittingScale(), after.value.fittingScale());
    before.value.showFromTheStart(scale);
    after.value.showFromTheStart(scale);
    before.value.mark(new Map(kindsOf(difference, "before")));
    after.value.mark(new Map(kindsOf(difference, "after")));
    filled.value = filled.peek() + 1;
  });

  const list = useComputed<Differing[]>(() => {
    const [first, second] = [before.value, after.value];
    if (filled.value === 0 || !first || !second) return [];
    const height = ({ block, kinds }: Differing) =>
      (kinds.includes("removed") ? first : second).heightOf(block);
    return differing(difference).sort((one, other) => height(one) - height(other));
  });

  useSignalEffect(() => {
    const one = chosen.value === null ? null : (list.value[chosen.value]?.block ?? null);
    before.value?.point(one);
    after.value?.point(one);
  });

  const step = (by: number) => {
    const n = list.value.length;
    if (n === 0) return;
    const now = chosen.peek();
    chosen.value = now === null ? (by > 0 ? 0 : n - 1) : (now + by + n) % n;
  };
  useLayoutEffect(() => byKeys(step), []); // before painting: the first key is heard

  // words of blocks are read from the blocks, which are made anew in another language
  const lines = useComputed(() => {
    const [first, second] = [before.value, after.value];
    const tell = texts.value;
    if (filled.value === 0 || !first || !second) return [];
    return list.value.map((one) => differenceWords(one, first, second, tell));
  });

  return (
    <main class="screen differences">
      <h1 class="visually-hidden">{words.compareTitle}</h1>
      <section class="blocks differences__side">
        <SideChoice side="before" compared={compared} programId={programId} />
        <ReadBlocks
          label={`${words.before}: ${words.version(compared.before.number)}`}
          onReader={(made) => {
            before.value = made;
          }}
        />
      </section>
      <section class="blocks differences__side">
        <SideChoice side="after" compared={compared} programId={programId} />
        <ReadBlocks
          label={`${words.after}: ${words.version(compared.after.number)}`}
          onReader={(made) => {
            after.value = made;
          }}
          onLanguage={() => {
            filled.value += 1;
          }}
        />
      </section>
      <section class="differences__list">
        <div class="differences__head">
          <a
            class="button button--icon"
            href={hashOf({
              screen: "versions",
              program: programId,
              version: compared.before.id,
            })}
            aria-label={words.backToHistory}
            title={words.backToHistory}
          >
            <ArrowLeft class="icon" aria-hidden="true" />
          </a>
          <h2 data-testid={TEST.differenceCount}>{words.differences(list.value.length)}</h2>
          <button
            type="button"
            class="button button--icon"
            aria-label={words.previous}
            title={words.previous}
            disabled={list.value.length === 0}
            data-testid={TEST.differencePrevious}
            onClick={() => step(-1)}
          >
            <ChevronUp class="icon" aria-hidden="true" />
          </button>
          <button
            type="button"
            class="button button--icon"
            aria-label={words.next}
            title={words.next}
            disabled={list.value.length === 0}
            data-testid={TEST.differenceNext}
            onClick={() => step(1)}
          >
            <ChevronDown class="icon" aria-hidden="true" />
          </button>
        </div>
        {list.value.length === 0 && filled.value > 0 && (
          <p class="differences__none">
            <strong>{words.nothingDiffers}</strong> {words.nothingDiffersHow}
          </p>
        )}
        <ol class="differences__lines" data-scrolls>
          {list.value.map((one, index) => (
            <DifferenceLine
              key={`${one.kinds[0]} ${one.block}`}
              one={one}
              text={lines.value[index] ?? ""}
              current={chosen.value === index}
              onChoose={() => {
                chosen.value = index;
              }}
            />
          ))}
        </ol>
        {list.value.length > 1 && <p class="differences__keys">{words.keys}</p>}
      </section>
    </main>
  );
}

interface DifferenceLineProps {
  one: Differing;
  text: string;
  current: boolean;
  onChoose(): void;
}

function DifferenceLine({ one, text, current, onChoose }: DifferenceLineProps) {
  const { kinds } = texts.value.keeping;
  const line = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (current) line.current?.scrollIntoView({ block: "nearest" });
  }, [current]);
  return (
    <li>
      <button
        type="button"
        ref={line}
        class="differences__line"
        aria-current={current}
        data-testid={TEST.difference}
        data-kind={one.kinds[0]}
        onClick={onChoose}
      >
        <span class="differences__signs">
          {one.kinds.map((kind) => (
            <Sign key={kind} kind={kind} />
          ))}
        </span>
        <span class="differences__words">
          <strong>{kindsInWords(one, kinds)}</strong>
          <span>{text}</span>
        </span>
      </button>
    </li>
  );
}

function kindsInWords(one: Differing, words: Readonly<Record<Difference, string>>): string {
  const [first = "", ...more] = one.kinds.map((kind) => words[kind]);
  return [first, ...more.map((word) => word.toLowerCase())].join(", ");
}

function fill(blocks: BlocksReader, workspace: object): void {
  try {
    blocks.load(workspace);
  } catch {
    blocks.load({});
    problem.value = { message: texts.peek().keeping.unreadable, remedy: "" };
  }
}

/** Up and down go from one difference to another, wherever the keyboard is not at something that needs them. */
function byKeys(step: (by: number) => void): () => void {
  const onKey = (event: KeyboardEvent) => {
    const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (by === 0 || event.ctrlKey || event.altKey || event.metaKey) return;
    if ((event.target as Element).closest?.("input, select, textarea, .injectionDiv")) return;
    step(by);
    event.preventDefault();
  };
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}
