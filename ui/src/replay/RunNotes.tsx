import { useSignal } from "@preact/signals";
import { Check, Mail } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { keeping, type Note } from "../api/keeping";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

/** What the teacher wrote about the run that is replayed. */
export function RunNotes({ runId }: { runId: string }) {
  const notes = useSignal<Note[]>([]);
  useEffect(() => {
    keeping.notesOfRun(runId).then((found) => {
      notes.value = found;
    }, report);
  }, [runId]);
  if (notes.value.length === 0) return null;
  const { keeping: words } = texts.value;
  const see = async (note: Note) => {
    const seen = await keeping.seeNote(note.id);
    notes.value = notes.value.map((one) => (one.id === seen.id ? seen : one));
  };
  return (
    <ul class="run-notes" aria-label={words.noteFrom} data-scrolls>
      {notes.value.map((note) => (
        <li key={note.id} class="run-notes__note" data-testid={TEST.noteCard}>
          <Mail class="icon" aria-hidden="true" />
          <p>
            <strong>{words.noteFrom}:</strong> {note.text}
          </p>
          {note.seen_at === null && (
            <button
              type="button"
              class="button"
              data-testid={TEST.noteSeen}
              onClick={() => void see(note).catch(report)}
            >
              <Check class="icon" aria-hidden="true" />
              {words.noteSeen}
            </button>
          )}
        </li>
      ))}
    </ul>
  );
}
