import { useSignal, useSignalEffect } from "@preact/signals";
import { ArrowLeft, Columns2, Flag, StepForward } from "lucide-preact";
import { useRef } from "preact/hooks";
import { keeping, type StoredVersion } from "../api/keeping";
import { reviewPlace } from "../app/review_place";
import { go, hashOf } from "../app/route";
import { problem, program, report } from "../app/session";
import { TEST } from "../app/testids";
import { wentOn } from "../app/went_on";
import type { Difference } from "../editor/difference_sign";
import type { BlocksReader } from "../editor/reader";
import { language, texts } from "../i18n";
import { kindsOf } from "./differences";
import type { VersionHistory } from "./history";
import { NameForm } from "./NameForm";
import { ReadBlocks } from "./ReadBlocks";
import { factsOf, madeWords } from "./words";

/** The chosen version: what it is, what can be done with it, and its blocks. */
export function VersionPane({ history }: { history: VersionHistory }) {
  const naming = useSignal(false);
  const reader = useSignal<BlocksReader | null>(null);
  const drawn = useRef<StoredVersion | null>(null);
  const renaming = useRef<HTMLButtonElement>(null);
  const words = texts.value.keeping;

  const leaveNaming = () => {
    naming.value = false;
    // the keyboard goes on where it was
    requestAnimationFrame(() => renaming.current?.focus());
  };

  useSignalEffect(() => {
    const { value: blocks } = reader;
    const { value: version } = history.shown;
    if (!blocks || !version) return;
    if (drawn.current?.id === version.id) return;
    drawn.current = version;
    void draw(blocks, history, version);
  });

  const goOn = async () => {
    const { value: version } = history.shown;
    const blocks = reader.peek();
    const { value: now } = program;
    if (!version || !blocks || !now || version.id !== history.chosen.value?.id) return;
    const { workspace, world } = version;
    await keeping.goOnFrom(now.id, version.id, {
      workspace,
      document: blocks.document(now.name),
      world,
    });
    const { value: from } = history.chosen;
    const instead = history.line.value.at(-1);
    if (from && instead) wentOn.value = { program: now.id, from, instead };
    go({ screen: "studio", program: now.id });
  };

  const compare = () => {
    const { value: chosen } = history.chosen;
    const { counterpart: other } = history;
    const { value: now } = program;
    if (!chosen || !other || !now) return;
    const [before, after] = history.isNewest ? [other, chosen] : [chosen, other];
    go({ screen: "differences", program: now.id, before: before.id, after: after.id });
  };

  return (
    <section class="blocks versions__pane">
      <div class="versions__bar">
        <ChosenWords history={history} />
        {!naming.value && (
          <div class="versions__acts">
            <button
              ref={renaming}
              type="button"
              class="button"
              data-testid={TEST.versionRename}
              onClick={() => {
                naming.value = true;
              }}
            >
              <Flag class="icon" aria-hidden="true" />
              {history.chosen.value?.label ? words.rename : words.name}
            </button>
            <button
              type="button"
              class="button"
              data-testid={TEST.versionCompare}
              title={words.compareHelp}
              disabled={history.line.value.length < 2}
              onClick={compare}
            >
              <Columns2 class="icon" aria-hidden="true" />
              {words.compare}
            </button>
            <button
              type="button"
              class="button button--run"
              data-testid={TEST.versionGoOn}
              title={words.goOnHelp}
              disabled={history.isNewest}
              onClick={() => void goOn().catch(report)}
            >
              <StepForward class="icon" aria-hidden="true" />
              {words.goOn}
            </button>
          </div>
        )}
        {naming.value && (
          <NameForm
            now={history.chosen.value?.label ?? ""}
            onKeep={(text) => {
              leaveNaming();
              history.name(text).catch(report);
            }}
            onLeave={leaveNaming}
          />
        )}
      </div>
      <ReadBlocks
        label={words.readOnly}
        testId={TEST.versionBlocks}
        onReader={(made) => {
          drawn.current = null;
          reader.value = made;
        }}
      />
    </section>
  );
}

function ChosenWords({ history }: { history: VersionHistory }) {
  const { keeping: words, header } = texts.value;
  const { value: version } = history.chosen;
  if (!version) return null;
  const madeOf = history.madeOf.value;
  const facts = [
    madeWords(version, language.value, texts.value),
    ...factsOf(version, texts.value),
    ...(madeOf === null ? [] : [words.madeOf(madeOf)]),
  ];
  const name = history.isNewest
    ? `${words.version(version.number)}, ${words.newest}`
    : words.version(version.number);
  return (
    <div
      class="versions__chosen"
      data-testid={TEST.versionShown}
      data-number={history.shown.value?.number}
    >
      {!reviewPlace.value && (
        <a
          class="button button--icon"
          href={hashOf({ screen: "studio", program: program.value?.id ?? "" })}
          aria-label={header.backToProgram}
          title={header.backToProgram}
          data-testid={TEST.versionBack}
        >
          <ArrowLeft class="icon" aria-hidden="true" />
        </a>
      )}
      <p aria-live="polite">
        <strong title={version.label || undefined}>{version.label || name}</strong>
        <span>{[version.label ? name : "", ...facts].filter(Boolean).join(" · ")}</span>
      </p>
    </div>
  );
}

async function draw(
  blocks: BlocksReader,
  history: VersionHistory,
  version: StoredVersion,
): Promise<void> {
  try {
    blocks.load(version.workspace);
  } catch {
    blocks.load({});
    problem.value = { message: texts.peek().keeping.unreadable, remedy: "" };
    return;
  }
  const before = history.madeFrom(version);
  if (!before) return;
  try {
    const difference = await keeping.difference(before.id, version.id);
    if (history.shown.peek()?.id !== version.id) return;
    const kinds = new Map<string, readonly Difference[]>(kindsOf(difference, "after"));
    blocks.mark(kinds);
    const [first] = kinds.keys();
    if (first) blocks.reveal(first);
  } catch (error) {
    report(error);
  }
}
