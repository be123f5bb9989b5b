import { effect } from "@preact/signals";
import { api } from "../api/client";
import type { EditorStore } from "./editor_store";

/** Delay between the last change and the request to the server, milliseconds. */
const DEBOUNCE_MS = 150;

/** Lets the server check the document after each change; stores the faults. Returns the unsubscribe function. */
export function checkOnChange(store: EditorStore, onTrouble: (error: unknown) => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ask = async () => {
    const document = store.document.peek();
    try {
      const faults = await api.checkWorld(document);
      if (document === store.document.peek()) store.faults.value = faults;
    } catch (error) {
      onTrouble(error);
    }
  };
  const stop = effect(() => {
    store.document.value;
    clearTimeout(timer);
    timer = setTimeout(() => void ask(), DEBOUNCE_MS);
  });
  return () => {
    clearTimeout(timer);
    stop();
  };
}
