import { useSignal } from "@preact/signals";
import { Check, Trash } from "lucide-preact";
import { useEffect, useId, useRef } from "preact/hooks";
import type { TruthList } from "../api/model";
import { truthsApi } from "../api/real_runs";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { RadioGroup } from "../kit/RadioGroup";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { countTyped } from "./changes";
import { HeadingChoice } from "./HeadingChoice";
import { TruthPicture } from "./TruthPicture";
import { type Distance, entryOf, isWrong, MAX_CM, poseOf, type TapeEntry } from "./tape";

interface TapeFormProps {
  run: string;
  /** Name of the robot's model. */
  model: string | null;
  /** What is known about the run. */
  truths: TruthList;
  onSaved(truths: TruthList): void;
  onClose(): void;
}

/** Asks where the robot stands after a run, as measured with a tape from the start mark. */
export function TapeForm({ run, model, truths, onSaved, onClose }: TapeFormProps) {
  const { truth: words } = texts.value;
  const before = truths.truths.find(({ source }) => source === "tape")?.poses.at(-1) ?? null;
  const entry = useSignal(entryOf(before, truths.believed, language.peek()));
  const { busy, fault, act } = useAction();
  const pose = poseOf(entry.value);
  const put = (poses: NonNullable<typeof pose>[]) =>
    act(async () => {
      onSaved(await truthsApi.put(run, "tape", poses));
      countTyped();
    });
  return (
    <Form
      class="tape card column gap-3"
      testId="tape-form"
      aria-label={words.title}
      onSubmit={() => pose && put([pose])}
      onKeyDown={({ key }) => key === "Escape" && onClose()}
    >
      <h2 class="tape__title">{words.title}</h2>
      <div class="row wrap middle gap-3">
        <TruthPicture believed={truths.believed} measured={pose} model={model} />
        <Legend isMeasured={pose !== null} />
      </div>
      <Fields
        model={model}
        entry={entry.value}
        onEntry={(part) => {
          entry.value = { ...entry.value, ...part };
        }}
      />
      <FaultLine fault={fault} />
      <Buttons
        busy={busy}
        canSave={pose !== null}
        onClose={onClose}
        onRemove={before ? () => put([]) : null}
      />
    </Form>
  );
}

interface FieldsProps {
  model: string | null;
  entry: TapeEntry;
  onEntry(part: Partial<TapeEntry>): void;
}

/** The two distances and the heading; the first field has the focus. */
function Fields({ model, entry, onEntry }: FieldsProps) {
  const { truth: words } = texts.value;
  const fields = useRef<HTMLDivElement>(null);
  useEffect(() => fields.current?.querySelector("input")?.focus(), []);
  return (
    <div class="column gap-3" ref={fields}>
      <Measure
        name="forward"
        label={words.forward}
        sides={[words.ahead, words.behind]}
        value={entry.forward}
        onValue={(forward) => onEntry({ forward })}
      />
      <Measure
        name="sideways"
        label={words.sideways}
        sides={[words.left, words.right]}
        value={entry.sideways}
        onValue={(sideways) => onEntry({ sideways })}
      />
      <HeadingChoice
        headingDeg={entry.headingDeg}
        model={model}
        onTurn={(headingDeg) => onEntry({ headingDeg, isHeadingTyped: false })}
        onType={(headingDeg) => onEntry({ headingDeg, isHeadingTyped: true })}
      />
    </div>
  );
}

interface ButtonsProps {
  busy: boolean;
  canSave: boolean;
  onClose(): void;
  onRemove: (() => unknown) | null;
}

function Buttons({ busy, canSave, onClose, onRemove }: ButtonsProps) {
  const { truth: words } = texts.value;
  return (
    <div class="tape__buttons row wrap gap-2">
      <Button submit kind="main" icon={Check} testId="tape-save" busy={busy} disabled={!canSave}>
        {words.save}
      </Button>
      <Button kind="plain" testId="tape-cancel" onPress={onClose}>
        {words.cancel}
      </Button>
      {onRemove && (
        <Button
          kind="plain"
          icon={Trash}
          label={words.remove}
          testId="tape-remove"
          busy={busy}
          onPress={onRemove}
        />
      )}
    </div>
  );
}

/** What the drawing's marks mean. */
function Legend({ isMeasured }: { isMeasured: boolean }) {
  const { truth: words } = texts.value;
  return (
    <ul class="tape__legend aside column gap-2">
      <li data-mark="start">{words.startMark}</li>
      <li data-mark="believed">{words.believedMark}</li>
      {isMeasured && <li data-mark="measured">{words.measuredMark}</li>}
    </ul>
  );
}

interface MeasureProps {
  name: "forward" | "sideways";
  label: string;
  /** What the positive and the negative side are called. */
  sides: readonly [string, string];
  value: Distance;
  onValue(value: Distance): void;
}

/** A distance in cm and its side of the start mark. */
function Measure({ name, label, sides, value, onValue }: MeasureProps) {
  const id = useId();
  const { truth: words } = texts.value;
  const fault = isWrong(value);
  return (
    <div class="labelled">
      <label class="labelled__label" for={id}>
        {label}
      </label>
      <div class="row wrap middle gap-2">
        <input
          id={id}
          class="field tape__number"
          inputMode="decimal"
          autocomplete="off"
          value={value.text}
          aria-invalid={fault}
          aria-describedby={fault ? `${id}-fault` : undefined}
          data-testid={`tape-${name}`}
          onInput={({ currentTarget }) => onValue({ ...value, text: currentTarget.value })}
        />
        <RadioGroup
          label={words.side}
          class="tape__side row gap-1"
          value={value.isNegative}
          options={[
            [false, sides[0]],
            [true, sides[1]],
          ]}
          testId={`tape-${name}-side`}
          onChange={(isNegative) => onValue({ ...value, isNegative })}
        />
      </div>
      {fault && (
        <p class="number__fault" id={`${id}-fault`} role="alert">
          {words.number({ most: MAX_CM })}
        </p>
      )}
    </div>
  );
}
