import { type Signal, useSignal } from "@preact/signals";
import type { Note } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { language, texts } from "../../../i18n";
import { relativeTime } from "../../../i18n/format";
import { report } from "../../../kit/report";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { draftOf, storeDraft } from "./note_draft";

export type NoteState = "unchanged" | "saving" | "saved" | "deleted";

/** A run's note: the sent one, and the edited text. */
export interface NoteEditor {
  readonly note: Signal<Note | null>;
  readonly text: Signal<string>;
  readonly state: Signal<NoteState>;
  readonly open: Signal<boolean>;
  /** Whether the text differs from the sent note. */
  readonly changed: boolean;
  /** The other PC on which the group works; null for this PC. */
  readonly otherComputer: string | null;
  write(text: string): void;
  save(): Promise<void>;
  remove(): Promise<void>;
}

/** `last`: the sent note. */
export function useNoteEditor(
  run: string,
  otherComputer: string | null,
  last: Note | null,
): NoteEditor {
  const draft = draftOf(run);
  const note = useSignal(last);
  const text = useSignal(draft ?? last?.text ?? "");
  const open = useSignal(last !== null || draft !== null);
  const state = useSignal<NoteState>("unchanged");
  const sentText = note.value?.text ?? "";
  const changed = text.value.trim() !== sentText;
  const write = (written: string) => {
    text.value = written;
    storeDraft(run, written.trim() === sentText ? null : written);
  };
  const act = async (work: () => Promise<Note | null>, done: NoteState, left = "") => {
    state.value = "saving";
    try {
      note.value = await asTeacher(work);
      text.value = note.value?.text ?? left;
      storeDraft(run, left || null);
      state.value = done;
    } catch (error) {
      state.value = "unchanged";
      report(error);
    }
  };
  const save = () => {
    const [known, newText] = [note.value, text.value.trim()];
    return act(
      () => (known ? reviewApi.rewriteNote(known.id, newText) : reviewApi.writeNote(run, newText)),
      "saved",
    );
  };
  const remove = async () => {
    const known = note.value;
    // unsent text stays in the field
    const left = changed ? text.value : "";
    if (known) await act(() => reviewApi.deleteNote(known.id).then(() => null), "deleted", left);
  };
  return { note, text, state, open, changed, otherComputer, write, save, remove };
}

/** Save state and read state of the note, as text. */
export function stateText({ note, text, state, changed, otherComputer }: NoteEditor): string {
  const { note: labels } = texts.value.review;
  const there = otherComputer && labels.there({ computer: otherComputer });
  if (state.value === "saving") return labels.saving;
  if (changed && text.value.trim()) return labels.draft;
  if (changed && note.value) return labels.emptied;
  if (state.value === "deleted") return labels.deleted;
  if (!note.value) return there ?? labels.help;
  const read = note.value.seen_at
    ? labels.seen({
        when: relativeTime(note.value.seen_at, new Date(), language.value, texts.value),
      })
    : (there ?? labels.unseen);
  return `${labels.saved}. ${read}`;
}
