import { Check, Pencil, X } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { api } from "../api/client";
import type { Group } from "../api/model";
import { group as inHeader, type Problem, report, wordsOf } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { GroupPicture } from "./GroupPicture";
import { PictureChoice } from "./PictureChoice";
import { COLORS } from "./pictures";

const LONGEST = 60;

/** Who this work is by; the pencil changes name, colour and drawing. */
export function GroupHead({ group }: { group: Group }) {
  const { classes } = texts.value;
  const [editing, setEditing] = useState(false);
  if (editing) return <GroupForm group={group} onDone={() => setEditing(false)} />;
  return (
    <div class="group-head tinted" style={{ "--group": group.color }}>
      <span class="badge group-head__badge">
        <GroupPicture name={group.picture} />
      </span>
      <span class="group-head__name" dir="auto" data-shortened title={group.name}>
        {group.name}
      </span>
      <button
        type="button"
        class="button button--plain button--icon"
        aria-label={classes.change}
        title={classes.change}
        data-testid={TEST.groupEdit}
        onClick={() => setEditing(true)}
      >
        <Pencil class="icon" aria-hidden="true" />
      </button>
    </div>
  );
}

function GroupForm({ group, onDone }: { group: Group; onDone(): void }) {
  const { classes, start } = texts.value;
  const [name, setName] = useState(group.name);
  const [color, setColor] = useState(group.color);
  const [picture, setPicture] = useState(group.picture);
  const [taken, setTaken] = useState<string[]>([]);
  const [fault, setFault] = useState<Problem | null>(null);

  useEffect(() => {
    api.groups().then((all) => {
      const others = all.filter((one) => one.id !== group.id);
      setTaken(
        others.filter((one) => one.classroom_id === group.classroom_id).map((one) => one.picture),
      );
    }, report);
  }, [group.id]);

  const save = async (event: Event) => {
    event.preventDefault();
    if (!name.trim()) {
      setFault({ message: start.nameMissing, remedy: "" });
      return;
    }
    try {
      const changes = { name, color, ...(picture && { picture }) };
      inHeader.value = await classesApi.changeGroup(group.id, changes);
      onDone();
    } catch (error) {
      setFault(wordsOf(error));
    }
  };

  return (
    <form
      class="group-form card tinted"
      style={{ "--group": color }}
      onSubmit={(event) => void save(event)}
      onKeyDown={(event) => event.key === "Escape" && onDone()}
      noValidate
    >
      <div class="group-form__who">
        <span class="badge group-head__badge">
          <GroupPicture name={picture} />
        </span>
        <input
          class="field group-form__name"
          aria-label={start.nameLabel}
          maxLength={LONGEST}
          autocomplete="off"
          spellcheck={false}
          value={name}
          data-testid={TEST.groupName}
          onInput={(event) => {
            setFault(null);
            setName(event.currentTarget.value);
          }}
        />
        <button type="submit" class="button button--run" data-testid={TEST.groupSave}>
          <Check class="icon" aria-hidden="true" />
          {classes.save}
        </button>
        <button type="button" class="button button--plain" onClick={onDone}>
          <X class="icon" aria-hidden="true" />
          {classes.cancel}
        </button>
      </div>
      {fault && (
        <p class="new-group__fault" role="alert">
          <strong>{fault.message}</strong> {fault.remedy}
        </p>
      )}
      <div class="group-form__looks">
        <PictureChoice chosen={picture} taken={taken} onChoose={setPicture} />
        <ColorChoice chosen={color} onChoose={setColor} />
      </div>
    </form>
  );
}

function ColorChoice({ chosen, onChoose }: { chosen: string; onChoose(color: string): void }) {
  const { classes } = texts.value;
  return (
    <fieldset class="pictures group-form__colors">
      <legend class="visually-hidden">{classes.color}</legend>
      {COLORS.map((one, index) => (
        <label key={one} class="pictures__one" data-testid={TEST.groupColor} data-color={one}>
          <input
            type="radio"
            class="visually-hidden"
            name="group-color"
            aria-label={classes.colorNumber(index + 1)}
            checked={one === chosen}
            onChange={() => onChoose(one)}
          />
          <span class="group-form__color" style={{ background: one }} />
        </label>
      ))}
    </fieldset>
  );
}
