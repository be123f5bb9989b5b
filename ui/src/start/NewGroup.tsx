import { ArrowRight, Dices, UserRoundPlus } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { STORE_LIMITS } from "../api/declared";
import type { Group } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { PictureButton } from "../kit/pictures/PictureButton";
import { PictureChoice } from "../kit/pictures/PictureChoice";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { enterGroup } from "../work/entering";
import { type Appearance, freeAppearance, nextName } from "../work/livery/appearance";
import { RobotButton } from "../work/livery/RobotButton";

interface NewGroupProps {
  classroomId: string | null;
  /** The other groups of that class. */
  others: readonly Group[];
  first?: boolean;
}

/** Creates a group: a name field, with picture and robot preselected. */
export function NewGroup({ classroomId, others, first = false }: NewGroupProps) {
  const form = useNewGroup(classroomId, others);
  const { name, appearance, isBusy, fault, input } = form;

  useEffect(() => {
    if (first) input.current?.focus();
  }, [first]);

  const choice = {
    chosen: appearance.picture,
    used: others.map((one) => one.picture),
    onChoose: (picture: string) => form.change({ picture }),
  };
  return (
    <Form
      class={`new-group ${first ? "new-group--first" : "card"} column center gap-3`}
      onSubmit={form.create}
    >
      {!first && <Title />}
      <div class="row shrinks gap-2">
        {!first && <PictureButton {...choice} />}
        <NameInput
          input={input}
          name={name}
          others={others}
          invalid={fault !== null}
          onName={form.rename}
        />
      </div>
      <div class="new-group__robot row wrap gap-2">
        <RobotButton
          appearance={appearance}
          groupName={name}
          others={others}
          onChange={form.change}
        />
        <Suggest name={name} others={others} onName={form.rename} short={!first} />
      </div>
      <CreateButton isBusy={isBusy} />
      <FaultLine fault={fault} />
      {first && <PictureChoice {...choice} />}
    </Form>
  );
}

/** The state of the form, and the request that creates the group. */
function useNewGroup(classroomId: string | null, others: readonly Group[]) {
  const { start } = texts.value;
  const input = useRef<HTMLInputElement>(null);
  const [name, setName] = useState("");
  const [chosen, setChosen] = useState<Partial<Appearance>>({});
  const appearance = { ...freeAppearance(others, name, chosen.color), ...chosen };
  const { busy, fault, act, refuse, clear } = useAction();
  const [entered, setEntered] = useState(false);
  return {
    input,
    name,
    appearance,
    fault,
    isBusy: busy || entered, // until the next screen is shown
    change: (changes: Partial<Appearance>) => setChosen((now) => ({ ...now, ...changes })),
    rename: (text: string) => {
      clear();
      setName(text);
    },
    create: async () => {
      if (!name.trim()) {
        refuse(start.nameMissing);
        input.current?.focus();
        return;
      }
      const newGroup = { name: name.trim(), ...appearance, classroom_id: classroomId };
      if (await act(async () => enterGroup(await classesApi.createGroup(newGroup))))
        setEntered(true);
      else input.current?.select();
    },
  };
}

interface NameInputProps extends Pick<NewGroupProps, "others"> {
  input: { current: HTMLInputElement | null };
  name: string;
  invalid: boolean;
  onName(name: string): void;
}

function NameInput({ input, name, others, invalid, onName }: NameInputProps) {
  const { start, livery } = texts.value;
  return (
    <input
      ref={input}
      class="field new-group__field grows shrinks"
      data-testid="group-name"
      aria-label={start.nameLabel}
      aria-invalid={invalid}
      placeholder={livery.example({ name: freeName("", others) })}
      maxLength={STORE_LIMITS.MAX_NAME}
      autocomplete="off"
      spellcheck={false}
      value={name}
      onInput={(event) => onName(event.currentTarget.value)}
    />
  );
}

interface SuggestProps extends Omit<NameInputProps, "input" | "invalid"> {
  /** Shows the icon only. */
  short: boolean;
}

/** Writes the name of a Brazilian animal that no group has into the field; each press another one. */
function Suggest({ name, others, onName, short }: SuggestProps) {
  const { suggest } = texts.value.livery;
  return (
    <Button
      kind="plain"
      icon={Dices}
      label={short ? suggest : undefined}
      testId="suggest-name"
      onPress={() => onName(freeName(name, others))}
    >
      {short ? null : suggest}
    </Button>
  );
}

/** The next animal whose name no group has. */
function freeName(now: string, others: readonly Group[]): string {
  const used = others.map((one) => one.name);
  return nextName(texts.value.livery.animals, now, used);
}

function CreateButton({ isBusy }: { isBusy: boolean }) {
  const { start } = texts.value;
  return (
    <Button
      submit
      kind="main"
      class="new-group__go"
      iconEnd={ArrowRight}
      testId="create-group"
      busy={isBusy}
    >
      {isBusy ? start.creating : start.create}
    </Button>
  );
}

function Title() {
  return (
    <h2 class="new-group__title row middle gap-2">
      <UserRoundPlus class="icon" aria-hidden="true" />
      {texts.value.start.newGroup}
    </h2>
  );
}
