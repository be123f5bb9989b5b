import { useSignal } from "@preact/signals";
import type { OpenProgram } from "../app/open_program";
import { program } from "../app/session";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { BlocksPane } from "./BlocksPane";
import { FloorPane } from "./FloorPane";
import { later } from "./later";
import { StudioControl } from "./studio_control";

const WorldEditor = later(async () => (await import("../world_editor/WorldEditor")).WorldEditor);

/** Blocks on the left, the floor on the right. */
export function Studio({ open }: { open: OpenProgram }) {
  const control = useSignal(new StudioControl(open)).peek();
  const { worlds } = control;
  const desk = worlds.desk.value;
  return (
    <main class="screen studio">
      <h1 class="visually-hidden">{program.value?.name}</h1>
      <BlocksPane control={control} />
      <FloorPane control={control} />
      {desk && (
        <WorldEditor
          desk={desk}
          replaces={worlds.replaces.value}
          onOwn={() => worlds.editOwn()}
          onForget={open.ownWorld.now.value ? () => worlds.forget() : null}
          onStop={isLive(robot.live.value) ? () => control.send(robot.stop) : null}
          onDone={() => worlds.done()}
        />
      )}
    </main>
  );
}
