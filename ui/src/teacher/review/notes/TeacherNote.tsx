import { StickyNote } from "lucide-preact";
import type { Note } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Loaded } from "../../../kit/requests/Loaded";
import { useLoaded } from "../../../kit/requests/useLoaded";
import { NoteForm } from "./NoteForm";
import { useNoteEditor } from "./note_editor";

interface TeacherNoteProps {
  run: string;
  /** The other PC on which the run took place; null for this PC. */
  otherComputer: string | null;
}

/** Editor of the teacher's note about a run. The group reads it when it next opens its work on a PC that has it. */
export function TeacherNote({ run, otherComputer }: TeacherNoteProps) {
  const notes = useLoaded(run, () => reviewApi.notes(run));
  return (
    <Loaded of={notes}>
      {(found) => (
        <LastNote key={run} run={run} otherComputer={otherComputer} last={found.at(-1) ?? null} />
      )}
    </Loaded>
  );
}

interface LastNoteProps extends TeacherNoteProps {
  last: Note | null;
}

function LastNote({ run, otherComputer, last }: LastNoteProps) {
  const { note: labels } = texts.value.review;
  const editor = useNoteEditor(run, otherComputer, last);
  const { open, text, changed } = editor;
  const show = () => {
    open.value = true;
  };
  if (open.value) return <NoteForm editor={editor} />;
  return (
    <div class="note note--shut">
      <Button icon={StickyNote} testId="note-open" onPress={show}>
        {changed && text.value.trim() ? labels.unsent : labels.title}
      </Button>
    </div>
  );
}
