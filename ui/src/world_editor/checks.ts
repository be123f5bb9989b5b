import { effect } from "@preact/signals";
import { api } from "../api/client";
import type { WorldDesk } from "./desk";

/** So long after the last change the server is asked, milliseconds. */
const QUIET_MS = 150;

/** Keeps the faults of the plan on the table beside it; the answer ends that. */
export function keepChecked(desk: WorldDesk, onTrouble: (error: unknown) => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ask = async () => {
    const document = desk.document.peek();
    try {
      const faults = await api.checkWorld(document);
      if (document === desk.document.peek()) desk.faults.value = faults;
    } catch (error) {
      onTrouble(error);
    }
  };
  const stop = effect(() => {
    desk.document.value;
    clearTimeout(timer);
    timer = setTimeout(() => void ask(), QUIET_MS);
  });
  return () => {
    clearTimeout(timer);
    stop();
  };
}
