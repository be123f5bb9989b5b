import { type Signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Note } from "../api/model";
import { reviewApi } from "../api/review";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { draftOf, keepDraft } from "./note_draft";

export type NoteState = "unchanged" | "saving" | "saved" | "deleted";

/** A run's note: what the group has, and what is written of the next one. */
export interface NoteKeeping {
  readonly note: Signal<Note | null>;
  readonly text: Signal<string>;
  readonly state: Signal<NoteState>;
  readonly open: Signal<boolean>;
  /** Whether what is written is not what the group has. */
  readonly changed: boolean;
  write(text: string): void;
  save(): Promise<void>;
  takeBack(): Promise<void>;
}

export function useNote(run: string): NoteKeeping {
  const note = useSignal<Note | null>(null);
  const text = useSignal("");
  const open = useSignal(false);
  const state = useSignal<NoteState>("unchanged");

  useEffect(() => {
    reviewApi.notes(run).then((found) => {
      const draft = draftOf(run);
      note.value = found.at(-1) ?? null;
      text.value = draft ?? note.value?.text ?? "";
      open.value = note.value !== null || draft !== null;
    }, report);
  }, [run]);

  const kept = note.value?.text ?? "";
  const write = (written: string) => {
    text.value = written;
    keepDraft(run, written.trim() === kept ? null : written);
  };
  /** Where the door has shut meanwhile, the page asks for the PIN and this goes on. */
  const act = async (work: () => Promise<Note | null>, done: NoteState, left = "") => {
    state.value = "saving";
    try {
      note.value = await asTeacher(work);
      text.value = note.value?.text ?? left;
      keepDraft(run, left || null);
      state.value = done;
    } catch (error) {
      state.value = "unchanged";
      report(error);
    }
  };
  const save = () => {
    const [known, wanted] = [note.value, text.value.trim()];
    return act(
      () => (known ? reviewApi.rewriteNote(known.id, wanted) : reviewApi.writeNote(run, wanted)),
      "saved",
    );
  };
  const changed = text.value.trim() !== kept;
  const takeBack = async () => {
    const known = note.value;
    // what the group never got is not taken back
    const left = changed ? text.value : "";
    if (known) await act(() => reviewApi.deleteNote(known.id).then(() => null), "deleted", left);
  };
  return { note, text, state, open, changed, write, save, takeBack };
}
