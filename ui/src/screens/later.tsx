import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import { report } from "../app/session";

/** A part of the page whose code is not needed to begin with: it is fetched when the part is first shown. */
export function later<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
  let loaded: ComponentType<P> | null = null;
  return function Later(props: P) {
    const [, drawAgain] = useState(false);
    useEffect(() => {
      if (loaded) return;
      load().then((part) => {
        loaded = part;
        drawAgain(true);
      }, report);
    }, []);
    const Part = loaded;
    return Part ? <Part {...props} /> : null;
  };
}
