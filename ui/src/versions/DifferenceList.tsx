import { ArrowLeft, ChevronDown, ChevronUp } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { Difference } from "../editor/reader/difference_badge";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { hashOf } from "../shell/route";
import { setupOf } from "../studio/program/setup";
import type { ComparedBlocks } from "./compared_blocks";
import { DifferenceIcon } from "./DifferenceIcon";
import type { Differing } from "./differences";
import { type SetupChange, setupChanges } from "./setup_texts";

interface DifferenceListProps {
  sides: ComparedBlocks;
  programId: string;
}

/** The differences, block by block, and the buttons that step through them. */
export function DifferenceList({ sides, programId }: DifferenceListProps) {
  const labels = texts.value.archive;
  const list = sides.list.value;
  const { before, after } = sides.compared;
  const changes = setupChanges(setupOf(before), setupOf(after), texts.value, language.value);
  const history = hashOf({
    screen: "versions",
    program: programId,
    version: before.id,
  });
  return (
    <section class="differences__list column shrinks-down">
      <div class="differences__head row middle rigid gap-2">
        <LinkButton icon={ArrowLeft} label={labels.backToHistory} href={history} />
        <h2 data-testid="difference-count">
          {labels.differences({ count: list.length + changes.length })}
        </h2>
        <Button
          icon={ChevronUp}
          label={labels.previous}
          disabled={list.length === 0}
          testId="difference-previous"
          onPress={() => sides.step(-1)}
        />
        <Button
          icon={ChevronDown}
          label={labels.next}
          disabled={list.length === 0}
          testId="difference-next"
          onPress={() => sides.step(1)}
        />
      </div>
      <SetupDifferences changes={changes} />
      {list.length === 0 && sides.drawn.value > 0 && (
        <p class="differences__none">
          <strong>{labels.nothingDiffers}</strong> {labels.nothingDiffersHow}
        </p>
      )}
      <ol class="differences__lines grows shrinks-down" data-scrolls>
        {list.map((one, index) => (
          <DifferenceRow
            key={`${one.kinds[0]} ${one.block}`}
            one={one}
            text={sides.lines.value[index] ?? ""}
            current={sides.chosen.value === index}
            onChoose={() => {
              sides.chosen.value = index;
            }}
          />
        ))}
      </ol>
      {list.length > 1 && <p class="differences__keys">{labels.keys}</p>}
    </section>
  );
}

/** Differences between the setups of the two versions. */
function SetupDifferences({ changes }: { changes: readonly SetupChange[] }) {
  const { archive } = texts.value;
  if (changes.length === 0) return null;
  return (
    <dl class="differences__setup" aria-label={archive.setup} data-testid="setup-differences">
      {changes.map((one) => (
        <div key={one.what}>
          <dt>{one.what}</dt>
          <dd>{archive.became({ before: one.before, after: one.after })}</dd>
        </div>
      ))}
    </dl>
  );
}

interface DifferenceRowProps {
  one: Differing;
  text: string;
  current: boolean;
  onChoose(): void;
}

function DifferenceRow({ one, text, current, onChoose }: DifferenceRowProps) {
  const { kinds } = texts.value.archive;
  const line = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (current) line.current?.scrollIntoView({ block: "nearest" });
  }, [current]);
  return (
    <li>
      <Button
        kind="bare"
        class="differences__line row top gap-3"
        elementRef={line}
        current={current}
        testId="difference"
        data-kind={one.kinds[0]}
        onPress={onChoose}
      >
        <span class="grid gap-1">
          {one.kinds.map((kind) => (
            <DifferenceIcon key={kind} kind={kind} />
          ))}
        </span>
        <span class="differences__words shrinks">
          <strong>{kindsText(one, kinds)}</strong>
          <span>{text}</span>
        </span>
      </Button>
    </li>
  );
}

function kindsText(one: Differing, labels: Readonly<Record<Difference, string>>): string {
  const [first = "", ...more] = one.kinds.map((kind) => labels[kind]);
  return [first, ...more.map((label) => label.toLowerCase())].join(", ");
}
