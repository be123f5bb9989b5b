import { useEffect } from "preact/hooks";
import { useInstance } from "../kit/instance";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { TOUR_OVER, tourFor, tourSteps } from "../shell/help";
import { lazy } from "../shell/lazy";
import { group, program } from "../shell/session";
import { BlocksPane } from "./blocks_pane/BlocksPane";
import { FloorPane } from "./floor_pane/FloorPane";
import type { OpenProgram } from "./program/open_program";
import { Splitter } from "./Splitter";
import { shownPart } from "./split";
import { StudioControl } from "./studio_control";

const TourBalloon = lazy(async () => (await import("./tour/TourBalloon")).TourBalloon);
const WorldEditor = lazy(async () => (await import("../world_editor/WorldEditor")).WorldEditor);

/** The studio: blocks on the left, floor on the right. */
export function Studio({ open }: { open: OpenProgram }) {
  const control = useInstance(() => new StudioControl(open));
  useTour(open);
  const { worlds } = control;
  const store = worlds.store.value;
  return (
    <main class="screen studio" style={{ "--blocks-part": `${shownPart()}%` }}>
      <h1 class="visually-hidden">{program.value?.name}</h1>
      {tourFor.value === open.id && <TourBalloon control={control} />}
      <BlocksPane control={control} />
      <Splitter />
      <FloorPane control={control} />
      {store && (
        <WorldEditor
          store={store}
          replaces={worlds.replaces.value}
          onOwn={() => worlds.editOwn()}
          onForget={open.ownWorld.now.value ? () => worlds.forget() : null}
          onStop={isLive(robot.live.value) ? () => control.stop() : null}
          onDone={() => worlds.done()}
        />
      )}
    </main>
  );
}

/** Offers the guided first drive once to a group without work; resumes it after a reload of the page. */
function useTour(open: OpenProgram): void {
  useEffect(() => {
    const { id, group_id } = open.program;
    const storedStep = tourSteps.of(group_id);
    const isDue = storedStep === null ? isNew(open) : storedStep !== TOUR_OVER;
    if (isDue && !open.mission.peek()) tourFor.value = id;
    return () => {
      if (tourFor.peek() === id) tourFor.value = null;
    };
  }, []);
}

function isNew({ program: { version } }: OpenProgram): boolean {
  const { n_programs = 0, n_in_bin = 0, n_runs = 0 } = group.peek() ?? {};
  return n_programs <= 1 && n_in_bin === 0 && n_runs === 0 && !version;
}
