const key = (run: string) => `pinel_note_${run}`;

/** What the teacher has written about a run and not given to the group: it outlives a walk to another page, though not the window. */
export function draftOf(run: string): string | null {
  return sessionStorage.getItem(key(run));
}

/** Null where there is nothing that the group has not got. */
export function keepDraft(run: string, text: string | null): void {
  if (text) sessionStorage.setItem(key(run), text);
  else sessionStorage.removeItem(key(run));
}
