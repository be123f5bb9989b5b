import { texts } from "../../i18n";
import { NumberField } from "../../kit/NumberField";
import { Select } from "../../kit/Select";
import type { ActivityEditor } from "./activity_editor";
import {
  type CheckField,
  type CheckKind,
  type Chosen,
  fieldsOf,
  offered,
  shownNumber,
} from "./check_choices";

/** Selects the checks of the activity. Their parameters start with the values of the solution. */
export function ChecksPart({ editor }: { editor: ActivityEditor }) {
  const { making: labels } = texts.value;
  const { value: proposal } = editor.proposal;
  const { value: choices } = editor.choices;
  return (
    <section class="making__part">
      <h2>{labels.checks.title}</h2>
      {proposal && choices ? (
        <>
          <p class="teacher__hint">{labels.checks.hint}</p>
          <ul class="making__checks">
            {offered(choices).map(([kind, chosen]) => (
              <CheckRow
                key={kind}
                kind={kind}
                chosen={chosen}
                zones={proposal.zones}
                onChange={(changes) => editor.choose(kind, changes)}
              />
            ))}
          </ul>
        </>
      ) : (
        <p class="teacher__hint">{labels.checks.first}</p>
      )}
    </section>
  );
}

interface CheckRowProps {
  kind: CheckKind;
  chosen: Chosen;
  zones: readonly string[];
  onChange(changes: Partial<Chosen>): void;
}

function CheckRow({ kind, chosen, zones, onChange }: CheckRowProps) {
  const { kinds } = texts.value.making;
  const { on, check } = chosen;
  const fields = fieldsOf(kind);
  return (
    <li class="making__check" data-testid="making-check" data-kind={kind}>
      <label class="making__choice row wrap middle gap-2">
        <input
          type="checkbox"
          checked={on}
          onChange={({ currentTarget }) => onChange({ on: currentTarget.checked })}
        />
        <span>{kinds[kind]}</span>
        {fields.map(
          ({ key, input }) =>
            input === "shown" && <strong key={key}>{(check[key] as string[]).join(", ")}</strong>,
        )}
      </label>
      {on && (
        <span class="row wrap middle gap-3">
          {fields.map((field) => (
            <FieldOf
              key={field.key}
              label={kinds[kind]}
              {...{ field, check, zones }}
              onValue={(value) => onChange({ check: { ...check, [field.key]: value } })}
            />
          ))}
        </span>
      )}
    </li>
  );
}

interface FieldOfProps extends Pick<Chosen, "check"> {
  field: CheckField;
  label: string;
  zones: readonly string[];
  onValue(value: number | string): void;
}

/** Input for a parameter: a number, a place, or the expected text. */
function FieldOf({ field, check, label, zones, onValue }: FieldOfProps) {
  const { numbers } = texts.value.making;
  const text = String(check[field.key]);
  switch (field.input) {
    case "number":
      return (
        <NumberField
          label={numbers[field.label]}
          value={shownNumber(field, check)}
          min={field.min}
          max={field.max}
          step={field.step}
          testId="making-number"
          onNumber={(value) => onValue(value / field.factor)}
        />
      );
    case "zone":
      return (
        <Select
          label={label}
          value={text}
          options={zones.map((zone) => [zone, zone])}
          onChange={onValue}
        />
      );
    case "text":
      return (
        <input
          class="field"
          aria-label={label}
          maxLength={200}
          value={text}
          onInput={({ currentTarget }) => onValue(currentTarget.value)}
        />
      );
    default:
      return null;
  }
}
