import { useEffect, useRef } from "preact/hooks";
import { listen } from "./listen";

interface Polling {
  everyMs?: number;
  isOn?: boolean;
  /**
   * Whether to poll while the page is hidden; otherwise `poll` is called once when the page is
   * shown again.
   */
  evenHidden?: boolean;
}

/** Calls `poll` periodically while the component is mounted; for the first time after `everyMs`. */
export function usePolling(
  poll: () => unknown,
  { everyMs = 3000, isOn = true, evenHidden = false }: Polling = {},
): void {
  const latest = useRef(poll);
  latest.current = poll;
  useEffect(() => {
    if (!isOn) return;
    const call = () => {
      if (evenHidden || !document.hidden) latest.current();
    };
    const timer = setInterval(call, everyMs);
    const unlisten = listen(document, evenHidden ? {} : { visibilitychange: call });
    return () => {
      clearInterval(timer);
      unlisten();
    };
  }, [everyMs, isOn, evenHidden]);
}
