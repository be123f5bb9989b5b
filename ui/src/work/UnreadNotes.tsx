import { useSignal } from "@preact/signals";
import { Check, Mail, Play } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { keeping, type Note } from "../api/keeping";
import { hashOf } from "../app/route";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";

/** What the teacher wrote and the group has not read yet, as letters; nothing while there are none. */
export function Letters({ groupId }: { groupId: string }) {
  const notes = useSignal<Note[]>([]);
  useEffect(() => {
    keeping.unseenNotes(groupId).then((unseen) => {
      notes.value = unseen;
    }, report);
  }, [groupId]);
  if (notes.value.length === 0) return null;
  const seen = async (note: Note) => {
    await keeping.seeNote(note.id);
    notes.value = notes.value.filter(({ id }) => id !== note.id);
  };
  return (
    <ul class="letters">
      {notes.value.map((note) => (
        <li key={note.id}>
          <Letter note={note} onSeen={() => void seen(note).catch(report)} />
        </li>
      ))}
    </ul>
  );
}

function Letter({ note, onSeen }: { note: Note; onSeen(): void }) {
  const { keeping: words, work } = texts.value;
  const about = words.noteAbout(note.program_name ?? work.noName);
  const written = when(note.written_at, new Date(), language.value, texts.value);
  return (
    <article class="letter card" data-testid={TEST.noteCard}>
      <Mail class="icon letter__icon" aria-hidden="true" />
      <div class="letter__words">
        <h2 class="letter__from">{words.noteFrom}</h2>
        <p class="letter__text">{note.text}</p>
        <p class="letter__about">
          {about} · {written}
        </p>
      </div>
      <div class="letter__acts">
        <a
          class="button"
          href={hashOf({ screen: "replay", run: note.run_id })}
          data-testid={TEST.noteRun}
        >
          <Play class="icon" aria-hidden="true" />
          {words.noteSeeRun}
        </a>
        <button
          type="button"
          class="button button--run"
          data-testid={TEST.noteSeen}
          onClick={onSeen}
        >
          <Check class="icon" aria-hidden="true" />
          {words.noteSeen}
        </button>
      </div>
    </article>
  );
}
