import { useLayoutEffect, useState } from "preact/hooks";
import { programAndGroups } from "../app/first_answers";
import { couldNotOpen, OpenProgram, opened, openings } from "../app/open_program";
import { group, program } from "../app/session";
import { texts } from "../i18n";
import { clear, live, liveRun } from "../run/live";
import { isLive } from "../run/reducer";
import { NotOpened } from "./NotOpened";
import { Studio } from "./Studio";

/** Opens a program and puts it on the desk. */
export function StudioScreen({ programId }: { programId: string }) {
  const [open, setOpen] = useState<OpenProgram | null>(null);
  const [failed, setFailed] = useState(false);
  // before the first paint: a group waits for its blocks, not for an empty frame
  useLayoutEffect(() => {
    let left = false;
    let made: OpenProgram | null = null;
    setOpen(null);
    load(programId).then(
      (loaded) => {
        if (left) return;
        made = new OpenProgram(loaded);
        opened.value = made;
        program.value = loaded;
        forgetOtherRun(programId);
        setOpen(made);
      },
      (error) => {
        if (left) return;
        setFailed(true);
        couldNotOpen(error);
      },
    );
    return () => {
      left = true;
      made?.close();
    };
  }, [programId, openings.value]);
  if (failed) return <NotOpened />;
  if (!open) {
    return (
      <main class="screen studio studio--opening" aria-busy="true">
        <p>{texts.value.studio.opening}</p>
      </main>
    );
  }
  return <Studio open={open} />;
}

async function load(programId: string) {
  const [loaded, groups] = await programAndGroups(programId);
  group.value = groups.find((one) => one.id === loaded.group_id) ?? null;
  return loaded;
}

/** The path on the floor belongs to the program that drove it. */
function forgetOtherRun(programId: string): void {
  if (!isLive(live.value) && liveRun.value?.program_id !== programId) clear();
}
