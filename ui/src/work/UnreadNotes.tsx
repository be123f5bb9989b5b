import { Check, Mail, Play } from "lucide-preact";
import type { Note } from "../api/model";
import { versionsApi } from "../api/versions";
import { language, texts } from "../i18n";
import { relativeTime } from "../i18n/format";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { useLoaded } from "../kit/requests/useLoaded";
import { hashOf } from "../shell/route";

/** The unread notes of the teacher; renders nothing without any. */
export function UnreadNotes({ groupId }: { groupId: string }) {
  const notes = useLoaded(groupId, () => versionsApi.unseenNotes(groupId));
  if (notes.status !== "ready" || notes.value.length === 0) return null;
  const { value: unseen } = notes;
  const acknowledge = async (note: Note) => {
    await versionsApi.acknowledgeNote(note.id);
    notes.set(unseen.filter(({ id }) => id !== note.id));
  };
  return (
    <ul class="grid gap-3">
      {unseen.map((note) => (
        <li key={note.id}>
          <Letter note={note} onAcknowledge={() => acknowledge(note)} />
        </li>
      ))}
    </ul>
  );
}

function Letter({ note, onAcknowledge }: { note: Note; onAcknowledge(): Promise<void> }) {
  const { archive: labels, work } = texts.value;
  const about = labels.noteAbout({ program: note.program_name ?? work.noName });
  const written = relativeTime(note.written_at, new Date(), language.value, texts.value);
  return (
    <article class="letter card" data-testid="note-card">
      <Mail class="icon letter__icon" aria-hidden="true" />
      <div class="letter__words">
        <h2 class="letter__from">{labels.noteFrom}</h2>
        <p class="letter__text">{note.text}</p>
        <p class="aside">
          {about} · {written}
        </p>
      </div>
      <div class="row wrap gap-2">
        <LinkButton
          icon={Play}
          href={hashOf({ screen: "replay", run: note.run_id })}
          testId="note-run"
        >
          {labels.noteSeeRun}
        </LinkButton>
        <Button kind="main" icon={Check} testId="note-seen" onPress={onAcknowledge}>
          {labels.noteSeen}
        </Button>
      </div>
    </article>
  );
}
