import { texts } from "../i18n";
import { Select } from "../kit/Select";
import type { Ground } from "../scene/mat/grounds";
import type { PrintKind } from "../scene/mat/prints";
import type { Thing } from "../scene/mat/things";

interface ChoiceProps<T extends string> {
  label: string;
  testId: string;
  /** The label of each look. */
  looks: Readonly<Record<T, string>>;
  /** The label of no look; absent if one must be chosen. */
  none?: string;
  value: T | null;
  onLook(look: T | null): void;
}

function LookChoice<T extends string>({
  label,
  testId,
  looks,
  none,
  value,
  onLook,
}: ChoiceProps<T>) {
  const options = Object.entries<string>(looks);
  return (
    <label class="world-panel__text">
      {label}
      <Select
        testId={testId}
        value={value ?? ""}
        options={none === undefined ? options : [["", none], ...options]}
        onChange={(look) => onLook(look === "" ? null : (look as T))}
      />
    </label>
  );
}

/** What a box looks like. */
export function ThingChoice({
  value,
  onThing,
}: {
  value: Thing | null;
  onThing(thing: Thing | null): void;
}) {
  const { look, things, plainBox } = texts.value.world;
  return (
    <LookChoice
      label={look}
      testId="world-thing-kind"
      looks={things}
      none={plainBox}
      value={value}
      onLook={onThing}
    />
  );
}

/** Which picture is printed on a part of the floor. */
export function PrintChoice({
  value,
  onPrint,
}: {
  value: PrintKind;
  onPrint(print: PrintKind): void;
}) {
  const { whichPrint, prints } = texts.value.world;
  return (
    <LookChoice
      label={whichPrint}
      testId="world-print-kind"
      looks={prints}
      value={value}
      onLook={(print) => print && onPrint(print)}
    />
  );
}

/** What covers the whole floor. */
export function GroundChoice({
  value,
  onGround,
}: {
  value: Ground | null;
  onGround(ground: Ground | null): void;
}) {
  const { ground, grounds, plainGround } = texts.value.world;
  return (
    <LookChoice
      label={ground}
      testId="world-ground"
      looks={grounds}
      none={plainGround}
      value={value}
      onLook={onGround}
    />
  );
}
