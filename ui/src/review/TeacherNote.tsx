import { useSignal } from "@preact/signals";
import { Check, StickyNote, Trash2, X } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { words } from "../i18n/review";
import { type NoteKeeping, useNote } from "./note_keeping";

/** As the store has it. */
const LONGEST = 1000;

/** A note for the group about a run: written, changed, taken back; the group reads it the next time it comes in. */
export function TeacherNote({ run }: { run: string }) {
  const keeping = useNote(run);
  return keeping.open.value ? <NoteForm keeping={keeping} /> : <NoteButton keeping={keeping} />;
}

function NoteButton({ keeping: { open, text, changed } }: { keeping: NoteKeeping }) {
  const texts = words.value.note;
  return (
    <div class="note note--shut">
      <button
        type="button"
        class="button"
        data-testid={TEST.noteOpen}
        onClick={() => {
          open.value = true;
        }}
      >
        <StickyNote class="icon" aria-hidden="true" />
        {changed && text.value.trim() ? texts.unsent : texts.title}
      </button>
    </div>
  );
}

function NoteForm({ keeping }: { keeping: NoteKeeping }) {
  const texts = words.value.note;
  const { note, text, state, open, changed } = keeping;
  const field = useRef<HTMLTextAreaElement>(null);
  const sure = useSignal(false);
  const busy = state.value === "saving";
  return (
    <form
      class="note"
      data-testid={TEST.note}
      data-state={changed ? "changed" : state.value}
      onSubmit={(event) => {
        event.preventDefault();
        void keeping.save();
      }}
    >
      <label class="note__title" for="teacher-note">
        <StickyNote class="icon" aria-hidden="true" />
        {texts.title}
      </label>
      <button
        type="button"
        class="button button--plain button--icon note__close"
        aria-label={texts.close}
        title={texts.close}
        onClick={() => {
          open.value = false;
        }}
      >
        <X class="icon" aria-hidden="true" />
      </button>
      <textarea
        ref={field}
        id="teacher-note"
        class="note__text"
        rows={4}
        maxLength={LONGEST}
        placeholder={texts.placeholder}
        aria-describedby="teacher-note-help"
        value={text.value}
        data-testid={TEST.noteText}
        onInput={(event) => keeping.write(event.currentTarget.value)}
      />
      <p class="note__help" id="teacher-note-help" role="status">
        {sure.value ? texts.deleteHelp : helpOf(keeping)}
      </p>
      {sure.value ? (
        <Sure
          busy={busy}
          onYes={async () => {
            await keeping.takeBack();
            sure.value = false;
            field.current?.focus();
          }}
          onNo={() => {
            sure.value = false;
            field.current?.focus();
          }}
        />
      ) : (
        <div class="note__buttons">
          {note.value && (
            <button
              type="button"
              class="button"
              disabled={busy}
              data-testid={TEST.noteDelete}
              onClick={() => {
                sure.value = true;
              }}
            >
              <Trash2 class="icon" aria-hidden="true" />
              {texts.delete}
            </button>
          )}
          <button
            type="submit"
            class="button button--run"
            disabled={!changed || !text.value.trim() || busy}
            data-testid={TEST.noteSave}
          >
            <Check class="icon" aria-hidden="true" />
            {note.value ? texts.change : texts.save}
          </button>
        </div>
      )}
    </form>
  );
}

interface SureProps {
  busy: boolean;
  onYes(): void;
  onNo(): void;
}

/** What is taken back does not come again: nobody does it by one press. */
function Sure({ busy, onYes, onNo }: SureProps) {
  const texts = words.value.note;
  const no = useRef<HTMLButtonElement>(null);
  useEffect(() => no.current?.focus(), []);
  return (
    <div class="note__buttons">
      <button type="button" class="button" ref={no} onClick={onNo}>
        {texts.keep}
      </button>
      <button
        type="button"
        class="button button--stop"
        disabled={busy}
        data-testid={TEST.noteDeleteSure}
        onClick={onYes}
      >
        <Trash2 class="icon" aria-hidden="true" />
        {texts.deleteSure}
      </button>
    </div>
  );
}

/** Whether it is kept, and whether the group has read it. */
function helpOf({ note, text, state, changed }: NoteKeeping): string {
  const say = words.value.note;
  if (state.value === "saving") return say.saving;
  if (changed && text.value.trim()) return say.draft;
  if (changed && note.value) return say.emptied;
  if (state.value === "deleted") return say.deleted;
  if (!note.value) return say.help;
  const read = note.value.seen_at
    ? say.seen(when(note.value.seen_at, new Date(), language.value, texts.value))
    : say.unseen;
  return `${say.saved}. ${read}`;
}
