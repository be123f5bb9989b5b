import { useEffect, useRef } from "preact/hooks";
import { listen } from "./listen";

interface Polling {
  everyMs?: number;
  isOn?: boolean;
  /** Goes on while the page is hidden; otherwise `look` is called once it is shown again. */
  evenHidden?: boolean;
}

/** Calls `look` again and again while the component is there. The first call is after `everyMs`. */
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
