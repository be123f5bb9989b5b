import { useId } from "preact/hooks";
import { GROUP_COLORS, ROBOT_PATTERNS, STORE_LIMITS } from "../../api/declared";
import { texts } from "../../i18n";
import { type Livery, liveryOf } from "../../scene/livery/livery";
import { RobotPicture } from "../../scene/livery/RobotPicture";
import type { Appearance } from "./appearance";
import { ChoiceDot } from "./ChoiceDot";

interface RobotFieldsProps {
  appearance: Appearance;
  /** The group's name, which a robot without a name of its own has. */
  groupName: string;
  /** Colours of the other groups of the class. */
  usedColors: readonly string[];
  onChange(changes: Partial<Appearance>): void;
}

/** The group's robot from above, and the choice of its colour, its pattern and its name. */
export function RobotFields({ appearance, groupName, usedColors, onChange }: RobotFieldsProps) {
  const livery = liveryOf({ ...appearance, name: groupName });
  if (!livery) return null;
  const name = livery.name.trim() || texts.value.livery.title;
  return (
    <div class="robot-fields" data-testid="robot-fields">
      <figure class="robot-fields__preview column middle">
        <RobotPicture livery={livery} />
        <figcaption
          class="one-line"
          dir="auto"
          title={name}
          data-testid="robot-name-shown"
          data-shortened
        >
          {name}
        </figcaption>
      </figure>
      <div class="robot-fields__choices column gap-3">
        <ColorChoice
          chosen={appearance.color}
          used={usedColors}
          onChoose={(color) => onChange({ color })}
        />
        <PatternChoice livery={livery} onChoose={(robot_pattern) => onChange({ robot_pattern })} />
        <RobotNameField
          name={appearance.robot_name}
          groupName={groupName}
          onName={(robot_name) => onChange({ robot_name })}
        />
      </div>
    </div>
  );
}

interface ColorChoiceProps {
  chosen: string;
  used: readonly string[];
  onChoose(color: string): void;
}

function ColorChoice({ chosen, used, onChoose }: ColorChoiceProps) {
  const { classes, livery } = texts.value;
  const name = useId();
  return (
    <fieldset class="pictures robot-fields__colors">
      <legend class="visually-hidden">{classes.color}</legend>
      {GROUP_COLORS.map((one, index) => {
        const n = index + 1;
        const isUsed = used.includes(one);
        return (
          <ChoiceDot
            key={one}
            group={name}
            label={isUsed ? livery.colorTaken({ n }) : classes.colorNumber({ n })}
            chosen={one === chosen}
            used={isUsed}
            testId="group-color"
            value={one}
            onChoose={() => onChoose(one)}
          >
            <span class="robot-fields__color" style={{ background: one }} />
          </ChoiceDot>
        );
      })}
    </fieldset>
  );
}

function PatternChoice({ livery, onChoose }: { livery: Livery; onChoose(name: string): void }) {
  const labels = texts.value.livery;
  const name = useId();
  const chosen = livery.pattern || "plain";
  return (
    <fieldset class="pictures robot-fields__patterns">
      <legend class="visually-hidden">{labels.pattern}</legend>
      {ROBOT_PATTERNS.map((pattern) => (
        <ChoiceDot
          key={pattern}
          group={name}
          label={labels.patterns[pattern]}
          chosen={pattern === chosen}
          testId="robot-pattern"
          value={pattern}
          onChoose={() => onChoose(pattern)}
        >
          <RobotPicture livery={{ ...livery, pattern }} />
        </ChoiceDot>
      ))}
    </fieldset>
  );
}

interface RobotNameFieldProps {
  name: string;
  groupName: string;
  onName(name: string): void;
}

function RobotNameField({ name, groupName, onName }: RobotNameFieldProps) {
  const { livery } = texts.value;
  const hint = useId();
  return (
    <label class="column gap-1">
      <span class="robot-fields__label">{livery.name}</span>
      <input
        class="field"
        maxLength={STORE_LIMITS.MAX_NAME}
        autocomplete="off"
        spellcheck={false}
        placeholder={groupName}
        dir="auto"
        aria-describedby={hint}
        value={name}
        data-testid="robot-name"
        onInput={(event) => onName(event.currentTarget.value)}
      />
      <span id={hint} class="aside">
        {livery.nameHint}
      </span>
    </label>
  );
}
