import { Check, Mail, Play } from "lucide-preact";
import type { Note } from "../api/model";
import { versionsApi } from "../api/versions";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { useLoaded } from "../kit/requests/useLoaded";
import { hashOf } from "../shell/route";

/** The unread notes of the teacher; renders nothing without any. */
export function UnreadNotes({ groupId }: { groupId: string }) {
  const notes = useLoaded(groupId, () => versionsApi.unseenNotes(groupId));
  if (notes.status !== "ready" || notes.value.length === 0) return null;
  const { value: unseen } = notes;
  const seen = async (note: Note) => {
    await versionsApi.seeNote(note.id);
    notes.set(unseen.filter(({ id }) => id !== note.id));
  };
  return (
    <ul class="grid gap-3">
      {unseen.map((note) => (
        <li key={note.id}>
          <Letter note={note} onSeen={() => seen(note)} />
        </li>
      ))}
    </ul>
  );
}

function Letter({ note, onSeen }: { note: Note; onSeen(): Promise<void> }) {
  const { keeping: words, work } = texts.value;
  const about = words.noteAbout(note.program_name ?? work.noName);
  const written = when(note.written_at, new Date(), language.value, texts.value);
  return (
    <article class="letter card" data-testid="note-card">
      <Mail class="icon letter__icon" aria-hidden="true" />
      <div class="letter__words">
        <h2 class="letter__from">{words.noteFrom}</h2>
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
          {words.noteSeeRun}
        </LinkButton>
        <Button kind="main" icon={Check} testId="note-seen" onPress={onSeen}>
          {words.noteSeen}
        </Button>
      </div>
    </article>
  );
}
