import { ArrowRight, UserRoundPlus } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import type { Group } from "../api/model";
import { enterGroup } from "../app/entering";
import { type Problem, wordsOf } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { PictureButton } from "./PictureButton";
import { PictureChoice } from "./PictureChoice";
import { rarestPicture } from "./pictures";

const LONGEST = 60;

interface NewGroupProps {
  classroomId: string | null;
  /** The other groups of that class. */
  others: readonly Group[];
  first?: boolean;
}

/** One field: type a name, press Enter. A drawing is there already, and can be another. */
export function NewGroup({ classroomId, others, first = false }: NewGroupProps) {
  const { start } = texts.value;
  const input = useRef<HTMLInputElement>(null);
  const taken = others.map((one) => one.picture);
  const [picture, setPicture] = useState<string>(() => rarestPicture(taken));
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);

  useEffect(() => {
    if (first) input.current?.focus();
  }, [first]);

  const create = async (event: Event) => {
    event.preventDefault();
    const name = input.current?.value.trim() ?? "";
    if (!name) {
      setFault({ message: start.nameMissing, remedy: "" });
      input.current?.focus();
      return;
    }
    setBusy(true);
    try {
      const wanted = { name, picture, classroom_id: classroomId };
      await enterGroup(await classesApi.createGroup(wanted));
    } catch (error) {
      setFault(wordsOf(error));
      setBusy(false);
      input.current?.select();
    }
  };

  const choice = { chosen: picture, taken, onChoose: setPicture };
  return (
    <form
      class={first ? "new-group new-group--first" : "new-group card"}
      onSubmit={(event) => void create(event)}
      noValidate
    >
      {!first && (
        <h2 class="new-group__title">
          <UserRoundPlus class="icon" aria-hidden="true" />
          {start.newGroup}
        </h2>
      )}
      <div class="new-group__who">
        {!first && <PictureButton {...choice} />}
        <input
          ref={input}
          class="field new-group__field"
          data-testid={TEST.groupName}
          aria-label={start.nameLabel}
          aria-invalid={fault !== null}
          placeholder={start.namePlaceholder}
          maxLength={LONGEST}
          autocomplete="off"
          spellcheck={false}
          onInput={() => setFault(null)}
        />
      </div>
      <button
        type="submit"
        class="button button--run new-group__go"
        data-testid={TEST.createGroup}
        disabled={busy}
      >
        {busy ? start.creating : start.create}
        <ArrowRight class="icon" aria-hidden="true" />
      </button>
      {fault && (
        <p class="new-group__fault" role="alert">
          <strong>{fault.message}</strong> {fault.remedy}
        </p>
      )}
      {first && <PictureChoice {...choice} />}
    </form>
  );
}
