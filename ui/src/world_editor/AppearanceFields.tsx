import { texts } from "../i18n";
import { Select } from "../kit/Select";
import type { BoxKind } from "../scene/mat/boxes";
import type { Ground } from "../scene/mat/grounds";
import type { PrintKind } from "../scene/mat/prints";

interface FieldProps<T> {
  value: T;
  onChange(value: T): void;
}

interface NamesFieldProps<T extends string> extends FieldProps<T | null> {
  label: string;
  testId: string;
  /** The label of each value. */
  labels: Readonly<Record<T, string>>;
  /** The label of null; absent if a value must be chosen. */
  none?: string;
}

function NamesField<T extends string>(props: NamesFieldProps<T>) {
  const { label, testId, labels, none, value, onChange } = props;
  const options = Object.entries<string>(labels);
  return (
    <label class="world-panel__text">
      {label}
      <Select
        testId={testId}
        value={value ?? ""}
        options={none === undefined ? options : [["", none], ...options]}
        onChange={(name) => onChange(name === "" ? null : (name as T))}
      />
    </label>
  );
}

/** What a box is. */
export function BoxKindField(props: FieldProps<BoxKind | null>) {
  const { world } = texts.value;
  return (
    <NamesField
      label={world.look}
      testId="world-box-kind"
      labels={world.things}
      none={world.plainBox}
      {...props}
    />
  );
}

/** Which picture is printed on a part of the floor. */
export function PrintField({ value, onChange }: FieldProps<PrintKind>) {
  const { world } = texts.value;
  return (
    <NamesField
      label={world.whichPrint}
      testId="world-print-kind"
      labels={world.prints}
      value={value}
      onChange={(print) => print && onChange(print)}
    />
  );
}

/** What covers the whole floor. */
export function GroundField(props: FieldProps<Ground | null>) {
  const { world } = texts.value;
  return (
    <NamesField
      label={world.ground}
      testId="world-ground"
      labels={world.grounds}
      none={world.plainGround}
      {...props}
    />
  );
}
