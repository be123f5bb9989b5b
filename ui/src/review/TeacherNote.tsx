import { useSignal } from "@preact/signals";
import { Check, StickyNote, X } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Note } from "../api/model";
import { reviewApi } from "../api/review";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { words } from "../i18n/review";
import { draftOf, keepDraft } from "./note_draft";

const LONGEST = 5000;

/** A note for the group about a run: written, changed, and read by the group the next time it comes in. */
export function TeacherNote({ run }: { run: string }) {
  const texts = words.value.note;
  const note = useSignal<Note | null>(null);
  const text = useSignal("");
  const open = useSignal(false);
  const state = useSignal<"unchanged" | "saving" | "saved">("unchanged");

  useEffect(() => {
    reviewApi.notes(run).then((found) => {
      const draft = draftOf(run);
      note.value = found.at(-1) ?? null;
      text.value = draft ?? note.value?.text ?? "";
      open.value = note.value !== null || draft !== null;
    }, report);
  }, [run]);

  const kept = note.value?.text ?? "";
  const changed = text.value.trim() !== kept;
  const write = (written: string) => {
    text.value = written;
    keepDraft(run, written.trim() === kept ? null : written);
  };
  const save = async () => {
    state.value = "saving";
    const wanted = text.value.trim();
    const known = note.value;
    try {
      note.value = await asTeacher(() =>
        known ? reviewApi.rewriteNote(known.id, wanted) : reviewApi.writeNote(run, wanted),
      );
      text.value = note.value.text;
      keepDraft(run, null);
      state.value = "saved";
    } catch (error) {
      state.value = "unchanged";
      report(error);
    }
  };

  if (!open.value) {
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
  return (
    <form
      class="note"
      data-testid={TEST.note}
      data-state={changed ? "changed" : state.value}
      onSubmit={(event) => {
        event.preventDefault();
        void save();
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
        id="teacher-note"
        class="note__text"
        rows={2}
        maxLength={LONGEST}
        placeholder={texts.placeholder}
        aria-describedby="teacher-note-help"
        value={text.value}
        data-testid={TEST.noteText}
        onInput={(event) => {
          write(event.currentTarget.value);
        }}
      />
      <p class="note__help" id="teacher-note-help" role="status">
        {state.value === "saving" ? texts.saving : helpOf(note.value, changed, text.value.trim())}
      </p>
      <button
        type="submit"
        class="button button--run"
        disabled={!changed || !text.value.trim() || state.value === "saving"}
        data-testid={TEST.noteSave}
      >
        <Check class="icon" aria-hidden="true" />
        {note.value ? texts.change : texts.save}
      </button>
    </form>
  );
}

/** Whether it is kept, and whether the group has read it. */
function helpOf(note: Note | null, changed: boolean, text: string): string {
  const { saved, seen, unseen, help, draft } = words.value.note;
  if (changed && text) return draft;
  if (!note || changed) return help;
  const read = note.seen_at
    ? seen(when(note.seen_at, new Date(), language.value, texts.value))
    : unseen;
  return `${saved}. ${read}`;
}
