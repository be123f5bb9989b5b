import { useSignal } from "@preact/signals";
import type { OpenProgram } from "../app/open_program";
import { program } from "../app/session";
import { BlocksPane } from "./BlocksPane";
import { FloorPane } from "./FloorPane";
import { StudioControl } from "./studio_control";

/** Blocks on the left, the floor on the right. */
export function Studio({ open }: { open: OpenProgram }) {
  const control = useSignal(new StudioControl(open)).peek();
  return (
    <main class="screen studio">
      <h1 class="visually-hidden">{program.value?.name}</h1>
      <BlocksPane control={control} />
      <FloorPane control={control} />
    </main>
  );
}
