import { useCallback, useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { useInstance } from "../instance";
import { listen } from "../listen";
import { type Ask, Load, type LoadOptions, type LoadState, type UNCHANGED } from "./load_state";

export interface LoadedOptions<T> extends LoadOptions<T> {
  /** Asked when the window is come back to while a value is shown; without it nothing is. */
  whenBack?: Ask<T | typeof UNCHANGED>;
  /** While a value is shown, another key is asked for when it has rested for so long. */
  quietMs?: number;
}

/** What a screen shows of something that is loaded. `again` resolves when the repeat has ended. */
export type Loadable<T> = LoadState<T> & { again(): Promise<void>; set(value: T): void };

/**
 * What a screen or a part of one loads. `key`: what it is about, one value or several; another key asks anew, and what
 * was there stays until the answer has come. The latest request wins; unmounting aborts. A failure is reported.
 */
export function useLoaded<T>(
  key: unknown,
  ask: Ask<T>,
  options: LoadedOptions<T> = {},
): Loadable<T> {
  const load = useInstance(() => new Load<T>());
  const latest = useRef({ ask, options });
  latest.current = { ask, options };
  load.options = options;
  const again = useCallback(() => load.ask((signal) => latest.current.ask(signal)), []);
  const set = useCallback((value: T) => load.set(value), []);
  // before the first paint: an answer that is there already is drawn at once
  useLayoutEffect(
    () => {
      const { quietMs = 0 } = latest.current.options;
      if (quietMs === 0 || load.state.peek().status !== "ready") return void again();
      const timer = setTimeout(again, quietMs);
      return () => clearTimeout(timer);
    },
    Array.isArray(key) ? key : [key],
  );
  useEffect(() => {
    const comeBack = () => {
      const { whenBack } = latest.current.options;
      const state = load.state.peek();
      if (whenBack && state.status === "ready" && !state.busy) void load.ask(whenBack);
    };
    return listen(window, { focus: comeBack });
  }, []);
  return { ...load.state.value, again, set };
}
