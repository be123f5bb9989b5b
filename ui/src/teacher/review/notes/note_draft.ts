const key = (run: string) => `pinel_note_${run}`;

/** The unsent text of a note about a run; stored until the window closes. */
export function draftOf(run: string): string | null {
  return sessionStorage.getItem(key(run));
}

/** Stores the draft; a `text` of null deletes it. */
export function storeDraft(run: string, text: string | null): void {
  if (text) sessionStorage.setItem(key(run), text);
  else sessionStorage.removeItem(key(run));
}
