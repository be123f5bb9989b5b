import { useEffect } from "preact/hooks";
import { useInstance } from "../kit/instance";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { tourFor } from "../shell/help";
import { lazy } from "../shell/lazy";
import { program } from "../shell/session";
import { BlocksPane } from "./blocks_pane/BlocksPane";
import { FloorPane } from "./floor_pane/FloorPane";
import type { OpenProgram } from "./program/open_program";
import { Splitter } from "./Splitter";
import { shownPart } from "./split";
import { StudioControl } from "./studio_control";
import { isTourDue } from "./tour/due";

const TourBalloon = lazy(async () => (await import("./tour/TourBalloon")).TourBalloon);
const WorldEditor = lazy(async () => (await import("../world_editor/WorldEditor")).WorldEditor);

/** The studio: blocks on the left, floor on the right. */
export function Studio({ open }: { open: OpenProgram }) {
  const control = useInstance(() => new StudioControl(open));
  useTour(control);
  const { worlds } = control;
  const store = worlds.store.value;
  return (
    <main class="screen studio" style={{ "--blocks-part": `${shownPart()}%` }}>
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
      <h1 class="visually-hidden">{program.value?.name}</h1>
      {tourFor.value === open.id && <TourBalloon control={control} />}
      <BlocksPane control={control} />
      <Splitter />
      <FloorPane control={control} />
    </main>
  );
}

/**
 * Offers the guided first drive to a group to which it is due; resumes it after a reload of the page. In a mission that
 * is not begun, the button of its sheet begins it.
 */
function useTour({ open, missionSheet }: StudioControl): void {
  useEffect(() => {
    const { id } = open.program;
    const isStarted = !open.mission.peek() || !missionSheet.isOpen.peek();
    if (isStarted && isTourDue(open)) tourFor.value = id;
    return () => {
      if (tourFor.peek() === id) tourFor.value = null;
    };
  }, []);
}
