type EventMap = WindowEventMap & Pick<DocumentEventMap, "visibilitychange">;
type Listeners = { readonly [Type in keyof EventMap]?: (event: EventMap[Type]) => unknown };

/** Adds listeners to a target. Returns the function that removes all of them. */
export function listen(
  target: EventTarget,
  listeners: Listeners,
  options: { capture?: boolean; passive?: boolean } = {},
): () => void {
  const ended = new AbortController();
  for (const [type, act] of Object.entries(listeners)) {
    target.addEventListener(type, act as EventListener, { ...options, signal: ended.signal });
  }
  return () => ended.abort();
}

/**
 * Handles keys of the whole page, unless Ctrl, Alt or Meta is pressed or the focused element uses
 * keys itself. If `act` returns true, the key has no other effect.
 */
export function listenForKeys(act: (key: string) => boolean): () => void {
  return listen(window, {
    keydown: (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if ((event.target as Element).closest?.("input, select, textarea, .injectionDiv")) return;
      if (act(event.key)) event.preventDefault();
    },
  });
}
