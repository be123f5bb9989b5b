import { ArrowRight, UserRoundPlus } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { STORE_LIMITS } from "../api/declared";
import type { Group } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { PictureButton } from "../kit/pictures/PictureButton";
import { PictureChoice } from "../kit/pictures/PictureChoice";
import { rarestPicture } from "../kit/pictures/pictures";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { enterGroup } from "../work/entering";

interface NewGroupProps {
  classroomId: string | null;
  /** The other groups of that class. */
  others: readonly Group[];
  first?: boolean;
}

/** Creates a group: a name field, with a picture preselected. */
export function NewGroup({ classroomId, others, first = false }: NewGroupProps) {
  const { start } = texts.value;
  const input = useRef<HTMLInputElement>(null);
  const usedPictures = others.map((one) => one.picture);
  const [picture, setPicture] = useState<string>(() => rarestPicture(usedPictures));
  const { busy, fault, act, refuse, clear } = useAction();
  const [entered, setEntered] = useState(false);
  const isBusy = busy || entered; // until the next screen is shown

  useEffect(() => {
    if (first) input.current?.focus();
  }, [first]);

  const create = async () => {
    const name = input.current?.value.trim() ?? "";
    if (!name) {
      refuse(start.nameMissing);
      input.current?.focus();
      return;
    }
    const newGroup = { name, picture, classroom_id: classroomId };
    if (await act(async () => enterGroup(await classesApi.createGroup(newGroup)))) setEntered(true);
    else input.current?.select();
  };

  const choice = { chosen: picture, used: usedPictures, onChoose: setPicture };
  const modifier = first ? "new-group--first" : "card";
  return (
    <Form class={`new-group ${modifier} column center gap-3`} onSubmit={create}>
      {!first && <Title />}
      <div class="row shrinks gap-2">
        {!first && <PictureButton {...choice} />}
        <input
          ref={input}
          class="field new-group__field grows shrinks"
          data-testid="group-name"
          aria-label={start.nameLabel}
          aria-invalid={fault !== null}
          placeholder={start.namePlaceholder}
          maxLength={STORE_LIMITS.MAX_NAME}
          autocomplete="off"
          spellcheck={false}
          onInput={clear}
        />
      </div>
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
      <FaultLine fault={fault} />
      {first && <PictureChoice {...choice} />}
    </Form>
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
