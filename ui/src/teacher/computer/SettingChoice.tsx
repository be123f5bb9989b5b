import { choose, type SettingName, type SettingValues, setting } from "../../shell/settings";

interface SettingChoiceProps<Name extends SettingName> {
  name: Name;
  title: string;
  hint: string;
  /** Labels of the values, in their order. */
  options: Readonly<Record<SettingValues[Name], string>>;
}

/** Radio group for a setting of this PC with few values. */
export function SettingChoice<Name extends SettingName>(props: SettingChoiceProps<Name>) {
  const { name, title, hint, options } = props;
  const chosen = setting(name);
  const values = Object.keys(options) as SettingValues[Name][];
  return (
    <section class="panel card">
      <fieldset class="setting-choice row wrap gap-2">
        <legend>
          <h2>{title}</h2>
        </legend>
        {values.map((value) => (
          <label
            key={value}
            class="setting-choice__one row middle gap-2"
            data-testid="setting"
            data-setting={name}
            data-value={value}
          >
            <input
              type="radio"
              name={name}
              checked={chosen.value === value}
              onChange={() => void choose(name, value)}
            />
            {options[value]}
          </label>
        ))}
      </fieldset>
      <p class="labelled__hint">{hint}</p>
    </section>
  );
}
