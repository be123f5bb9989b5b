import { useSignal } from "@preact/signals";
import { Check, StickyNote, Trash2, X } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { STORE_LIMITS } from "../../../api/declared";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Form } from "../../../kit/Form";
import { type NoteEditor, stateText } from "./note_editor";

interface NoteFormProps {
  editor: NoteEditor;
}

/** Text field and actions of a note. */
export function NoteForm({ editor }: NoteFormProps) {
  const { note: labels } = texts.value.review;
  const { text, state, open, changed } = editor;
  const field = useRef<HTMLTextAreaElement>(null);
  const isDeleting = useSignal(false);
  const close = () => {
    open.value = false;
  };
  const endDeleting = () => {
    isDeleting.value = false;
    field.current?.focus();
  };
  return (
    <Form
      class="note"
      testId="note"
      data-state={changed ? "changed" : state.value}
      onSubmit={editor.save}
    >
      <label class="note__title row middle gap-2" for="teacher-note">
        <StickyNote class="icon" aria-hidden="true" />
        {labels.title}
      </label>
      <Button kind="plain" class="note__close" icon={X} label={labels.close} onPress={close} />
      <textarea
        ref={field}
        id="teacher-note"
        class="note__text"
        rows={4}
        maxLength={STORE_LIMITS.MAX_NOTE}
        placeholder={labels.placeholder}
        aria-describedby="teacher-note-help"
        value={text.value}
        data-testid="note-text"
        onInput={(event) => editor.write(event.currentTarget.value)}
      />
      <p class="note__help" id="teacher-note-help" role="status">
        {isDeleting.value ? labels.deleteHelp : stateText(editor)}
      </p>
      {isDeleting.value ? (
        <ConfirmDelete onConfirm={() => editor.remove().then(endDeleting)} onCancel={endDeleting} />
      ) : (
        <NoteButtons
          editor={editor}
          onDelete={() => {
            isDeleting.value = true;
          }}
        />
      )}
    </Form>
  );
}

interface NoteButtonsProps extends NoteFormProps {
  onDelete(): void;
}

function NoteButtons({ editor, onDelete }: NoteButtonsProps) {
  const { note: labels } = texts.value.review;
  const { note, text, state, changed } = editor;
  const busy = state.value === "saving";
  return (
    <div class="row wrap end gap-2">
      {note.value && (
        <Button icon={Trash2} busy={busy} testId="note-delete" onPress={onDelete}>
          {labels.delete}
        </Button>
      )}
      <Button
        submit
        kind="main"
        icon={Check}
        busy={busy}
        disabled={!changed || !text.value.trim()}
        testId="note-save"
      >
        {note.value ? labels.change : labels.save}
      </Button>
    </div>
  );
}

interface ConfirmDeleteProps {
  onConfirm(): Promise<void>;
  onCancel(): void;
}

/** Asks for a second press, because the deletion cannot be undone. */
function ConfirmDelete({ onConfirm, onCancel }: ConfirmDeleteProps) {
  const { note: labels } = texts.value.review;
  const cancel = useRef<HTMLButtonElement>(null);
  useEffect(() => cancel.current?.focus(), []);
  return (
    <div class="row wrap end gap-2">
      <Button elementRef={cancel} onPress={onCancel}>
        {labels.keep}
      </Button>
      <Button kind="stop" icon={Trash2} testId="note-delete-sure" onPress={onConfirm}>
        {labels.deleteSure}
      </Button>
    </div>
  );
}
