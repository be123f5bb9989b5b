import { useInstance } from "../kit/instance";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { later } from "../shell/later";
import { program } from "../shell/session";
import { BlocksPane } from "./blocks_pane/BlocksPane";
import { FloorPane } from "./floor_pane/FloorPane";
import type { OpenProgram } from "./program/open_program";
import { StudioControl } from "./studio_control";

const WorldEditor = later(async () => (await import("../world_editor/WorldEditor")).WorldEditor);

/** The studio: blocks on the left, floor on the right. */
export function Studio({ open }: { open: OpenProgram }) {
  const control = useInstance(() => new StudioControl(open));
  const { worlds } = control;
  const store = worlds.store.value;
  return (
    <main class="screen studio">
      <h1 class="visually-hidden">{program.value?.name}</h1>
      <BlocksPane control={control} />
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
