import { Check, X } from "lucide-preact";
import { useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { api } from "../api/client";
import { STORE_LIMITS } from "../api/declared";
import type { Group } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { GroupPicture } from "../kit/pictures/GroupPicture";
import { PictureChoice } from "../kit/pictures/PictureChoice";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { valueIn } from "../kit/requests/load_state";
import { useLoaded } from "../kit/requests/useLoaded";
import { group as inHeader } from "../shell/session";
import type { Appearance } from "./livery/appearance";
import { RobotFields } from "./livery/RobotFields";

type GroupAppearance = Appearance & Pick<Group, "name">;

/** Form for a group's name, colour, picture and robot. */
export function GroupForm({ group, onDone }: { group: Group; onDone(): void }) {
  const { classes, start } = texts.value;
  const [appearance, setAppearance] = useState<GroupAppearance>(group);
  const { busy, fault, act, refuse, clear } = useAction();
  const change = (changes: Partial<GroupAppearance>) => {
    clear();
    setAppearance({ ...appearance, ...changes });
  };
  const save = async () => {
    const { name, color, picture, robot_name, robot_pattern } = appearance;
    if (!name.trim()) return refuse(start.nameMissing);
    const done = await act(async () => {
      const chosen = { ...(picture && { picture }), ...(robot_pattern && { robot_pattern }) };
      const changes = { name, color, robot_name, ...chosen };
      inHeader.value = await classesApi.changeGroup(group.id, changes);
    });
    if (done) onDone();
  };
  return (
    <Form
      class="group-form card tinted column gap-4"
      style={{ "--group": appearance.color }}
      onSubmit={save}
      onKeyDown={(event) => event.key === "Escape" && onDone()}
    >
      <div class="group-form__who row wrap middle gap-3">
        <span class="badge group-head__badge">
          <GroupPicture name={appearance.picture} />
        </span>
        <NameInput name={appearance.name} onName={(name) => change({ name })} />
        <Button submit kind="main" icon={Check} busy={busy} testId="group-save">
          {classes.save}
        </Button>
        <Button kind="plain" icon={X} onPress={onDone}>
          {classes.cancel}
        </Button>
      </div>
      <FaultLine fault={fault} />
      <AppearanceFields group={group} appearance={appearance} onChange={change} />
    </Form>
  );
}

function NameInput({ name, onName }: { name: string; onName(name: string): void }) {
  return (
    <input
      class="field group-form__name"
      aria-label={texts.value.start.nameLabel}
      maxLength={STORE_LIMITS.MAX_NAME}
      autocomplete="off"
      spellcheck={false}
      value={name}
      data-testid="group-name"
      onInput={(event) => onName(event.currentTarget.value)}
    />
  );
}

interface AppearanceFieldsProps {
  group: Group;
  appearance: GroupAppearance;
  onChange(changes: Partial<GroupAppearance>): void;
}

function AppearanceFields({ group, appearance, onChange }: AppearanceFieldsProps) {
  const groups = useLoaded(group.id, () => api.groups());
  const others = (valueIn(groups) ?? []).filter(
    (one) => one.id !== group.id && one.classroom_id === group.classroom_id,
  );
  return (
    <div class="group-form__looks">
      <PictureChoice
        chosen={appearance.picture}
        used={others.map((one) => one.picture)}
        onChoose={(picture) => onChange({ picture })}
      />
      <section class="group-form__robot column gap-2" aria-label={texts.value.livery.title}>
        <strong aria-hidden="true">{texts.value.livery.title}</strong>
        <RobotFields
          appearance={appearance}
          groupName={appearance.name}
          usedColors={others.map((one) => one.color)}
          onChange={onChange}
        />
      </section>
    </div>
  );
}
