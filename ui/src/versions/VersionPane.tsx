import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";
import { ArrowLeft, Columns2, Flag, StepForward } from "lucide-preact";
import type { RefObject } from "preact";
import { useRef } from "preact/hooks";
import type { VersionOfProgram } from "../api/model";
import { versionsApi } from "../api/versions";
import type { Difference } from "../editor/reader/difference_badge";
import type { BlocksViewer } from "../editor/reader/viewer";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { settled } from "../kit/report";
import { go, hashOf } from "../shell/route";
import { problem, program, report } from "../shell/session";
import { reviewOrigin } from "../shell/teacher/review_origin";
import { restoredFrom } from "../studio/program/restored_from";
import { kindsOf } from "./differences";
import type { VersionHistory } from "./history";
import { NameForm } from "./NameForm";
import { ReadBlocks } from "./ReadBlocks";
import { createdText, factsOf } from "./version_texts";

/** The selected version: its description, actions and blocks. */
export function VersionPane({ history }: { history: VersionHistory }) {
  const naming = useSignal(false);
  const reader = useSignal<BlocksViewer | null>(null);
  const drawn = useRef<VersionOfProgram | null>(null);
  const renaming = useRef<HTMLButtonElement>(null);
  const labels = texts.value.archive;

  const leaveNaming = () => {
    naming.value = false;
    // returns the focus to the button that opened the form
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

  return (
    <section class="blocks">
      <div class="versions__bar">
        <ChosenVersion history={history} />
        {naming.value ? (
          <NameForm
            now={history.chosen.value?.label ?? ""}
            onSave={(text) => {
              leaveNaming();
              void settled(history.name(text));
            }}
            onLeave={leaveNaming}
          />
        ) : (
          <VersionActs
            history={history}
            reader={reader}
            renaming={renaming}
            onName={() => {
              naming.value = true;
            }}
          />
        )}
      </div>
      <ReadBlocks
        label={labels.readOnly}
        testId="version-blocks"
        onReader={(made) => {
          drawn.current = null;
          reader.value = made;
        }}
      />
    </section>
  );
}

interface VersionActsProps {
  history: VersionHistory;
  reader: ReadonlySignal<BlocksViewer | null>;
  renaming: RefObject<HTMLButtonElement>;
  onName(): void;
}

/** Buttons to name the version, compare it, and continue from it. */
function VersionActs({ history, reader, renaming, onName }: VersionActsProps) {
  const labels = texts.value.archive;
  return (
    <div class="versions__acts">
      <Button icon={Flag} elementRef={renaming} testId="version-rename" onPress={onName}>
        {history.chosen.value?.label ? labels.rename : labels.name}
      </Button>
      <Button
        icon={Columns2}
        tip={labels.compareHelp}
        testId="version-compare"
        disabled={history.line.value.length < 2}
        onPress={() => compare(history)}
      >
        {labels.compare}
      </Button>
      <Button
        icon={StepForward}
        tip={labels.goOnHelp}
        kind="main"
        testId="version-go-on"
        disabled={history.isNewest}
        onPress={() => resumeFrom(history, reader.peek())}
      >
        {labels.goOn}
      </Button>
    </div>
  );
}

/** Stores the selected version as the newest one and opens the studio with it. */
async function resumeFrom(history: VersionHistory, blocks: BlocksViewer | null): Promise<void> {
  const { value: version } = history.shown;
  const { value: now } = program;
  if (!version || !blocks || !now || version.id !== history.chosen.value?.id) return;
  const { workspace, world, setup } = version;
  const document = blocks.document(now.name);
  await versionsApi.saveAsNewest(now.id, version.id, { workspace, document, world, setup });
  const { value: from } = history.chosen;
  const instead = history.line.value.at(-1);
  if (from && instead) restoredFrom.value = { program: now.id, from, instead };
  go({ screen: "studio", program: now.id });
}

function compare(history: VersionHistory): void {
  const { value: chosen } = history.chosen;
  const { counterpart: other } = history;
  const { value: now } = program;
  if (!chosen || !other || !now) return;
  const [before, after] = history.isNewest ? [other, chosen] : [chosen, other];
  go({ screen: "differences", program: now.id, before: before.id, after: after.id });
}

function ChosenVersion({ history }: { history: VersionHistory }) {
  const { archive: labels, header } = texts.value;
  const { value: version } = history.chosen;
  if (!version) return null;
  const madeOf = history.madeOf.value;
  const facts = [
    createdText(version, language.value, texts.value),
    ...factsOf(version, texts.value),
    ...(madeOf === null ? [] : [labels.madeOf({ n: madeOf })]),
  ];
  const name = history.isNewest
    ? `${labels.version({ n: version.number })}, ${labels.newest}`
    : labels.version({ n: version.number });
  return (
    <div
      class="versions__chosen row middle shrinks gap-3"
      data-testid="version-shown"
      data-number={history.shown.value?.number}
    >
      {!reviewOrigin.value && (
        <LinkButton
          icon={ArrowLeft}
          label={header.backToProgram}
          href={hashOf({ screen: "studio", program: program.value?.id ?? "" })}
          testId="version-back"
        />
      )}
      <p aria-live="polite">
        <strong title={version.label || undefined}>{version.label || name}</strong>
        <span>{[version.label ? name : "", ...facts].filter(Boolean).join(" · ")}</span>
      </p>
    </div>
  );
}

async function draw(
  blocks: BlocksViewer,
  history: VersionHistory,
  version: VersionOfProgram,
): Promise<void> {
  try {
    blocks.load(version.workspace);
  } catch {
    blocks.load({});
    problem.value = { message: texts.peek().archive.unreadable, remedy: "" };
    return;
  }
  const before = history.madeFrom(version);
  if (!before) return;
  try {
    const difference = await versionsApi.difference(before.id, version.id);
    if (history.shown.peek()?.id !== version.id) return;
    const kinds = new Map<string, readonly Difference[]>(kindsOf(difference, "after"));
    blocks.showDifferences(kinds);
    const [first] = kinds.keys();
    if (first) blocks.reveal(first);
  } catch (error) {
    report(error);
  }
}
