import type { Measured } from "../../api/model";
import { texts } from "../../i18n";
import { NumberField } from "../../kit/NumberField";
import { Select } from "../../kit/Select";
import { CHECK_KINDS, type CheckKind, type Chosen, rowOf } from "./check_rows";
import type { Maker } from "./maker";

/** What counts: checks in words, with the numbers of the solution to begin with. */
export function ChecksPart({ maker }: { maker: Maker }) {
  const { making: say } = texts.value;
  const { value: measured } = maker.measured;
  const { value: choices } = maker.choices;
  return (
    <section class="making__part">
      <h2>{say.checks.title}</h2>
      {measured && choices ? (
        <>
          <p class="teacher__hint">{say.checks.hint}</p>
          <ul class="making__checks">
            {CHECK_KINDS.filter((kind) => rowOf(kind).isOffered(measured)).map((kind) => (
              <CheckLine
                key={kind}
                kind={kind}
                chosen={choices[kind]}
                measured={measured}
                onChange={(changes) => maker.choose(kind, changes)}
              />
            ))}
          </ul>
        </>
      ) : (
        <p class="teacher__hint">{say.checks.first}</p>
      )}
    </section>
  );
}

interface CheckLineProps {
  kind: CheckKind;
  chosen: Chosen;
  measured: Measured;
  onChange(changes: Partial<Chosen>): void;
}

function CheckLine({ kind, chosen, measured, onChange }: CheckLineProps) {
  const { making: say } = texts.value;
  return (
    <li class="making__check" data-testid="making-check" data-kind={kind}>
      <label class="making__choice">
        <input
          type="checkbox"
          checked={chosen.on}
          onChange={({ currentTarget }) => onChange({ on: currentTarget.checked })}
        />
        <span>{say.kinds[kind]}</span>
        {kind === "visits" && <strong>{measured.zones.join(", ")}</strong>}
      </label>
      {chosen.on && (
        <span class="row wrap middle gap-3">
          {rowOf(kind).numbers.map(({ name, least, most, step }) => (
            <NumberField
              key={name}
              label={say.numbers[name as keyof typeof say.numbers]}
              value={chosen.numbers[name] ?? least}
              {...{ least, most, step }}
              testId="making-number"
              onNumber={(value) => onChange({ numbers: { ...chosen.numbers, [name]: value } })}
            />
          ))}
          {rowOf(kind).text && (
            <TextOf kind={kind} chosen={chosen} measured={measured} onChange={onChange} />
          )}
        </span>
      )}
    </li>
  );
}

/** The place, or the text that is to be said. */
function TextOf({ kind, chosen, measured, onChange }: CheckLineProps) {
  const { making: say } = texts.value;
  if (kind === "ends_in") {
    return (
      <Select
        label={say.kinds.ends_in}
        value={chosen.text}
        options={measured.all_zones.map((zone) => [zone, zone])}
        onChange={(text) => onChange({ text })}
      />
    );
  }
  return (
    <input
      class="field"
      aria-label={say.kinds[kind]}
      maxLength={200}
      value={chosen.text}
      onInput={({ currentTarget }) => onChange({ text: currentTarget.value })}
    />
  );
}
