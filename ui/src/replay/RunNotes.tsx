import { Check, Mail } from "lucide-preact";
import type { Note } from "../api/model";
import { versionsApi } from "../api/versions";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { useLoaded } from "../kit/requests/useLoaded";

/** The teacher's notes about the replayed run. */
export function RunNotes({ runId }: { runId: string }) {
  const notes = useLoaded(runId, () => versionsApi.notesOfRun(runId));
  if (notes.status !== "ready" || notes.value.length === 0) return null;
  const { archive: labels } = texts.value;
  const acknowledge = async (note: Note) => {
    const updated = await versionsApi.acknowledgeNote(note.id);
    notes.set(notes.value.map((one) => (one.id === updated.id ? updated : one)));
  };
  return (
    <ul class="run-notes" aria-label={labels.noteFrom} data-scrolls>
      {notes.value.map((note) => (
        <li key={note.id} class="run-notes__note row middle gap-3" data-testid="note-card">
          <Mail class="icon" aria-hidden="true" />
          <p>
            <strong>{labels.noteFrom}:</strong> {note.text}
          </p>
          {note.seen_at === null && (
            <Button icon={Check} testId="note-seen" onPress={() => acknowledge(note)}>
              {labels.noteSeen}
            </Button>
          )}
        </li>
      ))}
    </ul>
  );
}
